#include "algorithms/search/BlockRoute.h"

#include <algorithm>

namespace mrpp
{

bool BlockRoute::isWorthwhile(const Blocks &blocks)
{
    std::size_t largest = 0;
    for (std::uint32_t block = 0; block < blocks.count(); ++block)
        largest = std::max(largest, blocks.vertices(block).size());
    return largest < blocks.preorder().size() / 2;
}

void BlockRoute::lead(Vertex from, Vertex to)
{
    if (++stamp_ == 0)
    {
        std::fill(blockStamps_.begin(), blockStamps_.end(), 0);
        std::fill(topStamps_.begin(), topStamps_.end(), 0);
        stamp_ = 1;
    }
    topStamps_[from] = topStamps_[to] = stamp_;
    while (from != to && blocks_.towardsRoot(from) != blocks_.towardsRoot(to))
    {
        // What the search met later has nothing of the other one below it: the way leads through its block
        // towards the root.
        Vertex &later = blocks_.position(from) > blocks_.position(to) ? from : to;
        const std::uint32_t block = blocks_.towardsRoot(later);
        blockStamps_[block] = stamp_;
        later = blocks_.top(block);
        topStamps_[later] = stamp_;
    }
    if (from == to)
        return;
    blockStamps_[blocks_.towardsRoot(from)] = stamp_;
    topStamps_[blocks_.top(blocks_.towardsRoot(from))] = stamp_;
}

} // namespace mrpp
