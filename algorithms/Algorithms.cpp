#include "algorithms/Algorithms.h"

namespace mrpp
{

void registerAlgorithms(Catalog &) {}

} // namespace mrpp
