#pragma once

namespace mrpp
{

/// Makes relative folders in the variables PATH and TMPDIR absolute: outside programs start in folders of
/// their own and must find the same. To be called before anything else runs.
void makeSearchPathsAbsolute();

} // namespace mrpp
