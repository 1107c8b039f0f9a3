#include "reports/summary/Titles.h"

#include "reports/picture/Text.h"
#include "reports/summary/Aggregate.h"

#include <cctype>

namespace mrpp
{

std::string variableTitle(const std::string &variable)
{
    if (variable == "robots")
        return "Robots";
    if (variable == "free")
        return "Free vertices";
    if (variable == "occupancy")
        return "Occupancy (robots per vertex)";
    std::string title = spaced(variable);
    if (!title.empty())
        title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
    return title;
}

std::string measureName(std::string_view column)
{
    const std::string name = metricTitle(column);
    return name.substr(0, name.rfind(" ("));
}

} // namespace mrpp
