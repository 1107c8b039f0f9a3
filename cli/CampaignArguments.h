#pragma once
/// \file
/// The command line of what is done with campaigns that ran in parts, or ran already. Internal to
/// Arguments.cpp.

#include "cli/Arguments.h"

namespace CLI
{
class App;
}

namespace mrpp
{

void addMerge(CLI::App &app, Arguments &result);
void addCompare(CLI::App &app, Arguments &result);
void addReplay(CLI::App &app, Arguments &result);
void addSlurm(CLI::App &app, Arguments &result);

} // namespace mrpp
