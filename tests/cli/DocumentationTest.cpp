/// Runs the commands of docs/*.md, so that what they teach stays true. In the text, a comment before a fenced
/// block says what it is: `<!-- file: NAME -->` makes it a file, `<!-- run -->` runs it by sh, line by line
/// until one fails, `<!-- run: 1 -->` expects that exit code, `<!-- run with the explorer -->` runs it where
/// the program has the explorer. All blocks of a page share a folder.

#include "tests/cli/Program.h"

#include "framework/system/File.h"

#include <gtest/gtest.h>

#include <sstream>

namespace mrpp::test
{

namespace
{

#ifdef MRPP_HAS_EXPLORER
constexpr bool kHasExplorer = true;
#else
constexpr bool kHasExplorer = false;
#endif

struct Block
{
    std::string file; ///< empty where it is to be run
    int code = 0;
    std::string text;
    std::size_t line = 0;
};

std::vector<Block> blocksOf(const std::filesystem::path &page)
{
    std::vector<Block> blocks;
    std::istringstream stream(readFile(page));
    bool marked = false;
    bool inside = false;
    Block block;
    std::size_t number = 0;
    for (std::string line; std::getline(stream, line);)
    {
        ++number;
        if (inside)
        {
            inside = !line.starts_with("```");
            if (inside)
                block.text += line + "\n";
            else
                blocks.push_back(block);
        }
        else if (line.starts_with("<!-- file: "))
        {
            block = {line.substr(11, line.find(" -->") - 11), 0, "", number};
            marked = true;
        }
        else if (line.starts_with("<!-- run: ") || line == "<!-- run -->")
        {
            block = {"", line.starts_with("<!-- run: ") ? std::stoi(line.substr(10)) : 0, "", number};
            marked = true;
        }
        else if (line == "<!-- run with the explorer -->")
        {
            block = {"", 0, "", number};
            marked = kHasExplorer;
        }
        else if (line.starts_with("```"))
        {
            inside = marked;
            marked = false;
        }
    }
    return blocks;
}

std::vector<std::string> pages()
{
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(MRPP_SOURCE_DIR "/docs"))
        if (entry.path().extension() == ".md")
            names.push_back(entry.path().stem().string());
    return names;
}

class Documentation : public ::testing::TestWithParam<std::string>
{};

TEST_P(Documentation, commandsDoWhatThePageSays)
{
    const Scratch scratch;
    const std::string folder = std::filesystem::path(MRPP_PROGRAM).parent_path().string();
    for (const Block &block : blocksOf(std::string(MRPP_SOURCE_DIR) + "/docs/" + GetParam() + ".md"))
    {
        if (!block.file.empty())
        {
            scratch.write(block.file, block.text);
            continue;
        }
        const std::string script = "PATH='" + folder + "':\"$PATH\"\nset -e\n" + block.text;
        const Outcome outcome = Process({"sh", "-c", script}, scratch).wait();
        EXPECT_EQ(outcome.code, block.code) << "line " << block.line << ":\n"
                                            << block.text << outcome.out << outcome.err;
    }
}

INSTANTIATE_TEST_SUITE_P(pages, Documentation, ::testing::ValuesIn(pages()));

} // namespace
} // namespace mrpp::test
