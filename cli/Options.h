#pragma once
/// \file
/// Options that several commands have. Only for the sources that know the parsing library.

#include "framework/support/Config.h"
#include "framework/support/Suggestion.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

/// Refuses what is none of the words, with the nearest one.
inline CLI::Validator oneOf(const std::vector<std::string> &words)
{
    std::string description;
    for (const std::string &word : words)
        description += (description.empty() ? "" : "|") + word;
    return {[words](std::string &word) -> std::string
            {
                if (std::find(words.begin(), words.end(), word) != words.end())
                    return {};
                return "'" + word + "' is not known" + suggestion(word, words);
            },
            description};
}

inline CLI::Validator numberAbove0()
{
    return {[](std::string &text) -> std::string
            {
                const auto number = parseNumber(text);
                return number && *number > 0 ? std::string() : "'" + text + "' is not a number above 0";
            },
            ""};
}

inline CLI::Validator wholeNumberFrom(std::int64_t low)
{
    return {[low](std::string &text) -> std::string
            {
                const auto number = parseInteger(text);
                return number && *number >= low
                           ? std::string()
                           : "'" + text + "' is not a whole number from " + std::to_string(low) + " on";
            },
            ""};
}

template <class T>
CLI::Option *optional(CLI::App &command, const std::string &flag, std::optional<T> &slot,
                      const std::string &help)
{
    if constexpr (std::is_same_v<T, std::filesystem::path>)
        return command
            .add_option_function<std::string>(
                flag, [&slot](const std::string &text) { slot = text; }, help)
            ->type_name("FILE");
    else
        return command.add_option_function<T>(
            flag, [&slot](const T &value) { slot = value; }, help);
}

} // namespace mrpp
