#pragma once

#include "framework/support/Error.h"

namespace mrpp
{

/// A run's surroundings failed (no room in the temporary folder, no process to be had, an input that changed
/// meanwhile), and no planner is to blame: the campaign ends with the message, and the run stays open.
class HarnessError : public InputError
{
public:
    using InputError::InputError;
};

} // namespace mrpp
