#include "reports/explorer/ExplorerTemplate.h"

namespace mrpp
{

std::string_view explorerTemplate()
{
    return {};
}

} // namespace mrpp
