#include "algorithms/pebble/ThetaStage.h"

#include "algorithms/pebble/BlankOperations.h"

#include <algorithm>
#include <cstdlib>

namespace mrpp
{

namespace
{

/// A walk of the blank from p to p.
using Word = std::vector<Vertex>;

constexpr std::size_t kOffCycle = static_cast<std::size_t>(-1);

class ThetaSolver
{
public:
    /// \pre the board's graph is the theta graph and nothing else
    ThetaSolver(OneBlankBoard &board, ThetaGraph theta, const TerminationCondition &ptc)
        : board_(board), operations_(board, ptc), theta_(std::move(theta)), ptc_(ptc)
    {}

    bool solve()
    {
        auto &[a, b, c] = theta_.arms;
        chooseHandle();
        if (!fillEvenly())
            return false;

        cycle_.assign(c.begin(), c.end());
        cycle_.push_back(theta_.q);
        cycle_.insert(cycle_.end(), a.rbegin(), a.rend());
        indices_.assign(board_.targets().size(), kOffCycle);
        for (std::size_t i = 0; i < size(); ++i)
            indices_[cycle_[i]] = i;
        if (size() <= 3) // nothing to sort: an even permutation of three is a turn
            return align();
        step_ = b.empty() ? 1 : b.size() == 1 ? 4 : 2;
        hop_ = b.empty() ? commutator() : b.size() == 1 ? hopBesideOne() : hopBesideMany();
        findHop();
        return sort() && align();
    }

private:
    [[nodiscard]] std::size_t size() const { return cycle_.size(); }

    /// The blank walks along one arm to q and back to p along another.
    [[nodiscard]] Word turn(std::size_t there, std::size_t back) const
    {
        Word word(theta_.arms[there]);
        word.push_back(theta_.q);
        word.insert(word.end(), theta_.arms[back].rbegin(), theta_.arms[back].rend());
        word.push_back(theta_.p);
        return word;
    }

    void walk(const Word &word)
    {
        for (const Vertex v : word)
            board_.step(v);
    }

    [[nodiscard]] Word inverse(const Word &word) const
    {
        Word result(word.rbegin() + 1, word.rend());
        result.push_back(theta_.p);
        return result;
    }

    [[nodiscard]] Word product(std::initializer_list<Word> words) const
    {
        Word result{theta_.p};
        for (const Word &word : words)
            result.insert(result.end(), word.begin(), word.end());
        reduceWalk(result);
        result.erase(result.begin());
        return result;
    }

    /// The word as if everybody on the cycle stood some places further along it, or back.
    [[nodiscard]] Word conjugate(const Word &word, int places) const
    {
        const Word once = places > 0 ? turn(0, 2) : turn(2, 0);
        Word by;
        for (int i = 0; i < std::abs(places); ++i)
            by.insert(by.end(), once.begin(), once.end());
        return product({by, word, inverse(by)});
    }

    [[nodiscard]] Word commutator() const
    {
        const Word alpha = turn(1, 0);
        const Word gamma = turn(1, 2);
        return product({alpha, gamma, inverse(alpha), inverse(gamma)});
    }

    [[nodiscard]] Word hopBesideMany() const
    {
        const Word d = commutator();
        return product({d, conjugate(d, 2)});
    }

    [[nodiscard]] Word hopBesideOne() const
    {
        const Word d = commutator();
        const auto e = [&](int k)
        {
            const Word pair = product({d, conjugate(d, k)});
            return product({pair, pair});
        };
        return product({inverse(e(4)), e(-4)});
    }

    /// Fills B and locks it, such that an even permutation of the others is left and the blank on p.
    bool fillEvenly()
    {
        const Handle handle{theta_.p, theta_.arms[1], theta_.q};
        if (handle.inner.empty())
        {
            if (!operations_.bringBlank(theta_.p))
                return false;
            if (isOddPermutation(board_.targets()))
                turnOddCycle();
            return true;
        }
        const auto lockAndReturn = [&]
        {
            for (const Vertex v : handle.inner)
                operations_.lock(v);
            return operations_.bringBlank(theta_.p);
        };
        const auto takeBack = [&](OneBlankBoard::Mark mark)
        {
            for (const Vertex v : handle.inner)
                operations_.unlock(v);
            return operations_.takeBack(mark);
        };
        const OneBlankBoard::Mark start = board_.mark();
        if (!operations_.fill(handle) || !lockAndReturn())
            return false;
        if (!isOddPermutation(board_.targets()))
            return true;
        if (!takeBack(start) || !operations_.enterFirst(handle))
            return false;
        const OneBlankBoard::Mark entered = board_.mark();
        if (!operations_.fillFromX(handle) || !lockAndReturn())
            return false;
        if (!isOddPermutation(board_.targets()))
            return true;
        return takeBack(entered) && operations_.enterFirstAgain(handle) && operations_.fillFromX(handle) &&
               lockAndReturn();
    }

    void turnOddCycle()
    {
        const auto &[a, b, c] = theta_.arms;
        walk((a.size() + b.size()) % 2 != 0 ? turn(0, 1) : turn(2, 1));
    }

    /// Brings the arm that is filled first to the middle.
    void chooseHandle()
    {
        auto &arms = theta_.arms;
        std::sort(arms.begin(), arms.end(),
                  [](const auto &first, const auto &second) { return first.size() < second.size(); });
        const bool isEven1 = (arms[0].size() + arms[1].size()) % 2 == 0;
        const bool isEven2 = (arms[0].size() + arms[2].size()) % 2 == 0;
        if (arms[0].empty() || (!isEven1 && !isEven2))
            std::swap(arms[0], arms[1]);
        else if (isEven1)
            std::swap(arms[2], arms[1]);
    }

    /// Which three of the cycle the hop moves: the one on place base_ comes to base_ + 2 step_, and the two
    /// between them one step_ back; or the other way round, if hopsForward_ is false.
    void findHop()
    {
        const OneBlankBoard::Mark mark = board_.mark();
        std::vector<Vertex> before(size());
        for (std::size_t i = 0; i < size(); ++i)
            before[i] = board_.target(cycle_[i]);
        walk(hop_);
        std::vector<std::size_t> to(size());
        for (std::size_t i = 0; i < size(); ++i)
        {
            to[i] = indices_[board_.place(before[i])];
            assert(to[i] != kOffCycle);
        }
        board_.rollback(mark);
        // In a round of three neighbours every one moves by one place or by two back.
        for (std::size_t i = 0; i < size(); ++i)
        {
            const std::size_t j = (i + step_) % size();
            const std::size_t k = (j + step_) % size();
            if (to[i] == k && to[j] == i && to[k] == j)
            {
                base_ = i;
                hopsForward_ = true;
                return;
            }
            if (to[k] == i && to[i] == j && to[j] == k)
            {
                base_ = i;
                hopsForward_ = false;
                return;
            }
        }
        assert(false);
    }

    /// Turns the cycle so that everybody moves by `places` along it, the shorter way.
    bool shift(std::size_t places)
    {
        const bool forward = places <= size() - places;
        const Word once = forward ? turn(0, 2) : turn(2, 0);
        for (std::size_t i = forward ? places : size() - places; i > 0; --i)
        {
            if (ptc_())
                return false;
            walk(once);
        }
        return true;
    }

    /// The place of the one whose target is cycle_[i].
    [[nodiscard]] std::size_t placeOf(std::size_t i) const { return indices_[board_.place(cycle_[i])]; }

    /// The one on `place` hops over the next two, counted in steps, or over the two before.
    bool hop(std::size_t place, bool forward)
    {
        const std::size_t target = forward ? base_ : (base_ + 2 * step_) % size();
        if (!shift((target + size() - place) % size()))
            return false;
        walk(forward == hopsForward_ ? hop_ : inverse(hop_));
        return true;
    }

    /// Insertion into a growing row of those that follow one another.
    bool sort()
    {
        const std::size_t n = size();
        // How many steps lie between two places.
        std::vector<std::size_t> steps(n);
        for (std::size_t i = 0; i < n; ++i)
            steps[i * step_ % n] = i;
        for (std::size_t count = 1; count + 1 < n; ++count)
        {
            const std::size_t robot = count * step_ % n;
            const std::size_t before = (count - 1) * step_ % n;
            for (;;)
            {
                // How many it has to pass to come next in the row, going back or forward.
                const std::size_t place = placeOf(robot);
                const std::size_t back = steps[(place + n - placeOf(before)) % n] - 1;
                const std::size_t forward = n - 1 - back;
                if (back == 0)
                    break;
                bool done = false;
                if (back % 2 == 0 || forward % 2 == 0)
                    done = hop(place, back % 2 != 0 || (forward % 2 == 0 && forward < back));
                else if (back == 1) // the one between goes ahead over this one and the next
                    done = hop((place + n - step_) % n, true);
                else
                    done = hop(place, false);
                if (!done)
                    return false;
            }
        }
        return true;
    }

    /// Turns the sorted cycle until everybody is home.
    bool align() { return shift((size() - placeOf(0)) % size()); }

    OneBlankBoard &board_;
    BlankOperations operations_;
    ThetaGraph theta_;
    const TerminationCondition &ptc_;
    std::vector<Vertex> cycle_;        ///< y_0 … y_{L−1}; a turn along A and back along C shifts forward
    std::vector<std::size_t> indices_; ///< in cycle_, by vertex
    std::size_t step_ = 1;             ///< s
    Word hop_;
    std::size_t base_ = 0;
    bool hopsForward_ = true;
};

} // namespace

bool solveTheta(OneBlankBoard &board, const ThetaGraph &theta, const TerminationCondition &ptc)
{
    // A board of its own, with the edges of the theta graph alone.
    std::vector<Vertex> vertices{theta.p, theta.q};
    std::vector<Graph::Edge> edges;
    ThetaGraph own{0, 1, {}};
    for (std::size_t i = 0; i < 3; ++i)
    {
        Vertex last = own.p;
        for (const Vertex v : theta.arms[i])
        {
            const auto name = static_cast<Vertex>(vertices.size());
            vertices.push_back(v);
            own.arms[i].push_back(name);
            edges.push_back({last, name});
            last = name;
        }
        edges.push_back({last, own.q});
    }
    std::vector<Vertex> names(board.targets().size(), kNoVertex);
    for (Vertex i = 0; i < vertices.size(); ++i)
        names[vertices[i]] = i;
    std::vector<Vertex> targets;
    for (const Vertex v : vertices)
        targets.push_back(names[board.target(v)]);

    const auto graph = Graph::fromEdges(vertices.size(), edges);
    OneBlankBoard ownBoard(*graph, std::move(targets), names[board.blank()]);
    if (!ThetaSolver(ownBoard, std::move(own), ptc).solve())
        return false;
    for (std::size_t i = 1; i < ownBoard.walk().size(); ++i)
        board.step(vertices[ownBoard.walk()[i]]);
    return true;
}

} // namespace mrpp
