#pragma once
/// \file
/// Registers every report of this project.

#include "framework/Catalog.h"

namespace mrpp
{

void registerReports(Catalog &catalog);

} // namespace mrpp
