#pragma once
/// \file
/// A list of named factories, filled by explicit functions (`registerAlgorithms(catalog)`), never by static
/// constructors, which linkers drop from static libraries.

#include "framework/support/Error.h"
#include "framework/support/Suggestion.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

template <class T>
class Registry
{
public:
    struct Entry
    {
        std::string name;
        std::string description; ///< one line
        std::function<std::unique_ptr<T>()> make;
    };

    /// \param kind what the entries are, for messages: "planner", "problem", …
    explicit Registry(std::string kind) : kind_(std::move(kind)) {}

    /// Throws std::logic_error where the name is taken.
    void add(std::string name, std::string description, std::function<std::unique_ptr<T>()> make)
    {
        if (find(name) != nullptr)
            throw std::logic_error("a " + kind_ + " named '" + name + "' is registered already");
        entries_.push_back({std::move(name), std::move(description), std::move(make)});
    }

    /// Registers a default-constructible class.
    template <class Derived>
    void add(std::string name, std::string description)
    {
        add(std::move(name), std::move(description), [] { return std::make_unique<Derived>(); });
    }

    /// A new object. Throws InputError for an unknown name, with the nearest known one.
    [[nodiscard]] std::unique_ptr<T> create(std::string_view name) const
    {
        if (const Entry *entry = find(name))
            return entry->make();
        throw InputError("there is no " + kind_ + " '" + std::string(name) + "'" + suggestion(name, names()));
    }

    [[nodiscard]] const Entry *find(std::string_view name) const
    {
        for (const Entry &entry : entries_)
            if (entry.name == name)
                return &entry;
        return nullptr;
    }

    [[nodiscard]] const std::vector<Entry> &entries() const { return entries_; }

    [[nodiscard]] std::vector<std::string> names() const
    {
        std::vector<std::string> list;
        for (const Entry &entry : entries_)
            list.push_back(entry.name);
        return list;
    }

private:
    std::string kind_;
    std::vector<Entry> entries_;
};

} // namespace mrpp
