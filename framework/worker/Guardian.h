#pragma once
/// \file
/// Stays behind when a worker begins to run planners: whatever a planner starts, in whatever session, ends
/// with the worker, however that ends, and with the campaign.

namespace mrpp
{

/// Splits this process in two. The call returns in the child, which goes on as the worker. The parent never
/// returns: it takes in all orphans, and ends every process below it as soon as the worker has ended, the
/// other end of `socket` is closed, or it gets SIGTERM, and removes what they left in the temporary folder;
/// then it ends as the worker did. There must be no other thread. Throws HarnessError where no process can be
/// had.
void becomeGuarded(int socket);

} // namespace mrpp
