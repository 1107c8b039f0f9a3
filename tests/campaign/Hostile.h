#pragma once
/// \file
/// Planners that only a process of their own can contain.

#include "framework/Catalog.h"
#include "framework/plan/BenchmarkPlan.h"

namespace mrpp::fixtures
{

/// catalog(), and: segfaulter, aborter, exiter (exit(0) in solve), spinner (deaf for ever), setup_spinner,
/// glutton (allocates without end), holder (300 MB for a moment), forker (leaves two sleeping processes, one
/// in a session of its own, then walks), double (both sides of a fork return), chatter (64 MB of standard
/// error and output each, then walks), shouter (512 MB each), overflower (recursion without end), daemon
/// (deaf for ever, beside a child in a session of its own), deserter (leaves such a child and dies), family
/// (four children of 100 MB each), foreman (two children that never stop), busy (until it is told to stop),
/// spoiler (leaves another folder, umask, limits, signals and environment), wrecker (and a thread, and no
/// standard error), inspector (gives up and says how its process is).
[[nodiscard]] Catalog hostileCatalog();

/// Plans by name, so that a worker can read them again: "hostile" has every planner above on one instance of
/// Lanes, with limits of 0.3 s and 200 MB; "holders" is holder and walker by turns; "walkers" 120 runs of a
/// few milliseconds, "many" 2004 of two, "trivial" 20 004 of next to nothing, "pausing" of one second;
/// "spoilers" are spoiler, inspector, wrecker and walker, "inspectors" the same without those who spoil;
/// "brief" 9 runs of 0.2 s under a limit of 0.6 s, "deaf" a spinner under one of 0.3 s;
/// "shouters" shouter and walker; "busy" planners that meet a limit of 0.4 s of CPU time. The plan's text is
/// its name.
[[nodiscard]] BenchmarkPlan namedPlan(const std::string &name);

} // namespace mrpp::fixtures
