#pragma once
/// \file
/// The machine's cores: which this process may use, how to share them among several, how busy they are.

#include <cstddef>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace mrpp
{

/// Numbers of logical cores, as the system counts them.
using CoreSet = std::vector<int>;

/// Those that this process may use, hardware threads of one physical core side by side.
[[nodiscard]] CoreSet allowedCores();

/// `parts` disjoint sets of equal size out of `cores`, neighbours together; none where there are fewer cores
/// than parts. Cores that would make the sets unequal are left out.
[[nodiscard]] std::vector<CoreSet> shareCores(const CoreSet &cores, std::size_t parts);

/// Confines a process, and what it starts from then on, to these cores. False where that is refused.
bool confine(pid_t process, const CoreSet &cores);

/// "0-3,8".
[[nodiscard]] std::string toString(const CoreSet &cores);

/// How many cores this process may use, hardware threads included; 1 where that is unknown.
[[nodiscard]] double machineCores();

/// The average number of processes that ran or wanted to run during the last minute, this machine's others
/// included; nothing where that is unknown.
[[nodiscard]] std::optional<double> machineLoad();

} // namespace mrpp
