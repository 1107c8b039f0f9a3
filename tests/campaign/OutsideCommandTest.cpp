#include "framework/outside/OutsideCommand.h"

#include "framework/outside/WorkingFolder.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::string asPath(const std::string &place)
{
    return "<" + place + ">";
}

TEST(OutsideCommand, isSplitAsAShellSplits)
{
    EXPECT_THAT(splitCommand("./a  b\tc\nd"), ElementsAre("./a", "b", "c", "d"));
    EXPECT_THAT(splitCommand("a 'b c' \"d e\" f\\ g ''"), ElementsAre("a", "b c", "d e", "f g", ""));
    EXPECT_THAT(splitCommand("a'b'\"c\"d"), ElementsAre("abcd"));
    EXPECT_THAT(splitCommand(R"(a '\n' "\n" "\"\\\$" \n)"), ElementsAre("a", "\\n", "\\n", "\"\\$", "n"));
    EXPECT_THROW((void)splitCommand("a 'b"), InputError);
    EXPECT_THROW((void)splitCommand("a \"b"), InputError);
    EXPECT_THROW((void)splitCommand(" \n"), InputError);
}

TEST(OutsideCommand, joinsLinesAtABackslash)
{
    EXPECT_THAT(splitCommand("./good.sh {graph} \\\n  {instance} \\\n  {output}\n"),
                ElementsAre("./good.sh", "{graph}", "{instance}", "{output}"));
    EXPECT_THAT(splitCommand("a b\\\nc"), ElementsAre("a", "bc"));
    EXPECT_THAT(splitCommand("a \\\r\n  b"), ElementsAre("a", "b"));
    EXPECT_THAT(splitCommand("a \"b\\\nc\""), ElementsAre("a", "bc"));
    EXPECT_THAT(splitCommand("a 'b\\\nc'"), ElementsAre("a", "b\\\nc"));
}

TEST(OutsideCommand, tellsPlacesFromTextThatLooksLikeThem)
{
    const std::vector<std::string> words = {"a",        "{map}",        "x{b_2}y{map}", "{{map}}",
                                            "{Output}", "{time-limit}", "{ output }",   "${HOME}"};
    EXPECT_THAT(placesIn(words), ElementsAre("map", "b_2"));
    EXPECT_THAT(doubtfulPlacesIn(words), ElementsAre("Output", "time-limit", " output "));
    const std::vector<std::string> texts = {"{print $1}", "{\"a\": 1}", "{}",
                                            "{1,2}",      "{ print }",  "{-1}",
                                            "{0.5}",      "{{Output}}", "{{time-limit}}"};
    EXPECT_THAT(placesIn(texts), IsEmpty());
    EXPECT_THAT(doubtfulPlacesIn(texts), IsEmpty());
    EXPECT_EQ(fillPlaces("-o{output}.{{Output}}{x}", asPath), "-o<output>.{Output}<x>");
    EXPECT_EQ(fillPlaces("{print $1} ${HOME}", asPath), "{print $1} ${HOME}");
    EXPECT_EQ(asPlaceName(" Time-Limit "), "time_limit");
}

class CommandFilesTest : public testing::Test
{
protected:
    CommandFilesTest()
    {
        for (const char *file : {"conf.txt", "a,b.txt", "run.sh", "sub/model.bin"})
            writeFile(folder() / file, file);
        writeFile(folder_.path() / "beside.txt", "");
    }
    [[nodiscard]] std::filesystem::path folder() const { return folder_.path() / "plan"; }

    [[nodiscard]] std::vector<std::string>
    named(const std::vector<std::string> &words,
          const std::vector<std::pair<std::string, std::string>> &values = {}) const
    {
        OutsideCommand command{.words = words};
        command.folder = folder();
        std::vector<std::string> names;
        for (const CommandFile &file : filesOf(command, values))
            names.push_back(file.name);
        return names;
    }

private:
    TemporaryFolder folder_;
};

TEST_F(CommandFilesTest, areFoundInEveryFormOfAWord)
{
    EXPECT_THAT(named({"./run.sh", "conf.txt"}), ElementsAre("run.sh", "conf.txt"));
    for (const char *word :
         {"--config=conf.txt", "-fconf.txt", "-f=conf.txt", "@conf.txt", "file:conf.txt", "x,conf.txt,y",
          "./conf.txt", "cat <conf.txt >&2", "'conf.txt'", "sub/../conf.txt"})
        EXPECT_THAT(named({"sh", word}), ElementsAre("conf.txt")) << word;
    EXPECT_THAT(named({"sh", "--m=a,b.txt"}), ElementsAre("a,b.txt"));
    EXPECT_THAT(named({"sh", "--model", "sub/model.bin"}), ElementsAre("sub/model.bin"));
    EXPECT_THAT(named({"sh", "../beside.txt"}), ElementsAre("../beside.txt"));
    EXPECT_THAT(named({"sh", "-c", "./run.sh conf.txt; true"}), ElementsAre("run.sh", "conf.txt"));
    EXPECT_THAT(named({"sh", "conf", "sub", "-f", "conf.txt2"}), IsEmpty());
    EXPECT_THAT(named({"conf.txt", "{instance}"}), IsEmpty()) << "looked up in PATH";
}

TEST_F(CommandFilesTest, areFoundInValuesOfPlaces)
{
    EXPECT_THAT(named({"sh", "{config}"}, {{"config", "conf.txt"}}), ElementsAre("conf.txt"));
    EXPECT_THAT(named({"sh", "--in={graph},{config}"}, {{"config", "conf.txt"}}), ElementsAre("conf.txt"));
    EXPECT_THAT(named({"sh", "{stem}.txt"}, {{"stem", "conf"}}), ElementsAre("conf.txt"));
    EXPECT_THAT(named({"sh", "{config}"}, {{"config", "{x}"}}), IsEmpty());
}

TEST_F(CommandFilesTest, haveThoseOfThePlanWhetherTheyAreThereOrNot)
{
    OutsideCommand command{.words = {"sh", "conf.txt"}};
    command.files = {"gone.txt", "conf.txt"};
    command.folder = folder();
    std::vector<std::string> names;
    for (const CommandFile &file : filesOf(command, {}))
        names.push_back(file.name);
    EXPECT_THAT(names, ElementsAre("gone.txt", "conf.txt"));
}

TEST_F(CommandFilesTest, leadOutOfThePlansFolderByAbsolutePaths)
{
    OutsideCommand command{.words = {"./run.sh", "x"}};
    command.folder = folder();
    const std::string beside = (folder().parent_path() / "beside.txt").string();
    EXPECT_EQ(givenWord(command, 0, "./run.sh"), (folder() / "run.sh").string());
    EXPECT_EQ(givenWord(command, 1, "conf.txt"), "conf.txt");
    EXPECT_EQ(givenWord(command, 1, "../beside.txt"), beside);
    EXPECT_EQ(givenWord(command, 1, "--config=../beside.txt,x"), "--config=" + beside + ",x");
    EXPECT_EQ(givenWord(command, 1, "../nowhere"), "../nowhere");
    command.words.front() = "sh";
    EXPECT_EQ(givenWord(command, 0, "sh"), "sh");
}

TEST(TimeMargin, isATenthOfTheLimitAndAtMostASecond)
{
    OutsideCommand command;
    EXPECT_DOUBLE_EQ(timeMargin(command, 1), 0.1);
    EXPECT_DOUBLE_EQ(timeMargin(command, 60), 1);
    command.margin = 0;
    EXPECT_DOUBLE_EQ(timeMargin(command, 60), 0);
}

TEST(WorkingFolder, showsWhatIsInTheOtherAndLetsItBeWrittenOver)
{
    const TemporaryFolder folder;
    const std::filesystem::path plan = folder.path() / "plan";
    const std::filesystem::path work = folder.path() / "work";
    writeFile(plan / "small.txt", "before");
    writeFile(plan / "large.txt", std::string(kLargestCopy + 1, 'x'));
    writeFile(plan / "sub" / "inner.txt", "inner");
    writeFile(plan / "run.sh", "#!/bin/sh\n");
    std::filesystem::permissions(plan / "run.sh", std::filesystem::perms::owner_all);
    std::filesystem::create_symlink("nowhere", plan / "dangling");
    makeWorkingFolder(work, plan);
    EXPECT_EQ(readFile(work / "small.txt"), "before");
    EXPECT_EQ(readFile(work / "large.txt").size(), kLargestCopy + 1);
    EXPECT_EQ(readFile(work / "sub" / "inner.txt"), "inner");
    for (const char *name : {"large.txt", "sub", "run.sh", "dangling"})
        EXPECT_TRUE(std::filesystem::is_symlink(work / name)) << name;

    writeFile(work / "small.txt", "after");
    writeFile(work / "new.txt", "new");
    EXPECT_EQ(readFile(plan / "small.txt"), "before");
    EXPECT_FALSE(std::filesystem::exists(plan / "new.txt"));
    std::filesystem::remove_all(work);
    EXPECT_EQ(readFile(plan / "sub" / "inner.txt"), "inner");
}

} // namespace
} // namespace mrpp
