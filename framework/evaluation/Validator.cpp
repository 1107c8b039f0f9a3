#include "framework/evaluation/Validator.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace mrpp
{

namespace
{

constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

/// What is wrong with a step, and the index within it of the first move to blame.
struct Complaint
{
    std::size_t move = 0;
    std::string text;
};

/// Where every robot stands, moved on step by step.
class Replay
{
public:
    Replay(const Instance &instance, MotionRule rule)
        : instance_(instance), rule_(rule), position_(instance.starts),
          occupant_(instance.graph->vertexCount(), kNoRobot), moveOf_(instance.robotCount(), kNone),
          entering_(instance.graph->vertexCount(), kNone), lastStep_(instance.robotCount(), kNone)
    {
        for (Robot robot = 0; robot < position_.size(); ++robot)
            occupant_[position_[robot]] = robot;
    }

    /// Makes the moves of one step, all at once; where they may not be made, nothing changes.
    std::optional<Complaint> step(std::span<const TimedMove> moves)
    {
        note(moves);
        auto complaint = check(moves);
        forget(moves);
        if (complaint)
        {
            complaint->text = fmt::format("step {}: {}", steps_, complaint->text);
            return complaint;
        }
        for (const TimedMove &move : moves)
            occupant_[vertex(move.from)] = kNoRobot;
        for (const TimedMove &move : moves)
        {
            const Robot robot = static_cast<Robot>(move.robot);
            occupant_[vertex(move.to)] = robot;
            position_[robot] = vertex(move.to);
            lastStep_[robot] = static_cast<std::uint32_t>(steps_);
        }
        ++steps_;
        return std::nullopt;
    }

    [[nodiscard]] std::size_t atGoal() const
    {
        std::size_t count = 0;
        for (std::size_t robot = 0; robot < position_.size(); ++robot)
            count += position_[robot] == instance_.goals[robot] ? 1 : 0;
        return count;
    }

    /// The first robot that is not at its goal, in words; empty where there is none.
    [[nodiscard]] std::string missedGoal() const
    {
        for (std::size_t robot = 0; robot < position_.size(); ++robot)
        {
            if (position_[robot] == instance_.goals[robot])
                continue;
            const std::string last = lastStep_[robot] == kNone
                                         ? "it never moves"
                                         : fmt::format("its last move is step {}", lastStep_[robot]);
            return fmt::format("robot {} ends on vertex {}, its goal is {} ({})", robot, position_[robot],
                               instance_.goals[robot], last);
        }
        return {};
    }

private:
    [[nodiscard]] bool isRobot(std::int64_t number) const
    {
        return number >= 0 && static_cast<std::uint64_t>(number) < position_.size();
    }
    [[nodiscard]] bool isVertex(std::int64_t number) const
    {
        return number >= 0 && static_cast<std::uint64_t>(number) < occupant_.size();
    }
    [[nodiscard]] static Vertex vertex(std::int64_t number) { return static_cast<Vertex>(number); }

    /// Enters the step's moves into moveOf_ and entering_; the first of several stays.
    void note(std::span<const TimedMove> moves)
    {
        for (std::uint32_t i = 0; i < moves.size(); ++i)
        {
            if (isRobot(moves[i].robot) && moveOf_[static_cast<Robot>(moves[i].robot)] == kNone)
                moveOf_[static_cast<Robot>(moves[i].robot)] = i;
            if (isVertex(moves[i].to) && entering_[vertex(moves[i].to)] == kNone)
                entering_[vertex(moves[i].to)] = i;
        }
    }

    void forget(std::span<const TimedMove> moves)
    {
        for (const TimedMove &move : moves)
        {
            if (isRobot(move.robot))
                moveOf_[static_cast<Robot>(move.robot)] = kNone;
            if (isVertex(move.to))
                entering_[vertex(move.to)] = kNone;
        }
    }

    /// First what no rule allows, then what this rule does not.
    [[nodiscard]] std::optional<Complaint> check(std::span<const TimedMove> moves)
    {
        std::optional<std::size_t> follower; // the first move into a vertex that is left in this step
        for (std::size_t i = 0; i < moves.size(); ++i)
        {
            if (auto text = impossible(moves, i); !text.empty())
                return Complaint{i, std::move(text)};
            if (!follower && occupant_[vertex(moves[i].to)] != kNoRobot)
                follower = i;
        }
        const std::vector<std::uint32_t> cycle = follower ? closedCycle(moves) : std::vector<std::uint32_t>();
        const MotionRule needed = !cycle.empty()     ? MotionRule::rotation
                                  : follower         ? MotionRule::following
                                  : moves.size() > 1 ? MotionRule::parallel
                                                     : MotionRule::pebble;
        if (needed <= rule_)
            return std::nullopt;

        Complaint complaint;
        if (!cycle.empty())
        {
            complaint.move = cycle.front();
            complaint.text = "robots ";
            for (std::size_t i = 0; i < cycle.size(); ++i)
                complaint.text += fmt::format("{}{}",
                                              i == 0                  ? ""
                                              : i + 1 == cycle.size() ? " and "
                                                                      : ", ",
                                              moves[cycle[i]].robot);
            complaint.text += " turn on a closed cycle";
        }
        else if (rule_ == MotionRule::pebble)
        {
            complaint.move = 1;
            complaint.text = fmt::format("robots {} and {} move at once", moves[0].robot, moves[1].robot);
        }
        else
        {
            const TimedMove &move = moves[*follower];
            complaint.move = *follower;
            complaint.text = fmt::format("robot {} enters vertex {} in the step in which robot {} leaves it",
                                         move.robot, move.to, occupant_[vertex(move.to)]);
        }
        complaint.text +=
            fmt::format("; the rule '{}' does not allow that, '{}' would", toString(rule_), toString(needed));
        return complaint;
    }

    /// Why no rule allows move `i` of the step; empty where some rule does.
    [[nodiscard]] std::string impossible(std::span<const TimedMove> moves, std::size_t i) const
    {
        const auto &[step, robot, from, to] = moves[i];
        if (!isRobot(robot))
            return fmt::format("there is no robot {}; robots are numbered from 0, and there are {}", robot,
                               position_.size());
        for (const std::int64_t end : {from, to})
            if (!isVertex(end))
                return fmt::format("robot {} cannot go from {} to {}: there is no vertex {}; vertices are "
                                   "numbered from 0, and there are {}",
                                   robot, from, to, end, occupant_.size());
        const auto id = static_cast<Robot>(robot);
        if (moveOf_[id] != i)
            return fmt::format("robot {} moves twice, to {} and to {}", robot, moves[moveOf_[id]].to, to);
        if (position_[id] != vertex(from))
            return fmt::format("robot {} cannot go from {} to {}: it stands on vertex {}", robot, from, to,
                               position_[id]);
        if (from == to)
            return fmt::format("robot {} cannot go from {} to {}: a move changes the vertex, and waits are "
                               "not written",
                               robot, from, to);
        if (!instance_.graph->hasEdge(vertex(from), vertex(to)))
            return fmt::format("robot {} cannot go from {} to {}: there is no edge", robot, from, to);
        if (entering_[vertex(to)] != i)
            return fmt::format("robots {} and {} both enter vertex {}", moves[entering_[vertex(to)]].robot,
                               robot, to);
        const Robot other = occupant_[vertex(to)];
        if (other == kNoRobot)
            return {};
        if (moveOf_[other] == kNone)
            return fmt::format("robot {} cannot go from {} to {}: robot {} stands there", robot, from, to,
                               other);
        if (moves[moveOf_[other]].from == to && moves[moveOf_[other]].to == from)
            return fmt::format("robots {} and {} swap along the edge {}–{}",
                               std::min<std::int64_t>(robot, other), std::max<std::int64_t>(robot, other),
                               std::min(from, to), std::max(from, to));
        return {};
    }

    /// The moves of the first closed cycle of the step, in its direction; empty where there is none.
    /// \pre every move is possible under some rule
    [[nodiscard]] std::vector<std::uint32_t> closedCycle(std::span<const TimedMove> moves)
    {
        walk_.assign(moves.size(), kNone);
        for (std::uint32_t first = 0; first < moves.size(); ++first)
        {
            std::uint32_t i = first;
            while (i != kNone && walk_[i] == kNone)
            {
                walk_[i] = first;
                const Robot ahead = occupant_[vertex(moves[i].to)];
                i = ahead == kNoRobot ? kNone : moveOf_[ahead];
            }
            if (i != kNone && walk_[i] == first)
            {
                std::vector<std::uint32_t> cycle;
                for (std::uint32_t j = i; cycle.empty() || j != i;
                     j = moveOf_[occupant_[vertex(moves[j].to)]])
                    cycle.push_back(j);
                return cycle;
            }
        }
        return {};
    }

    const Instance &instance_;
    MotionRule rule_;
    std::size_t steps_ = 0; ///< made so far
    std::vector<Vertex> position_;
    std::vector<Robot> occupant_;
    std::vector<std::uint32_t> moveOf_;   ///< the move of a robot in this step
    std::vector<std::uint32_t> entering_; ///< the first move of this step into a vertex
    std::vector<std::uint32_t> lastStep_; ///< in which a robot moved
    std::vector<std::uint32_t> walk_;     ///< which walk came to a move of this step
};

/// Feeds steps to a Replay and makes the verdict.
class Judge
{
public:
    Judge(const Instance &instance, MotionRule rule) : robots_(instance.robotCount()), replay_(instance, rule)
    {}

    /// False once something was wrong; further steps are not looked at.
    bool step(std::span<const TimedMove> moves)
    {
        if (const auto complaint = verdict_.legal ? replay_.step(moves) : std::nullopt)
            refuse(verdict_.badMove + complaint->move, complaint->text);
        else if (verdict_.legal)
            verdict_.badMove += moves.size();
        return verdict_.legal;
    }

    void refuse(std::size_t badMove, std::string why)
    {
        verdict_.legal = false;
        verdict_.badMove = badMove;
        verdict_.violation = std::move(why);
    }

    Verdict end()
    {
        verdict_.atGoal = replay_.atGoal();
        verdict_.complete = verdict_.atGoal == robots_;
        if (verdict_.legal && !verdict_.complete)
            verdict_.violation = replay_.missedGoal();
        return std::move(verdict_);
    }

private:
    std::size_t robots_;
    Replay replay_;
    Verdict verdict_; ///< its badMove counts the moves so far
};

Verdict malformed(std::string why)
{
    Verdict verdict;
    verdict.legal = verdict.complete = false;
    verdict.violation = std::move(why);
    return verdict;
}

std::vector<TimedMove> &assign(std::vector<TimedMove> &rows, std::span<const Move> moves)
{
    rows.clear();
    for (const Move &move : moves)
        rows.push_back({0, move.robot, move.from, move.to});
    return rows;
}

/// The first move of a rotation into a vertex that no other of its moves leaves, if there is one.
std::optional<std::size_t> openEnd(std::span<const Move> rotation)
{
    std::vector<Vertex> left;
    for (const Move &move : rotation)
        left.push_back(move.from);
    std::sort(left.begin(), left.end());
    for (std::size_t i = 0; i < rotation.size(); ++i)
        if (!std::binary_search(left.begin(), left.end(), rotation[i].to))
            return i;
    return std::nullopt;
}

} // namespace

Verdict validate(const Instance &instance, const Solution &solution, MotionRule rule)
{
    if (const auto defect = instance.defect())
        return malformed("the instance is malformed: " + *defect);
    std::size_t end = 0;
    for (const Solution::Rotation &rotation : solution.rotations())
    {
        if (rotation.first < end || rotation.size < 2 || rotation.first > solution.pathLength() ||
            rotation.size > solution.pathLength() - rotation.first)
            return malformed(
                fmt::format("the solution's rotations are malformed: one has {} moves from move {} on",
                            rotation.size, rotation.first));
        end = rotation.first + rotation.size;
    }

    Judge judge(instance, rule);
    std::vector<TimedMove> rows;
    std::size_t step = 0;
    std::size_t made = 0;
    bool going = true;
    solution.forEachAction(
        [&](std::span<const Move> action)
        {
            if (!going)
                return;
            going = judge.step(assign(rows, action));
            if (const auto open = going && action.size() > 1 ? openEnd(action) : std::nullopt)
            {
                judge.refuse(
                    made + *open,
                    fmt::format("step {}: robot {} goes from {} to {} in a rotation, but no robot of it "
                                "leaves vertex {}",
                                step, action[*open].robot, action[*open].from, action[*open].to,
                                action[*open].to));
                going = false;
            }
            made += action.size();
            ++step;
        });
    return judge.end();
}

Verdict validate(const Instance &instance, const Schedule &schedule, MotionRule rule)
{
    if (const auto defect = instance.defect())
        return malformed("the instance is malformed: " + *defect);
    Judge judge(instance, rule);
    std::vector<TimedMove> rows;
    for (std::size_t step = 0; step < schedule.makespan(); ++step)
        if (!judge.step(assign(rows, schedule.step(step))))
            break;
    return judge.end();
}

Verdict validate(const Instance &instance, std::span<const TimedMove> rows, MotionRule rule)
{
    if (const auto defect = instance.defect())
        return malformed("the instance is malformed: " + *defect);
    Judge judge(instance, rule);
    std::int64_t step = 0;
    for (std::size_t first = 0; first < rows.size(); ++step)
    {
        if (rows[first].step != step)
        {
            judge.refuse(
                first, first == 0
                           ? fmt::format("the first step is {}; steps are numbered from 0", rows[first].step)
                           : fmt::format("step {} comes after step {}; steps go up by one, without gaps",
                                         rows[first].step, step - 1));
            break;
        }
        std::size_t last = first;
        while (last < rows.size() && rows[last].step == step)
            ++last;
        if (!judge.step(rows.subspan(first, last - first)))
            break;
        first = last;
    }
    return judge.end();
}

} // namespace mrpp
