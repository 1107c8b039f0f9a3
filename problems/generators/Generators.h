#pragma once
/// \file
/// Registers every generator of this project.

#include "framework/Catalog.h"

namespace mrpp
{

void registerGenerators(Catalog &catalog);

} // namespace mrpp
