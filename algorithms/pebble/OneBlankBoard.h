#pragma once
/// \file
/// A board with one free vertex, the *blank*. Whatever happens on it is a walk of the blank: stepping to a
/// neighbouring vertex, it changes places with whoever stands there.
///
/// What stands on the board is named by where it has to go in the end, the blank too: the board is solved
/// when target(v) == v everywhere.

#include "framework/model/Graph.h"
#include "framework/support/TerminationCondition.h"

#include <cassert>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace mrpp
{

class OneBlankBoard
{
public:
    /// \param targets a permutation: where the one on each vertex has to go, the blank included
    /// The graph must outlive the board.
    OneBlankBoard(const Graph &graph, std::vector<Vertex> targets, Vertex blank)
        : graph_(&graph), targets_(std::move(targets)), places_(targets_.size()), walk_{blank},
          blankTarget_(targets_[blank])
    {
        updatePlaces();
    }

    [[nodiscard]] const Graph &graph() const { return *graph_; }
    [[nodiscard]] Vertex blank() const { return walk_.back(); }
    [[nodiscard]] Vertex blankTarget() const { return blankTarget_; }
    /// Where the one that stands on v has to go.
    [[nodiscard]] Vertex target(Vertex v) const { return targets_[v]; }
    [[nodiscard]] std::span<const Vertex> targets() const { return targets_; }
    /// Where the one stands that has to go to `target`.
    [[nodiscard]] Vertex place(Vertex target) const { return places_[target]; }

    /// The blank goes to the neighbouring vertex v.
    void step(Vertex v)
    {
        assert(graph_->hasEdge(blank(), v));
        exchange(blank(), v);
        walk_.push_back(v);
    }

    /// The vertices on which the blank has been, its start first.
    [[nodiscard]] const std::vector<Vertex> &walk() const { return walk_; }

    /// Gives the walk away; the board is of no use afterwards.
    [[nodiscard]] std::vector<Vertex> takeWalk() { return std::move(walk_); }

    /// A point to come back to.
    using Mark = std::size_t;
    [[nodiscard]] Mark mark() const { return walk_.size(); }
    void rollback(Mark mark)
    {
        while (walk_.size() > mark)
        {
            const Vertex last = walk_.back();
            walk_.pop_back();
            exchange(walk_.back(), last);
        }
    }

    /// Changes what is wanted, not what stands where: in the end the blank is to be at the last vertex of
    /// `path`, which begins at the blank's target; walking back along it then gives what was wanted before.
    void moveBlankTarget(std::span<const Vertex> path)
    {
        std::vector<Vertex> renamed(targets_.size());
        std::iota(renamed.begin(), renamed.end(), 0);
        for (std::size_t i = 1; i < path.size(); ++i)
            renamed[path[i]] = path[i - 1];
        renamed[path.front()] = path.back();
        for (Vertex &target : targets_)
            target = renamed[target];
        blankTarget_ = path.back();
        updatePlaces();
    }

private:
    void exchange(Vertex v, Vertex w)
    {
        std::swap(targets_[v], targets_[w]);
        places_[targets_[v]] = v;
        places_[targets_[w]] = w;
    }
    void updatePlaces()
    {
        for (Vertex v = 0; v < targets_.size(); ++v)
            places_[targets_[v]] = v;
    }

    const Graph *graph_;
    std::vector<Vertex> targets_; ///< size = vertices
    std::vector<Vertex> places_;  ///< the inverse of targets_
    std::vector<Vertex> walk_;
    Vertex blankTarget_;
};

/// Whether a permutation of 0 … n−1 is odd; anything where the termination condition says stop. O(n).
[[nodiscard]] inline bool isOddPermutation(std::span<const Vertex> permutation,
                                           const TerminationCondition &ptc = {})
{
    constexpr std::size_t kPollInterval = 1 << 16;
    std::vector<char> seen(permutation.size(), 0);
    bool odd = false;
    std::size_t steps = 0;
    for (Vertex v = 0; v < permutation.size(); ++v)
        for (Vertex w = permutation[v]; w != v && seen[v] == 0; w = permutation[w])
        {
            if (++steps % kPollInterval == 0 && ptc())
                return odd;
            seen[w] = 1;
            odd = !odd;
        }
    return odd;
}

/// Takes every step out of a walk that is taken back at once, again and again: the same result with fewer
/// moves. O(length).
inline void reduceWalk(std::vector<Vertex> &walk)
{
    std::size_t kept = 0;
    for (const Vertex v : walk)
    {
        if (kept >= 2 && walk[kept - 2] == v)
            --kept;
        else
            walk[kept++] = v;
    }
    walk.resize(kept);
}

} // namespace mrpp
