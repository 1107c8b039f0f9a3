#include "algorithms/bibox/HandleFiller.h"

#include <algorithm>
#include <cassert>

namespace mrpp
{

HandleFiller::HandleFiller(Carrier &carrier, std::span<const Robot> goalRobots, Random *random)
    : carrier_(carrier), board_(carrier.board()), open_(carrier.open()), goalRobots_(goalRobots),
      random_(random), freeOpen_(board_.graph().vertexCount() - board_.robotCount()),
      places_(board_.graph().vertexCount(), 0)
{}

bool HandleFiller::fill(std::size_t i)
{
    setLine(open_.ears().handle(i));
    if (!isFilled())
    {
        if (!orient() || !bringInOrder())
            return false;
        while (firstFromY(true) != 0 &&
               (order_.empty() || board_.occupant(line_[firstFromY(true)]) != order_.front()))
        {
            if (carrier_.stopped())
                return false;
            letOutAtY();
        }
        settle();
    }
    assert(isFilled());
    open_.setLevel(static_cast<std::uint32_t>(i));
    for (std::size_t place = 1; place + 1 < line_.size(); ++place)
        freeOpen_ -= board_.isFree(line_[place]) ? 1 : 0;
    return true;
}

bool HandleFiller::isFilled() const
{
    return std::all_of(line_.begin() + 1, line_.end() - 1,
                       [this](Vertex v) { return board_.occupant(v) == goalRobots_[v]; });
}

std::size_t HandleFiller::placeInside(Robot r) const
{
    const Vertex v = board_.position(r);
    const std::size_t place = places_[v];
    return place + 1 < line_.size() && line_[place] == v ? place : 0;
}

std::size_t HandleFiller::firstFromX(bool occupied) const
{
    std::size_t place = 1;
    while (place + 1 < line_.size() && board_.isFree(line_[place]) == occupied)
        ++place;
    return place;
}

std::size_t HandleFiller::firstFromY(bool occupied) const
{
    std::size_t place = line_.size() - 2;
    while (place > 0 && board_.isFree(line_[place]) == occupied)
        --place;
    return place;
}

bool HandleFiller::freeOutside() const
{
    const auto inside =
        std::count_if(line_.begin() + 1, line_.end() - 1, [this](Vertex v) { return board_.isFree(v); });
    return static_cast<std::size_t>(inside) < freeOpen_;
}

void HandleFiller::setLine(std::span<const Vertex> line)
{
    line_.assign(line.begin(), line.end());
    order_.clear();
    for (std::size_t place = line_.size() - 1; place > 0; --place)
    {
        places_[line_[place]] = place;
        if (place + 1 < line_.size() && goalRobots_[line_[place]] != kNoRobot)
            order_.push_back(goalRobots_[line_[place]]);
    }
    places_[x()] = 0;
}

/// How many of the first robots of the order are inside, one behind the other.
std::size_t HandleFiller::countInOrder() const
{
    if (order_.empty())
        return 0;
    std::size_t count = 0;
    for (std::size_t place = placeInside(order_.front()); place > 0 && count < order_.size(); --place)
    {
        const Robot r = board_.occupant(line_[place]);
        if (r == kNoRobot)
            continue;
        if (r != order_[count])
            break;
        ++count;
    }
    return count;
}

/// About how many steps, each worth a turn of some cycle, the robots have to make that are to enter at x.
/// Nothing where the termination condition came first.
std::optional<std::size_t> HandleFiller::effort()
{
    std::size_t steps = 0;
    for (std::size_t i = countInOrder(); i < order_.size(); ++i)
    {
        const std::size_t place = placeInside(order_[i]);
        if (place != 0) // the first one goes through the handle; the others leave it at y, and all turns back
        {
            steps += i == 0 ? place : 2 * (line_.size() - 1 - place);
            continue;
        }
        const auto distance = carrier_.distance(board_.position(order_[i]), x());
        if (!distance)
            return std::nullopt;
        steps += *distance;
    }
    return steps;
}

/// Chooses the end at which robots enter.
bool HandleFiller::orient()
{
    if (line_.size() == 3) // one vertex inside, to which a robot comes from either end
        return true;
    const std::vector<Vertex> line = line_;
    open_.setLevel(open_.level() - 1);
    const auto forwards = effort();
    setLine(std::vector<Vertex>(line.rbegin(), line.rend()));
    const auto backwards = forwards ? effort() : std::nullopt;
    open_.setLevel(open_.level() + 1);
    if (!backwards)
        return false;
    constexpr std::size_t kPercent = 100;
    constexpr std::size_t kNearlyEqual = 10; // percent
    const std::size_t change = random_ != nullptr ? random_->below(2 * kNearlyEqual + 1) : kNearlyEqual;
    if (*forwards * kPercent <= *backwards * (kPercent - kNearlyEqual + change))
        setLine(line);
    return true;
}

bool HandleFiller::bringInOrder()
{
    const auto outside = open_.level() - 1;
    std::size_t count = countInOrder();
    if (count == 0 && !order_.empty())
    {
        if (!carrier_.carry(order_.front(), line_[1]))
            return false;
        count = 1;
    }
    open_.setLevel(outside);
    while (count > 0 && board_.occupant(line_[firstFromX(true)]) != order_[count - 1])
    {
        if (carrier_.stopped())
            return false;
        letOutAtX(kNoVertex);
    }
    for (; count < order_.size(); ++count)
    {
        const Robot r = order_[count];
        if (!freeOutside())
            letInAtY();
        if ((placeInside(r) != 0 && !extract(r)) || !carrier_.carry(r, x()))
            return false;
        enter();
    }
    return true;
}

/// The robot on x goes in.
void HandleFiller::enter()
{
    std::size_t hole = firstFromX(false);
    if (hole + 1 == line_.size())
        carrier_.makeFree(y(), x());
    carrier_.shift(line_, 0, hole);
}

/// Makes a free place outside, on x. \pre there is none outside, but inside
void HandleFiller::letInAtX()
{
    carrier_.shift(line_, 0, firstFromX(false));
}

/// Makes a free place outside, on y. \pre there is none outside, but inside
void HandleFiller::letInAtY()
{
    carrier_.shift(line_, line_.size() - 1, firstFromY(false));
}

/// The robot nearest to x leaves there. The one on `stays`, outside, is not moved.
void HandleFiller::letOutAtX(Vertex stays)
{
    if (!freeOutside())
        letInAtY();
    carrier_.makeFree(x(), stays);
    const Robot r = board_.occupant(line_[firstFromX(true)]);
    for (std::size_t place = placeInside(r); place > 0; --place)
        board_.move(r, line_[place - 1]);
}

/// The robot nearest to y leaves there.
void HandleFiller::letOutAtY()
{
    carrier_.makeFree(y());
    const Robot r = board_.occupant(line_[firstFromY(true)]);
    for (std::size_t place = placeInside(r); place + 1 < line_.size(); ++place)
        board_.move(r, line_[place + 1]);
}

/// Lets r, which is inside, out at y, and everybody behind it stays inside.
bool HandleFiller::extract(Robot r)
{
    std::size_t strangers = 0; // let in at x, in front of those that are in order
    const auto makeRoomOutside = [&]
    {
        if (freeOutside())
            return;
        letInAtX();
        ++strangers;
    };
    for (std::size_t place = placeInside(r); place + 1 < line_.size(); ++place)
    {
        if (carrier_.stopped())
            return false;
        std::size_t hole = place + 1;
        while (hole + 1 < line_.size() && !board_.isFree(line_[hole]))
            ++hole;
        if (hole + 1 == line_.size())
        {
            makeRoomOutside();
            carrier_.makeFree(y());
        }
        carrier_.shift(line_, place, hole);
    }
    makeRoomOutside();
    if (strangers == 0)
        return true;
    const auto beside = board_.graph().neighbors(y());
    const Vertex z =
        *std::find_if(beside.begin(), beside.end(), [this](Vertex v) { return v != x() && open_.isOpen(v); });
    carrier_.makeFree(z, y());
    board_.move(r, z);
    for (; strangers > 0; --strangers)
    {
        if (carrier_.stopped())
            return false;
        letOutAtX(z);
    }
    if (!freeOutside())
        letInAtY();
    return true;
}

/// Those in order go to their goals.
void HandleFiller::settle()
{
    // Whoever has to go deeper goes first where it is deeper, and the others the other way round.
    for (std::size_t place = line_.size() - 2; place > 0; --place)
    {
        const Robot r = goalRobots_[line_[place]];
        if (r == kNoRobot)
            continue;
        for (std::size_t at = placeInside(r); at < place; ++at)
            board_.move(r, line_[at + 1]);
    }
    for (std::size_t place = 1; place + 1 < line_.size(); ++place)
    {
        const Robot r = goalRobots_[line_[place]];
        if (r == kNoRobot)
            continue;
        for (std::size_t at = placeInside(r); at > place; --at)
            board_.move(r, line_[at - 1]);
    }
}

} // namespace mrpp
