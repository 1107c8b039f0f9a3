#include "framework/system/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

namespace mrpp
{
namespace
{

namespace fs = std::filesystem;

/// A child process with TMPDIR somewhere of its own.
class TemporaryFolders : public testing::Test
{
protected:
    TemporaryFolders()
    {
        std::string name = (fs::temp_directory_path() / "mrpp-tmp-XXXXXX").string();
        parent_ = ::mkdtemp(name.data());
        ::setenv("TMPDIR", parent_.c_str(), 1);
    }
    ~TemporaryFolders() override
    {
        ::unsetenv("TMPDIR");
        fs::remove_all(parent_);
    }
    [[nodiscard]] std::size_t count() const
    {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(parent_), fs::directory_iterator()));
    }
    fs::path parent_;
};

TEST_F(TemporaryFolders, OfTheLivingStayAndOfTheKilledGo)
{
    const pid_t child = ::fork();
    if (child == 0)
    {
        const TemporaryFolder folder;
        std::ofstream(folder.path() / "half") << "an answer";
        fs::create_directory(folder.path() / "sealed");
        fs::permissions(folder.path() / "sealed", fs::perms::none);
        for (;;)
            ::pause();
    }
    const auto sealed = [this]
    {
        for (const auto &entry : fs::directory_iterator(parent_))
            if (fs::exists(entry.path() / "sealed"))
                return true;
        return false;
    };
    while (!sealed())
        ::usleep(1000);
    {
        const TemporaryFolder mine;
        removeStaleTemporaryFolders();
        EXPECT_EQ(count(), 2U);
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        removeStaleTemporaryFolders();
        EXPECT_EQ(count(), 1U);
        EXPECT_TRUE(fs::exists(mine.path()));
    }
    EXPECT_EQ(count(), 0U);
}

TEST_F(TemporaryFolders, OfOthersAreNotTouched)
{
    fs::create_directory(parent_ / "mrppsim-backup"); // as long as ours
    fs::create_directory(parent_ / "mrppsim-mine");
    removeStaleTemporaryFolders();
    EXPECT_EQ(count(), 2U);
}

TEST_F(TemporaryFolders, AreAbsoluteWhateverTMPDIRSays)
{
    const fs::path before = fs::current_path();
    fs::current_path(parent_.parent_path());
    ::setenv("TMPDIR", parent_.filename().c_str(), 1);
    const TemporaryFolder folder;
    fs::current_path(before);
    EXPECT_TRUE(folder.path().is_absolute());
    EXPECT_TRUE(fs::exists(folder.path()));
}

} // namespace
} // namespace mrpp
