#pragma once
/// \file
/// Processes and what they started, from /proc: who is there, what they used, and how to end them all.

#include <sys/types.h>
#include <vector>

namespace mrpp
{

/// The processes whose parent is that one; none where it is gone.
[[nodiscard]] std::vector<pid_t> childrenOf(pid_t process);

/// Children, their children, and so on.
[[nodiscard]] std::vector<pid_t> descendantsOf(pid_t process);

/// CPU seconds of the process, of its descendants, and of those that they waited for. In steps of 10 ms.
[[nodiscard]] double treeCpuTime(pid_t process);

/// MB of memory of a process's own (not of files), pages that it shares with others counted in parts.
[[nodiscard]] double ownMemory(pid_t process);

/// Whether the process stands still: stopped by a signal or a debugger.
[[nodiscard]] bool isStopped(pid_t process);

/// Kills every child of this process and waits for it. If this process takes in orphans
/// (PR_SET_CHILD_SUBREAPER) that ends all descendants, whatever their sessions.
void endChildren();

} // namespace mrpp
