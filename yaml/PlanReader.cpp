#include "yaml/PlanReader.h"

namespace mrpp
{
} // namespace mrpp
