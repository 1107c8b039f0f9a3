#include "reports/Reports.h"

namespace mrpp
{

void registerReports(Catalog &) {}

} // namespace mrpp
