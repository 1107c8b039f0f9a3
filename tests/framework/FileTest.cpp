#include "framework/system/File.h"
#include "framework/support/Error.h"
#include "framework/system/Memory.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace mrpp
{
namespace
{

namespace fs = std::filesystem;

class File : public ::testing::Test
{
protected:
    File()
    {
        std::string name = (fs::temp_directory_path() / "mrpp-file-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    ~File() override { fs::remove_all(folder_); }

    [[nodiscard]] std::size_t filesInFolder() const
    {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    template <class Action>
    static std::string complaintOf(Action &&action)
    {
        try
        {
            action();
        }
        catch (const FileError &error)
        {
            return error.complaint();
        }
        return "no error";
    }

    fs::path folder_;
};

TEST_F(File, HasTheRightsThatTheUmaskLeaves)
{
    const auto rightsUnder = [this](mode_t mask)
    {
        const mode_t before = ::umask(mask);
        writeFile(folder_ / "x", "x");
        ::umask(before);
        return fs::status(folder_ / "x").permissions();
    };
    EXPECT_EQ(rightsUnder(077), fs::perms(0600));
    EXPECT_EQ(rightsUnder(022), fs::perms(0644));
    EXPECT_EQ(rightsUnder(002), fs::perms(0664));
}

TEST_F(File, MayHaveTheLongestName)
{
    std::string name;
    for (int i = 0; i < 127; ++i)
        name += "\u00e9"; // two bytes
    name += "x";
    ASSERT_EQ(name.size(), 255U);
    writeFile(folder_ / name, "x");
    EXPECT_EQ(readFile(folder_ / name), "x");
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(File, IsReadBackByteByByte)
{
    const std::string bytes("a\0b\r\n\xff", 6);
    writeFile(folder_ / "x", bytes);
    EXPECT_EQ(readFile(folder_ / "x"), bytes);
    writeFile(folder_ / "x", "");
    EXPECT_EQ(readFile(folder_ / "x"), "");
    EXPECT_EQ(filesInFolder(), 1U) << "nothing temporary stays behind";
}

TEST_F(File, MakesMissingFoldersAndCanBeReadByAll)
{
    writeFile(folder_ / "a" / "b" / "x", "text");
    EXPECT_EQ(readFile(folder_ / "a" / "b" / "x"), "text");
    EXPECT_EQ(fs::status(folder_ / "a" / "b" / "x").permissions(), static_cast<fs::perms>(0644));
}

TEST_F(File, SaysWhyItCannotBeRead)
{
    EXPECT_EQ(complaintOf([&] { (void)readFile(folder_ / "none"); }), "there is no such file");
    EXPECT_EQ(complaintOf([&] { (void)readFile(folder_); }), "is a folder, but a file is needed");
    try
    {
        (void)readFile(folder_ / "none");
        FAIL();
    }
    catch (const FileError &error)
    {
        EXPECT_EQ(error.where().file, (folder_ / "none").string());
    }
}

TEST_F(File, IsNotWrittenWhereItsFolderIsAFile)
{
    writeFile(folder_ / "x", "old");
    EXPECT_EQ(complaintOf([&] { writeFile(folder_ / "x" / "y", "new"); }),
              "cannot be written (create): Not a directory");
    EXPECT_EQ(readFile(folder_ / "x"), "old");
}

TEST_F(File, DoesNotReplaceAFolder)
{
    fs::create_directory(folder_ / "sub");
    EXPECT_EQ(complaintOf([&] { writeFile(folder_ / "sub", "text"); }), "cannot be written: it is a folder");
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(File, APipeIsWrittenToAndStaysAPipe)
{
    const auto pipe = folder_ / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::string received;
    {
        const std::jthread reader([&] { received = readFile(pipe); });
        writeFile(pipe, "through the pipe");
    }
    EXPECT_EQ(received, "through the pipe");
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(File, ANameForWhatIsOpenIsWrittenToAndStaysThatName)
{
    const int open = ::open((folder_ / "file").c_str(), O_WRONLY | O_CREAT, 0600);
    ASSERT_GE(open, 0);
    const std::string name = "/proc/self/fd/" + std::to_string(open);
    std::filesystem::create_symlink(name, folder_ / "link");
    writeFile(folder_ / "link", "as /dev/stdout");
    ::close(open);
    EXPECT_EQ(readFile(folder_ / "file"), "as /dev/stdout");
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link"));
}

TEST_F(File, IsNotWrittenIntoAFolderThatForbidsIt)
{
    if (::geteuid() == 0)
        GTEST_SKIP() << "nothing is forbidden to root";
    fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(complaintOf([&] { writeFile(folder_ / "x", "text"); }),
              "cannot be written (create): Permission denied");
    fs::permissions(folder_, fs::perms::owner_all);
}

TEST_F(File, AFailingWriteLeavesTheOldFile)
{
    writeFile(folder_ / "x", "old");
    struct rlimit before = {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    struct rlimit tight = before;
    tight.rlim_cur = 1000;
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    const std::string complaint = complaintOf([&] { writeFile(folder_ / "x", std::string(5000, 'n')); });
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(complaint, "cannot be written (write): File too large");
    EXPECT_EQ(readFile(folder_ / "x"), "old");
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST(Memory, PeakGrowsWithWhatIsTouched)
{
    if (!resetPeakMemory())
        GTEST_SKIP() << "the system does not let a process reset its peak";
    const double before = peakMemory();
    EXPECT_GT(before, 1);
    {
        const std::vector<char> block(64'000'000, 1);
        EXPECT_EQ(block.back(), 1);
    }
    EXPECT_GT(peakMemory(), before + 50);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // they keep what was freed
    EXPECT_TRUE(resetPeakMemory());
    EXPECT_LT(peakMemory(), before + 50) << "the peak is forgotten";
#endif
}

TEST_F(File, PiecesAreOneFileOnceCommitted)
{
    writeFile(folder_ / "x", "old");
    {
        FileWriter dropped(folder_ / "x");
        dropped.write("half");
    }
    EXPECT_EQ(readFile(folder_ / "x"), "old");
    FileWriter writer(folder_ / "x");
    writer.write("one, ");
    writer.write("two");
    EXPECT_EQ(readFile(folder_ / "x"), "old");
    writer.commit();
    EXPECT_EQ(readFile(folder_ / "x"), "one, two");
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(File, ASetOfFilesIsWrittenAsAWholeOrNotAtAll)
{
    const auto writeBoth = [this](const fs::path &second)
    {
        FileSet files;
        files.add(folder_ / "x").write("1");
        files.add(second).write("2");
        files.commit();
    };
    writeFile(folder_ / "x", "old");
    fs::create_directory(folder_ / "folder");
    EXPECT_THROW(writeBoth(folder_ / "folder"), FileError);
    EXPECT_THROW(writeBoth(folder_ / "x" / "y"), FileError);
    EXPECT_THROW(writeBoth(folder_ / "folder/../x"), FileError) << "the same file twice";
    EXPECT_EQ(readFile(folder_ / "x"), "old");
    EXPECT_EQ(filesInFolder(), 2U) << "nothing is left behind";

    writeBoth(folder_ / "y");
    EXPECT_EQ(readFile(folder_ / "x"), "1");
    EXPECT_EQ(readFile(folder_ / "y"), "2");
}

} // namespace
} // namespace mrpp
