#pragma once
/// \file
/// Every reader of a format with a small file that it reads, for tests that give it other ones.

#include "problems/formats/FormatId.h"

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace mrpp
{

struct FormatReader
{
    const char *name;
    FormatId id;
    std::string good;
    std::function<void(const std::string &)> read; ///< throws InputError for what is malformed
};

void PrintTo(const FormatReader &format, std::ostream *out);

[[nodiscard]] std::vector<FormatReader> formatReaders();

} // namespace mrpp
