#include "problems/generators/Generators.h"

#include "problems/generators/Biconnected.h"
#include "problems/generators/CycleLeaves.h"
#include "problems/generators/Grid.h"
#include "problems/generators/Isthmus.h"
#include "problems/generators/Maze.h"
#include "problems/generators/RandomGraph.h"
#include "problems/generators/Roadmap.h"
#include "problems/generators/Rooms.h"
#include "problems/generators/Tree.h"
#include "problems/generators/Warehouse.h"

namespace mrpp
{

void registerGenerators(Catalog &catalog)
{
    auto &problems = catalog.problems;
    problems.add<Biconnected>("biconnected", "a random biconnected graph: a cycle with handles");
    problems.add<RandomGraph>("random", "a random connected graph");
    problems.add<Isthmus>("isthmus", "a random graph with a set longest isthmus");
    problems.add<Tree>("tree", "a random tree");
    problems.add<CycleLeaves>("cycle_leaves", "a tree whose leaves are cycles");
    problems.add<Grid>("grid", "a grid of cells, with random obstacles if wanted");
    problems.add<Maze>("maze", "a grid map: a maze of corridors");
    problems.add<Rooms>("rooms", "a grid map: rooms with doors");
    problems.add<Warehouse>("warehouse", "a grid map: shelves with aisles between them");
    problems.add<Roadmap>("roadmap", "a planar roadmap: random points, some edges of their triangulation");
}

} // namespace mrpp
