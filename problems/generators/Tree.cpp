#include "problems/generators/Tree.h"

#include "problems/generators/Drawing.h"
#include "problems/generators/RandomTree.h"

namespace mrpp
{

Tree::Tree()
{
    declareParam("vertices", vertices_, "1:100000000", "how many vertices");
    declareParam("shape", shape_, "uniform,recursive",
                 "every tree equally likely, or shallow ones: each vertex hangs on a random earlier one");
}

std::shared_ptr<const Graph> Tree::makeGraph(Seed seed) const
{
    Random random(seed);
    const auto vertices = static_cast<std::size_t>(vertices_);
    return drawnGraph(vertices,
                      shape_ == "uniform" ? uniformTree(vertices, random) : recursiveTree(vertices, random));
}

} // namespace mrpp
