#include "framework/Planner.h"

#include <cassert>

namespace mrpp
{

void Planner::setInstance(std::shared_ptr<const Instance> instance)
{
    assert(instance && !instance->defect());
    clear();
    instance_ = std::move(instance);
}

void Planner::clear()
{
    solution_.clear();
    reason_.clear();
}

} // namespace mrpp
