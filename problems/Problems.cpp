#include "problems/Problems.h"

namespace mrpp
{

void registerProblems(Catalog &) {}

} // namespace mrpp
