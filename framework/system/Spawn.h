#pragma once

#include <span>
#include <spawn.h>
#include <string>
#include <sys/types.h>

namespace mrpp
{

/// Starts `command[0]`, looked up in PATH, in a process group of its own; no shell sees the command. The
/// caller's ignored and blocked signals are its own business: the program starts with the usual ones.
/// \param actions what becomes of its descriptors and folder
/// \return its process id; −1 where it cannot be started, and errno says why
[[nodiscard]] pid_t spawnGroup(std::span<const std::string> command,
                               const posix_spawn_file_actions_t &actions);

} // namespace mrpp
