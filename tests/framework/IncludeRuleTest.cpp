#include "algorithms/Algorithms.h"
#include "framework/Catalog.h"
#include "framework/support/File.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
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

/// Who may include whom; every folder may include itself.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"framework", {}},
    {"algorithms", {"framework"}},
    {"problems", {"framework"}},
    {"reports", {"framework"}},
    {"yaml", {"framework"}},
    {"cli", {"framework", "algorithms", "problems", "reports", "yaml"}},
    {"tests", {"framework", "algorithms", "problems", "reports", "yaml", "cli"}},
};

struct Source
{
    std::string path; ///< from the project's root
    std::string text;
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

/// What is wrong with the includes of a file, one line each.
std::vector<std::string> violations(const std::string &folder, const Source &source)
{
    static const std::regex kInclude(R"re(^\s*#\s*include\s*(["<])([^">]+)[">])re");
    std::vector<std::string> found;
    std::istringstream lines(source.text);
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);)
    {
        ++number;
        std::smatch match;
        if (!std::regex_search(line, match, kInclude))
            continue;
        const std::string path = match[2];
        const std::string target = path.substr(0, path.find('/'));
        const bool ours = kMayInclude.contains(target);
        const std::string place = source.path + ":" + std::to_string(number) + ": ";
        if (ours && target != folder && !kMayInclude.at(folder).contains(target))
            found.push_back(place + folder + "/ may not include " + path);
        else if (match[1] == "\"" && !ours &&
                 fs::exists((fs::path(MRPP_SOURCE_DIR) / source.path).replace_filename(path)))
            found.push_back(place + path + " is not given by its path from the project's root");
        else if (match[1] == "<" && ours && fs::exists(fs::path(MRPP_SOURCE_DIR) / path))
            found.push_back(place + path + " is the project's own and goes in quotes");
    }
    return found;
}

TEST(IncludeRule, HoldsInEveryFile)
{
    for (const auto &[folder, allowed] : kMayInclude)
    {
        // tests/consumer is a project of its own, which uses the installed headers.
        const auto files = sources(folder);
        EXPECT_FALSE(files.empty()) << folder;
        for (const Source &source : files)
            if (!source.path.starts_with("tests/consumer/"))
                for (const std::string &violation : violations(folder, source))
                    ADD_FAILURE() << violation;
    }
}

TEST(IncludeRule, IsNoticedWhereItIsBroken)
{
    const auto count = [](const std::string &folder, const std::string &line) {
        return violations(folder, {folder + "/X.h", "// first\n" + line + "\n"}).size();
    };
    EXPECT_EQ(count("framework", "#include \"algorithms/Algorithms.h\""), 1U);
    EXPECT_EQ(count("framework", "  #  include <yaml/PlanReader.h>"), 1U);
    EXPECT_EQ(count("reports", "#include \"problems/Problems.h\""), 1U);
    EXPECT_EQ(count("algorithms", "#include \"tests/support/BruteForce.h\""), 1U);
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
