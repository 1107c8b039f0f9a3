#include "framework/store/Provenance.h"

#include "framework/support/Error.h"

#include "Revision.h" // made by the build

#include <boost/version.hpp>
#include <fmt/core.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <openssl/crypto.h>
#include <sqlite3.h>
#include <sys/utsname.h>
#include <thread>
#include <unistd.h>

namespace mrpp
{

namespace
{

/// What follows `key`, its separator and blanks in the first line that begins with it.
std::string lineOf(const char *file, const std::string &key, char separator)
{
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
    {
        if (!line.starts_with(key))
            continue;
        const std::size_t start = line.find_first_not_of(" \t\"", line.find(separator) + 1);
        const std::size_t end = line.find_last_not_of(" \t\"");
        return start == std::string::npos ? std::string() : line.substr(start, end + 1 - start);
    }
    return {};
}

std::string compilerName()
{
#if defined(__clang__)
    return "clang " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

/// Calls visit(name, member) for each field, in the order of the file.
template <class Record, class Visitor>
void forEachField(Record &record, Visitor &&visit)
{
    visit("campaign", record.campaign);
    visit("seed", record.seed);
    visit("plan_file", record.planFile);
    visit("plan_folder", record.planFolder);
    visit("map_folders", record.mapFolders);
    visit("plan_fingerprint", record.planFingerprint);
    visit("started", record.started);
    visit("finished", record.finished);
    visit("version", record.version);
    visit("revision", record.revision);
    visit("compiler", record.compiler);
    visit("build_type", record.buildType);
    visit("libraries", record.libraries);
    visit("host", record.host);
    visit("system", record.system);
    visit("cpu", record.cpu);
    visit("cores", record.cores);
    visit("memory", record.memory);
}

} // namespace

Provenance Provenance::here()
{
    Provenance here;
    here.version = MRPP_VERSION;
    here.revision = MRPP_REVISION;
    here.compiler = compilerName();
    here.buildType = MRPP_BUILD_TYPE;
    here.cpu = lineOf("/proc/cpuinfo", "model name", ':');
    here.cores = std::thread::hardware_concurrency();
    here.memory =
        static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGE_SIZE)) / 1e6;
    utsname system{};
    if (::uname(&system) == 0)
    {
        here.host = system.nodename;
        here.system = std::string(system.sysname) + " " + system.release;
    }
    if (const std::string distribution = lineOf("/etc/os-release", "PRETTY_NAME", '='); !distribution.empty())
        here.system += ", " + distribution;
    here.libraries = {
        fmt::format("Boost {}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                    BOOST_VERSION % 100),
        fmt::format("SQLite {}", sqlite3_libversion()),
        OpenSSL_version(OPENSSL_VERSION),
        fmt::format("fmt {}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100),
        fmt::format("nlohmann-json {}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                    NLOHMANN_JSON_VERSION_PATCH),
    };
    return here;
}

std::string Provenance::toJson() const
{
    nlohmann::ordered_json object;
    forEachField(*this, [&object](const char *name, const auto &field) { object[name] = field; });
    return object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Provenance Provenance::fromJson(const std::string &text, const std::filesystem::path &file)
{
    try
    {
        const auto object = nlohmann::json::parse(text);
        Provenance provenance;
        forEachField(provenance, [&object](const char *name, auto &field)
                     { field = object.at(name).get<std::remove_reference_t<decltype(field)>>(); });
        return provenance;
    }
    catch (const nlohmann::json::exception &error)
    {
        throw ParseError({file.string()}, std::string("is no provenance: ") + error.what());
    }
}

} // namespace mrpp
