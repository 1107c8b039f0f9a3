#pragma once
/// \file
/// Where results come from: program, machine, plan, time. Written as provenance.json, shown by every report.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace mrpp
{

struct Provenance
{
    std::string version;   ///< of the program
    std::string revision;  ///< of its source ("" outside a checkout), with "-dirty" where changed
    std::string compiler;  ///< name and version
    std::string buildType; ///< Release, Debug, …
    std::string host;
    std::string system; ///< kernel and distribution
    std::string cpu;    ///< model name
    std::int64_t cores = 0;
    double memory = 0;    ///< MB installed
    std::string started;  ///< UTC, ISO 8601, of the campaign's first start
    std::string finished; ///< of its last run; empty while it runs
    std::string campaign;
    std::string planFile;                ///< the plan's file name
    std::string planFolder;              ///< where its relative paths start
    std::vector<std::string> mapFolders; ///< and where they are looked for besides
    std::string planFingerprint;
    std::int64_t seed = 0;
    std::vector<std::string> libraries; ///< "SQLite 3.40.1", …

    /// Of this program on this machine now, without the campaign's part.
    [[nodiscard]] static Provenance here();

    [[nodiscard]] std::string toJson() const;
    /// Throws ParseError.
    [[nodiscard]] static Provenance fromJson(const std::string &text, const std::filesystem::path &file);
};

} // namespace mrpp
