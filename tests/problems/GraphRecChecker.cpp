#include "tests/problems/GraphRecChecker.h"

#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace mrpp
{

namespace
{

struct PlayedMove
{
    int from;
    int to;
};

class Checker
{
public:
    CheckedAnimation run(const std::string &text)
    {
        std::istringstream stream(text);
        if (!text.empty() && text.back() != '\n')
            return fail("the last line has no end");
        for (std::string line; result_.complaint.empty() && std::getline(stream, line);)
        {
            ++lines_;
            read(line);
            if (!result_.complaint.empty())
                result_.complaint += " in line " + std::to_string(lines_) + ": " + line;
        }
        if (result_.complaint.empty() && !ended_)
            return fail("no line Length:");
        if (result_.complaint.empty())
            play();
        return result_;
    }

private:
    /// Keeps the first complaint.
    CheckedAnimation fail(const std::string &what)
    {
        if (result_.complaint.empty())
            result_.complaint = what;
        return result_;
    }

    void read(const std::string &line)
    {
        static const std::regex id("id:(-?[0-9]+|-)");
        static const std::regex vertex(R"(\((-?[0-9]+):(-?[0-9]+)\)\[(-?[0-9]+):(-?[0-9]+):(-?[0-9]+)\])");
        static const std::regex edge(R"(\{(-?[0-9]+),(-?[0-9]+)\}[ \t]+\((-?[0-9]+)\))");
        static const std::regex position("(-?[0-9]+):X(-?[0-9]+(?:[.][0-9]+)?):Y(-?[0-9]+(?:[.][0-9]+)?)");
        static const std::regex move(
            R"((-?[0-9]+)[ \t]+-+>[ \t]+(-?[0-9]+)[ \t]+[-0-9>\[\] \t]*\(([0-9]+)\))");
        static const std::regex length("Length:([0-9]+)");
        std::smatch part;
        const auto number = [&part](std::size_t i) { return std::stoi(part[i].str()); };
        if (ended_)
            fail("something behind Length:");
        else if (lines_ == 1 && !std::regex_match(line, id))
            fail("the first line is no id");
        else if (lines_ == 2 && line != "V =")
            fail("the second line is not 'V ='");
        else if (lines_ <= 2 || line == "E =" || line == "MOD =" || line == "POS =" || line == "Solution")
            section_ = line;
        else if (section_ == "V =" && std::regex_match(line, part, vertex))
        {
            if (!vertices_.insert(number(1)).second)
                fail("a vertex twice");
            if (number(3) > 0 && !robots_.insert(number(3)).second)
                fail("a robot twice");
            if (number(3) > 0)
                result_.robotAt[number(1)] = number(3);
        }
        else if (section_ == "E =" && std::regex_match(line, part, edge))
        {
            if (vertices_.count(number(1)) == 0 || vertices_.count(number(2)) == 0)
                fail("an edge without its vertex");
            edges_.insert({number(1), number(2)});
            edges_.insert({number(2), number(1)});
        }
        else if (section_ == "MOD =" && (line == "M:TRANSITIVE" || line == "M:IMMEDIATE"))
            transitive_ = line == "M:TRANSITIVE";
        else if (section_ == "POS =" && std::regex_match(line, part, position))
        {
            if (vertices_.count(number(1)) == 0)
                fail("a position of no vertex");
        }
        else if (section_ == "Solution" && std::regex_match(line, part, move))
        {
            const auto step = static_cast<std::size_t>(number(3));
            if (step > steps_.size())
                fail("a gap between steps");
            else if (step + 1 < steps_.size())
                fail("a step that is over");
            else if (step == steps_.size())
                steps_.emplace_back();
            if (result_.complaint.empty())
                steps_[step].push_back({number(1), number(2)});
            ++result_.moves;
        }
        else if (section_ == "Solution" && std::regex_match(line, part, length))
        {
            ended_ = true;
            if (static_cast<std::size_t>(number(1)) != result_.moves)
                fail("another number of moves than Length: says");
        }
        else
            fail("a line of no known kind");
    }

    void play()
    {
        for (const std::vector<PlayedMove> &step : steps_)
        {
            std::set<int> sources;
            std::set<int> targets;
            for (const PlayedMove &move : step)
            {
                const std::string what = std::to_string(move.from) + " to " + std::to_string(move.to) +
                                         " in step " + std::to_string(result_.steps);
                if (move.from == move.to)
                    fail("a loop: " + what);
                if (edges_.count({move.from, move.to}) == 0)
                    fail("no edge: " + what);
                if (result_.robotAt.count(move.from) == 0)
                    fail("nobody there: " + what);
                if (!sources.insert(move.from).second || !targets.insert(move.to).second)
                    fail("a vertex left or entered twice: " + what);
                if (!transitive_ && result_.robotAt.count(move.to) != 0)
                    fail("not empty: " + what);
            }
            for (const PlayedMove &move : step)
            {
                if (result_.robotAt.count(move.to) != 0 && sources.count(move.to) == 0)
                    fail("somebody stays on " + std::to_string(move.to));
                for (const PlayedMove &other : step)
                    if (other.from == move.to && other.to == move.from)
                        fail("a swap between " + std::to_string(move.from) + " and " +
                             std::to_string(move.to));
            }
            if (!result_.complaint.empty())
                return;
            std::map<int, int> moved;
            for (const PlayedMove &move : step)
                moved[move.to] = result_.robotAt[move.from];
            for (const PlayedMove &move : step)
                result_.robotAt.erase(move.from);
            for (const auto &[vertex, robot] : moved)
                result_.robotAt[vertex] = robot;
            ++result_.steps;
        }
    }

    CheckedAnimation result_;
    std::size_t lines_ = 0;
    std::string section_;
    bool ended_ = false;
    bool transitive_ = true;
    std::set<int> vertices_;
    std::set<int> robots_;
    std::set<std::pair<int, int>> edges_;
    std::vector<std::vector<PlayedMove>> steps_;
};

} // namespace

CheckedAnimation checkGraphRecText(const std::string &text)
{
    return Checker().run(text);
}

} // namespace mrpp
