#include "framework/support/Error.h"

namespace mrpp
{

std::string SourceLocation::toString() const
{
    std::string text = file;
    if (line > 0)
    {
        text += ":" + std::to_string(line);
        if (column > 0)
            text += ":" + std::to_string(column);
    }
    return text;
}

namespace
{
std::string located(const SourceLocation &where, const std::string &what)
{
    const std::string place = where.toString();
    return place.empty() ? what : place + ": " + what;
}
} // namespace

InputError::InputError(const std::string &what) : std::runtime_error(what), complaint_(what) {}

InputError::InputError(SourceLocation where, const std::string &what)
    : std::runtime_error(located(where, what)), where_(std::move(where)), complaint_(what)
{}

} // namespace mrpp
