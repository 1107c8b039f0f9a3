#pragma once
/// \file
/// Subclass Report to add a way to show a campaign's results.

#include "framework/store/Provenance.h"
#include "framework/store/ResultTable.h"

#include <filesystem>
#include <vector>

namespace mrpp
{

class Report
{
public:
    Report() = default;
    virtual ~Report() = default;
    Report(const Report &) = delete;
    Report &operator=(const Report &) = delete;

    /// Writes its files into the campaign's folder and returns their paths. The same results give the same
    /// files. Throws FileError where a file cannot be written; whatever cannot be drawn is said in
    /// the report and does not stop it.
    [[nodiscard]] virtual std::vector<std::filesystem::path>
    write(const ResultTable &results, const Provenance &provenance,
          const std::filesystem::path &folder) const = 0;
};

} // namespace mrpp
