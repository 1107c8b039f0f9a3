#include "framework/support/CanonicalSettings.h"

#include <nlohmann/json.hpp>

namespace mrpp
{

bool takesText(const ParameterSet &parameters, const std::string &name)
{
    const ParameterSet::Parameter *parameter = parameters.find(name);
    return parameter != nullptr && (parameter->type() == "text" || parameter->type() == "path");
}

std::string canonicalSettings(const Config &settings, const ParameterSet &parameters)
{
    nlohmann::json json = nlohmann::json::parse(settings.canonical());
    for (const Config::Entry &entry : settings.entries())
        if (entry.value.isScalar() && takesText(parameters, entry.key))
            json[entry.key] = entry.value.text();
    return json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

} // namespace mrpp
