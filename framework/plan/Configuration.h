#pragma once
/// \file
/// From a plan's names and settings to objects, and to what the program would really run.

#include "framework/Catalog.h"
#include "framework/plan/BenchmarkPlan.h"

#include <memory>

namespace mrpp
{

/// The registered kind with the plan's settings. Throws InputError where there is no such kind or setting.
template <class T>
[[nodiscard]] std::unique_ptr<T> create(const Registry<T> &registry, const Configured &configured)
{
    std::unique_ptr<T> object = registry.create(configured.kind);
    for (const auto &[name, value] : configured.settings)
        object->parameters().set(name, value);
    return object;
}

/// Fills in what the program brings to each planner, optimizer and problem of the plan: the defaults of the
/// parameters that the plan leaves alone, versions, and the planners' motion rules. Throws InputError where
/// the catalog lacks one of them.
void resolve(BenchmarkPlan &plan, const Catalog &catalog);

} // namespace mrpp
