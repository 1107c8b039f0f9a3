#pragma once
/// \file
/// Registers every problem family and file format of this project.

#include "framework/Catalog.h"

namespace mrpp
{

void registerProblems(Catalog &catalog);

} // namespace mrpp
