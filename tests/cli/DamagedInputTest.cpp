/// Damaged files of every format, given to the program as a user would: it answers, or says what is wrong,
/// within bounded time and memory. MRPP_DAMAGED_INPUTS is the number of files a format (4 where it is not
/// set).

#include "framework/support/Config.h"
#include "problems/formats/Conversion.h"
#include "problems/formats/Formats.h"
#include "tests/cli/Program.h"
#include "tests/support/Damage.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp::test
{
namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr const char *kLimits = "ulimit -t 20"; // sanitizers map more memory than any limit
#else
constexpr const char *kLimits = "ulimit -t 3; ulimit -v 1000000"; // seconds of processor time, KiB
#endif

/// A good file of a format that is never written.
std::string foreign(const FileFormat &format)
{
    EXPECT_EQ(format.name, "matrix_market");
    return "%%MatrixMarket matrix coordinate pattern symmetric\n3 3 2\n2 1\n3 2\n";
}

/// A good file of the format in the scratch folder, beside `room-even-1.scen`, `room.map` and `moves.csv`.
void writeGood(const FileFormat &format, const Scratch &scratch)
{
    const auto at = [&scratch](const char *name) { return scratch.path() / name; };
    scratch.write("room.map", "type octile\nheight 2\nwidth 4\nmap\n....\n.@..\n");
    const auto graph = loadGraph(at("room.map")).graph;
    saveInstance(at("room-even-1.scen"), {graph, {0, 6}, {2, 3}}, at("room.map"));
    scratch.write("moves.csv", "step,robot,from,to\n0,0,0,1\n0,1,6,3\n1,0,1,2\n");
    if (!format.writes)
    {
        scratch.write("good", foreign(format));
        return;
    }
    const char *source = format.holds == "graph"              ? "room.map"
                         : format.holds.ends_with("instance") ? "room-even-1.scen"
                                                              : "moves.csv";
    ConversionRequest request{at(source), at("good"), std::nullopt, std::nullopt, format.name};
    if (source == std::string("moves.csv"))
        request.instance = at("room-even-1.scen");
    (void)convertFile(request);
}

/// What the program may be asked about such a file.
std::vector<std::vector<std::string>> questions(const FileFormat &format)
{
    if (format.holds == "graph")
        return {{"convert", "bad", "out", "--to", "graphml"}, {"convert", "bad", "out", "--to", "edge_list"}};
    if (format.holds.ends_with("instance"))
        return {{"convert", "bad", "out", "--to", "cpf"},
                {"solve", "--instance", "bad", "--planner", "push_and_swap", "--time-limit", "1"}};
    return {{"validate", "--instance", "room-even-1.scen", "--solution", "bad"},
            {"convert", "bad", "out", "--to", "graphrec", "--instance", "room-even-1.scen"}};
}

TEST(DamagedInput, isAnsweredOrRefused)
{
    const char *setting = std::getenv("MRPP_DAMAGED_INPUTS");
    const std::int64_t files = parseInteger(setting == nullptr ? "4" : setting).value_or(4);
    std::size_t refused = 0;
    for (const FileFormat &format : fileFormats())
    {
        if (!format.reads)
            continue;
        const Scratch scratch;
        writeGood(format, scratch);
        const std::string good = scratch.read("good");
        Random random(deriveSeed(3, format.name));
        for (std::int64_t i = 0; i < files; ++i)
        {
            const std::string bad = damaged(good, random);
            scratch.write("bad", bad);
            for (const std::vector<std::string> &question : questions(format))
            {
                std::vector<std::string> words = {"/bin/sh", "-c",
                                                  std::string(kLimits) + "; exec \"$0\" \"$@\""};
                for (const std::string &word : mrppsimWords(question))
                    words.push_back(word);
                const Outcome outcome = Process(words, scratch).wait();
                EXPECT_THAT(outcome.code, ::testing::AnyOf(0, 1, 2))
                    << format.name << ", " << question[0] << ": " << outcome.err << "\n"
                    << bad;
                EXPECT_EQ(outcome.code == 2,
                          !outcome.err.empty() && scratch.tree().count("out") == 0 && outcome.out.empty())
                    << format.name << ", " << question[0] << ": " << outcome.err << "\n"
                    << bad;
                std::filesystem::remove(scratch.path() / "out");
                refused += outcome.code == 2 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(refused, static_cast<std::size_t>(files) * 5);
}

} // namespace
} // namespace mrpp::test
