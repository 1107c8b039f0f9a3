#pragma once
/// \file
/// How the program ends: a promise to scripts.

namespace mrpp
{

enum class ExitCode
{
    done = 0,          ///< yes, or done
    no = 1,            ///< a truthful no: not solved, not valid, a regression
    wrongUse = 2,      ///< wrong use or malformed input
    defect = 3,        ///< a defect of the program itself, for example a planner's invalid answer
    interrupted = 130, ///< by SIGINT or SIGTERM; what was finished is kept
};

} // namespace mrpp
