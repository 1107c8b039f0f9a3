#pragma once
/// \file
/// A shared library with planners, problems, optimizers, metrics or reports, which the program loads when it
/// starts: `mrppsim run plan.yaml --plugin ./libmine.so`.
///
/// \code
/// #include "framework/Plugin.h"
///
/// MRPP_PLUGIN(catalog)
/// {
///     catalog.planners.add<MyPlanner>("my_planner", "one line about it");
///     catalog.metrics.push_back({.name = "turns", .title = "Turns", .measure = countTurns});
/// }
/// \endcode
///
/// C++ libraries fit together only where headers, compiler and standard library are the same on both sides.
/// The macro notes what it was compiled with, and the program refuses what does not fit, saying why.

#include "framework/AbiVersion.h" // made by the build
#include "framework/Catalog.h"

namespace mrpp
{

#if defined(__clang__)
inline constexpr const char *kAbiCompiler = "Clang " MRPP_ABI_TEXT(__clang_major__);
#else
inline constexpr const char *kAbiCompiler = "GCC " MRPP_ABI_TEXT(__GNUC__);
#endif

#if defined(_GLIBCXX_RELEASE) && defined(_GLIBCXX_DEBUG)
inline constexpr const char *kAbiLibrary = "libstdc++ " MRPP_ABI_TEXT(_GLIBCXX_RELEASE) " in debug mode";
#elif defined(_GLIBCXX_RELEASE) && _GLIBCXX_USE_CXX11_ABI
inline constexpr const char *kAbiLibrary = "libstdc++ " MRPP_ABI_TEXT(_GLIBCXX_RELEASE);
#elif defined(_GLIBCXX_RELEASE)
inline constexpr const char *kAbiLibrary =
    "libstdc++ " MRPP_ABI_TEXT(_GLIBCXX_RELEASE) " with its old strings";
#else
inline constexpr const char *kAbiLibrary = "another standard library";
#endif

#if defined(__SANITIZE_ADDRESS__)
inline constexpr const char *kAbiChecks = "the address sanitizer";
#elif defined(__SANITIZE_THREAD__)
inline constexpr const char *kAbiChecks = "the thread sanitizer";
#else
inline constexpr const char *kAbiChecks = "";
#endif

/// What a shared library says of itself. Only texts, so that any version can read it of any other.
struct Plugin
{
    const char *version;  ///< of this project
    const char *headers;  ///< a hash of the framework's
    const char *compiler; ///< name and major version
    const char *library;  ///< the standard library
    const char *checks;   ///< sanitizers, which change memory's layout
    void (*add)(Catalog &);
};

} // namespace mrpp

/// Begins the function that adds a plugin's classes; once a library.
#define MRPP_PLUGIN(catalog)                                                                                 \
    static void mrppPluginAdd(mrpp::Catalog &(catalog));                                                     \
    extern "C" __attribute__((visibility("default"))) const mrpp::Plugin mrppPlugin;                         \
    const mrpp::Plugin mrppPlugin = {MRPP_ABI_VERSION,  MRPP_ABI_HEADERS, mrpp::kAbiCompiler,                \
                                     mrpp::kAbiLibrary, mrpp::kAbiChecks, &mrppPluginAdd};                   \
    static void mrppPluginAdd([[maybe_unused]] mrpp::Catalog &(catalog))
