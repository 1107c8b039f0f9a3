#include "algorithms/Algorithms.h"
#include "framework/Catalog.h"
#include "framework/system/File.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace mrpp
{
namespace
{

namespace fs = std::filesystem;

/// Who may include whom; every layer may include itself, and a folder within it belongs to it unless named.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"framework", {}},
    {"algorithms", {"framework"}},
    {"problems/formats", {"framework"}},
    {"problems", {"framework", "problems/formats"}},
    {"reports", {"framework", "problems/formats"}},
    {"yaml", {"framework"}},
    {"cli", {"framework", "algorithms", "problems/formats", "problems", "reports", "yaml"}},
    {"tests", {"framework", "algorithms", "problems/formats", "problems", "reports", "yaml", "cli"}},
};

/// The layer of a file or folder, given from the project's root; empty where it is not ours.
std::string layerOf(const fs::path &path)
{
    for (fs::path folder = path; !folder.empty(); folder = folder.parent_path())
        if (kMayInclude.contains(folder.generic_string()))
            return folder.generic_string();
    return {};
}

struct Source
{
    std::string path; ///< from the project's root
    std::string text;
};

struct Include
{
    std::size_t line = 0;
    bool quoted = false;
    std::string path;
};

std::vector<Source> sources(const std::string &folder)
{
    const fs::path root = MRPP_SOURCE_DIR;
    std::vector<Source> list;
    for (const auto &entry : fs::recursive_directory_iterator(root / folder))
        if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
            list.push_back({fs::relative(entry.path(), root).generic_string(), readFile(entry.path())});
    return list;
}

std::vector<Include> includesOf(const std::string &text)
{
    static const std::regex kInclude(R"re(^\s*#\s*include\s*(["<])([^">]+)[">])re");
    std::vector<Include> includes;
    std::istringstream lines(text);
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);)
    {
        ++number;
        std::smatch match;
        if (std::regex_search(line, match, kInclude))
            includes.push_back({number, match[1] == "\"", match[2]});
    }
    return includes;
}

/// What is wrong with the includes of a file, one line each.
std::vector<std::string> violations(const Source &source)
{
    const std::string layer = layerOf(source.path);
    const fs::path root = MRPP_SOURCE_DIR;
    std::vector<std::string> found;
    for (const Include &include : includesOf(source.text))
    {
        const std::string target = layerOf(include.path);
        const std::string place = source.path + ":" + std::to_string(include.line) + ": ";
        if (!target.empty() && target != layer && !kMayInclude.at(layer).contains(target))
            found.push_back(place + layer + "/ may not include " + include.path);
        else if (include.quoted && target.empty() &&
                 fs::exists((root / source.path).replace_filename(include.path)))
            found.push_back(place + include.path + " is not given by its path from the project's root");
        else if (!include.quoted && !target.empty() && fs::exists(root / include.path))
            found.push_back(place + include.path + " is the project's own and goes in quotes");
    }
    return found;
}

/// Which folders the files of a folder include. The headers at a folder's root are its front door: the rooms
/// behind it may include them.
using Rooms = std::map<std::string, std::set<std::string>>;

Rooms roomsOf(const std::vector<Source> &files)
{
    Rooms rooms;
    for (const Source &file : files)
    {
        const std::string from = fs::path(file.path).parent_path().generic_string();
        for (const Include &include : includesOf(file.text))
        {
            const std::string to = fs::path(include.path).parent_path().generic_string();
            if (include.quoted && to != from && !layerOf(to).empty() && !from.starts_with(to + "/"))
                rooms[from].insert(to);
        }
    }
    return rooms;
}

/// The folders on a cycle of includes, "a → b → a"; empty where there is none.
std::string cycleIn(const Rooms &rooms)
{
    std::set<std::string> left; // whose cycles have all been looked for
    std::vector<std::string> path;
    std::string cycle;
    const std::function<bool(const std::string &)> walk = [&](const std::string &room)
    {
        const auto before = std::find(path.begin(), path.end(), room);
        if (before != path.end())
        {
            for (auto step = before; step != path.end(); ++step)
                cycle += *step + " → ";
            cycle += room;
            return true;
        }
        if (!left.contains(room) && rooms.contains(room))
        {
            path.push_back(room);
            for (const std::string &next : rooms.at(room))
                if (walk(next))
                    return true;
            path.pop_back();
        }
        left.insert(room);
        return false;
    };
    for (const auto &[room, next] : rooms)
        if (walk(room))
            break;
    return cycle;
}

/// All of the project's own code but the tests.
std::vector<Source> houseSources()
{
    std::vector<Source> files;
    for (const char *folder : {"framework", "algorithms", "problems", "reports", "yaml", "cli"})
        for (Source &source : sources(folder))
            files.push_back(std::move(source));
    return files;
}

TEST(IncludeRule, HoldsInEveryFile)
{
    std::vector<Source> files = houseSources();
    EXPECT_FALSE(files.empty());
    for (Source &source : sources("tests"))
        if (!source.path.starts_with("tests/consumer/")) // a project of its own, which uses installed headers
            files.push_back(std::move(source));
    for (const Source &source : files)
        for (const std::string &violation : violations(source))
            ADD_FAILURE() << violation;
}

TEST(IncludeRule, FoldersHaveNoCycles)
{
    EXPECT_EQ(cycleIn(roomsOf(houseSources())), "");
}

TEST(IncludeRule, CyclesOfFoldersAreNoticed)
{
    const std::vector<Source> files = {{"framework/plan/A.h", "#include \"framework/run/B.h\"\n"},
                                       {"framework/run/B.h", "#include \"framework/store/C.h\"\n"},
                                       {"framework/store/C.cpp", "#include \"framework/plan/A.h\"\n"},
                                       {"framework/run/D.h", "#include \"framework/Planner.h\"\n"},
                                       {"framework/Planner.h", "#include \"framework/run/B.h\"\n"}};
    EXPECT_EQ(cycleIn(roomsOf(files)), "framework/run → framework/store → framework/plan → framework/run");
    EXPECT_EQ(cycleIn(roomsOf({files.begin() + 1, files.end()})), "");
}

TEST(IncludeRule, NoFolderHasMoreThanThirtyUnits)
{
    std::map<std::string, std::set<std::string>> units;
    for (const Source &source : houseSources())
        units[fs::path(source.path).parent_path().generic_string()].insert(
            fs::path(source.path).stem().string());
    for (const auto &[folder, names] : units)
        EXPECT_LE(names.size(), 30U) << folder;
}

TEST(IncludeRule, IsNoticedWhereItIsBroken)
{
    const auto count = [](const std::string &folder, const std::string &line) {
        return violations({folder + "/X.h", "// first\n" + line + "\n"}).size();
    };
    EXPECT_EQ(count("framework", "#include \"algorithms/Algorithms.h\""), 1U);
    EXPECT_EQ(count("framework", "  #  include <yaml/PlanReader.h>"), 1U);
    EXPECT_EQ(count("reports", "#include \"problems/Problems.h\""), 1U);
    EXPECT_EQ(count("algorithms", "#include \"tests/support/BruteForce.h\""), 1U);
    EXPECT_EQ(count("problems/formats", "#include \"problems/Problems.h\""), 1U);
    EXPECT_EQ(count("reports", "#include \"problems/formats/Formats.h\""), 0U);
    EXPECT_EQ(count("framework", "#include \"Planner.h\""), 1U);
    EXPECT_EQ(count("cli", "#include <framework/Planner.h>"), 1U);
    EXPECT_EQ(count("algorithms", "#include \"framework/Planner.h\""), 0U);
    EXPECT_EQ(count("algorithms", "#include \"algorithms/Algorithms.h\""), 0U);
    EXPECT_EQ(count("framework", "#include <boost/graph/graph_traits.hpp>"), 0U);
    EXPECT_EQ(count("framework", "// see \"algorithms/Algorithms.h\""), 0U);
}

/// push_and_swap → PushAndSwap.
std::string className(const std::string &name)
{
    std::string text;
    bool upper = true;
    for (const char c : name)
    {
        if (c != '_')
            text += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        upper = c == '_';
    }
    return text;
}

TEST(IncludeRule, TheFrameworkNamesNoPlanner)
{
    Catalog catalog;
    registerAlgorithms(catalog);
    std::vector<std::string> names = catalog.planners.names();
    for (const char *known :
         {"push_and_swap", "push_and_rotate", "push_and_spin", "bibox", "bibox_theta", "mapp", "tass"})
        names.emplace_back(known);
    for (const Source &source : sources("framework"))
    {
        for (const std::string &name : names)
        {
            const std::regex word("\\b(" + name + "|" + className(name) + ")\\b");
            EXPECT_FALSE(std::regex_search(source.text, word)) << source.path << " names " << name;
        }
    }
}

} // namespace
} // namespace mrpp
