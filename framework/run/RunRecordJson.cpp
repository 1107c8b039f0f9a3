#include "framework/run/RunRecordJson.h"

#include <nlohmann/json.hpp>

namespace mrpp
{

namespace
{

nlohmann::ordered_json toJson(const Value &value)
{
    struct Writer
    {
        nlohmann::ordered_json operator()(std::monostate) const { return nullptr; }
        nlohmann::ordered_json operator()(std::int64_t number) const { return number; }
        nlohmann::ordered_json operator()(double number) const { return number; } // dump() writes NaN as null
        nlohmann::ordered_json operator()(const std::string &text) const { return text; }
    };
    return std::visit(Writer(), value);
}

} // namespace

std::string toJson(const RunRecord &record, JsonColumns columns)
{
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (const RunColumn &column : runColumns())
        if (columns == JsonColumns::all || column.inSolveJson)
            object[std::string(column.name)] = toJson(column.get(record));
    if (columns == JsonColumns::all)
        for (const auto &[name, value] : record.extra)
            object[name] = toJson(value);
    return object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace mrpp
