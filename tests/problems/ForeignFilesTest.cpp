/// Valid files of other formats: every reader reads each rightly, or refuses it by a message that names what
/// it is. MRPP_FOREIGN_FILES is the number of rounds, some hundred files each (2 where it is not set).

#include "framework/support/Config.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "problems/formats/Conversion.h"
#include "problems/formats/Formats.h"

#include "tests/problems/ForeignFiles.h"
#include "tests/problems/FormatReaders.h"
#include "tests/support/RandomCases.h"

#include <cstdlib>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace mrpp
{
namespace
{

using testing::AnyOf;
using testing::HasSubstr;

std::int64_t rounds()
{
    const char *setting = std::getenv("MRPP_FOREIGN_FILES");
    return parseInteger(setting == nullptr ? "2" : setting).value_or(2);
}

/// What a reader says; nothing where it reads the text.
std::string refusal(const std::function<void()> &read)
{
    try
    {
        read();
    }
    catch (const InputError &error)
    {
        EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
        return error.what();
    }
    return {};
}

TEST(ForeignFiles, AreRefusedByEveryReaderUnderTheirNames)
{
    Random random(21);
    for (std::int64_t round = 0; round < rounds(); ++round)
        for (const test::ForeignFile &file : test::foreignFiles(random))
            for (const FormatReader &reader : formatReaders())
            {
                const std::string said = refusal([&] { reader.read(file.text); });
                ASSERT_NE(said, "") << reader.name << " reads " << file.kind << ":\n" << file.text;
                EXPECT_THAT(said, AnyOf(HasSubstr(file.name), HasSubstr("a list of edges, but expected")))
                    << reader.name << " given " << file.kind << ":\n"
                    << file.text;
            }
}

/// Files of one format, through the one door under any name.
class Doors : public testing::Test
{
protected:
    void SetUp() override
    {
        folder_ = std::filesystem::path(testing::TempDir()) / ("mrpp_doors_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
        writeFile(folder_ / "room.map", "type octile\nheight 2\nwidth 4\nmap\n....\n.@..\n");
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::vector<std::pair<char, std::string>> refusals(const std::filesystem::path &file) const
    {
        const Instance instance{test::gridGraph(4, 2), {0}, {1}};
        return {{'g', refusal([&] { (void)loadGraph(file); })},
                {'i', refusal(
                          [&] {
                              (void)loadInstance({file, std::nullopt, std::nullopt});
                          })},
                {'s', refusal([&] { (void)loadSolution(file, instance); })},
                {'c', refusal(
                          [&] {
                              (void)convertFile({file, folder_ / "out.graphml", {}, {}, {}});
                          })}};
    }

    std::filesystem::path folder_;
};

TEST_F(Doors, RefuseForeignFilesUnderTheirNames)
{
    Random random(22);
    for (std::int64_t round = 0; round < rounds(); ++round)
        for (const test::ForeignFile &file : test::foreignFiles(random))
            for (const char *extension : {"", ".map", ".graphml", ".edges", ".yaml", ".csv"})
            {
                const auto path = folder_ / ("file" + std::string(extension));
                writeFile(path, file.text);
                for (const auto &[door, said] : refusals(path))
                {
                    ASSERT_NE(said, "") << door << " reads " << file.kind << extension << ":\n" << file.text;
                    EXPECT_THAT(said, AnyOf(HasSubstr(file.name), HasSubstr("a list of edges, no")))
                        << door << " given " << file.kind << extension << ":\n"
                        << file.text;
                }
                std::filesystem::remove(path);
            }
}

TEST_F(Doors, RefuseFilesOfOtherFormatsOfOursUnderTheirNames)
{
    for (const FormatReader &file : formatReaders())
    {
        const auto path = folder_ / "file";
        writeFile(path, file.good);
        for (const auto &[door, said] : refusals(path))
        {
            const bool holds = door == 'g'   ? holdsGraph(file.id)
                               : door == 'i' ? holdsInstance(file.id)
                               : door == 's' ? holdsSolution(file.id)
                                             : holdsGraph(file.id);
            if (!holds && said.find("of the instance") == std::string::npos)
                EXPECT_THAT(said,
                            AnyOf(HasSubstr(std::string(describe(file.id))), HasSubstr("found none"),
                                  HasSubstr("says that there is no solution"), HasSubstr("say --to"),
                                  HasSubstr("there is no graph"), HasSubstr("where the robots' goals are")))
                    << door << " given " << file.name;
            else if (door == 'g')
                EXPECT_EQ(said, "") << door << " given " << file.name;
        }
    }
}

TEST(OwnFiles, AreRefusedByReadersOfOtherFormatsUnderTheirNames)
{
    const auto readers = formatReaders();
    for (const FormatReader &file : readers)
        for (const FormatReader &reader : readers)
        {
            if (reader.id == file.id ||
                (reader.id == FormatId::vetandInstance && file.id == FormatId::vetandResult))
                continue;
            const std::string said = refusal([&] { reader.read(file.good); });
            ASSERT_NE(said, "") << reader.name << " reads " << file.name << ":\n" << file.good;
            const auto isOf = [&](std::initializer_list<FormatId> family)
            {
                return std::find(family.begin(), family.end(), reader.id) != family.end() &&
                       std::find(family.begin(), family.end(), file.id) != family.end();
            };
            if (!isOf({FormatId::cpf, FormatId::graphRec, FormatId::surynekSolution}) &&
                !isOf({FormatId::vetandInstance, FormatId::vetandResult}) &&
                !isOf({FormatId::kei18Instance, FormatId::kei18Result}) &&
                !isOf({FormatId::libMrpInstance, FormatId::libMrpSchedule}))
                EXPECT_THAT(said, HasSubstr("this is " + std::string(describe(file.id))))
                    << reader.name << " given " << file.name;
        }
}

} // namespace
} // namespace mrpp
