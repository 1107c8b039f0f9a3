#include "framework/PluginLoader.h"

#include "framework/Plugin.h"
#include "framework/run/RunRecord.h"
#include "framework/support/Error.h"

#include <algorithm>
#include <dlfcn.h>
#include <set>

namespace mrpp
{

namespace
{

constexpr Plugin kThis = {MRPP_ABI_VERSION, MRPP_ABI_HEADERS, kAbiCompiler, kAbiLibrary, kAbiChecks, nullptr};

std::string described(const Plugin &plugin)
{
    const std::string checks = plugin.checks;
    return std::string("version ") + plugin.version + " (headers " +
           std::string(plugin.headers).substr(0, 8) + ") with " + plugin.compiler + " and " + plugin.library +
           (checks.empty() ? "" : ", under " + checks);
}

bool fits(const Plugin &plugin)
{
    const auto identity = [](const Plugin &p) {
        return std::vector<std::string>{p.version, p.headers, p.compiler, p.library, p.checks};
    };
    return identity(plugin) == identity(kThis);
}

/// The measures must be columns of their own.
void checkMetrics(const Catalog &catalog, const std::filesystem::path &file)
{
    std::set<std::string> names;
    for (const AddedMetric &metric : catalog.metrics)
    {
        if (metric.name.empty() || !metric.measure)
            throw InputError({file.string()}, "brings a metric without a name or without its function");
        if (findRunColumn(metric.name) != nullptr || !names.insert(metric.name).second)
            throw InputError({file.string()},
                             "brings a metric '" + metric.name + "', but there is one already");
    }
}

} // namespace

void loadPlugin(Catalog &catalog, const std::filesystem::path &file)
{
    std::error_code error;
    const std::filesystem::path path = std::filesystem::canonical(file, error);
    if (error)
        throw FileError({file.string()}, "there is no such plugin");
    if (std::find(catalog.plugins.begin(), catalog.plugins.end(), path) != catalog.plugins.end())
        return;
    void *library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        throw InputError({file.string()}, std::string("cannot be loaded: ") + ::dlerror());
    const auto *plugin = static_cast<const Plugin *>(::dlsym(library, "mrppPlugin"));
    if (plugin == nullptr)
        throw InputError({file.string()},
                         "is a library, but no plugin: it has no MRPP_PLUGIN (framework/Plugin.h)");
    if (!fits(*plugin))
        throw InputError({file.string()}, "was built against " + described(*plugin) + ", but this is " +
                                              described(kThis) +
                                              "; build it again against the package of this version");
    try
    {
        plugin->add(catalog);
    }
    catch (const std::logic_error &taken)
    {
        throw InputError({file.string()}, taken.what());
    }
    checkMetrics(catalog, file);
    catalog.plugins.push_back(path);
}

} // namespace mrpp
