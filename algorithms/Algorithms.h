#pragma once
/// \file
/// Registers every planner and optimizer of this project.

#include "framework/Catalog.h"

namespace mrpp
{

void registerAlgorithms(Catalog &catalog);

} // namespace mrpp
