#include "cli/Plugins.h"

#include "framework/PluginLoader.h"
#include "framework/support/Error.h"

#include <string_view>

namespace mrpp
{

std::vector<const char *> takePlugins(int count, const char *const *words, Catalog &catalog)
{
    constexpr std::string_view kOption = "--plugin";
    constexpr std::string_view kWithValue = "--plugin=";
    std::vector<const char *> rest;
    for (int i = 0; i < count; ++i)
    {
        const std::string_view word = words[i];
        if (word.starts_with(kWithValue))
            loadPlugin(catalog, word.substr(kWithValue.size()));
        else if (word != kOption)
            rest.push_back(words[i]);
        else if (++i < count)
            loadPlugin(catalog, words[i]);
        else
            throw InputError("--plugin needs a file: --plugin ./libmine.so");
    }
    return rest;
}

} // namespace mrpp
