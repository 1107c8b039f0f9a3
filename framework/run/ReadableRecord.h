#pragma once

#include "framework/run/RunRecord.h"

namespace mrpp
{

/// Makes what planners, programs and plugins said readable(): the reasons and the columns that were added.
void makeReadable(RunRecord &record);

} // namespace mrpp
