#pragma once
/// \file
/// A parsed XML text that still knows where its elements stand. Internal to the readers of
/// this folder.

#include "framework/support/Error.h"

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace mrpp
{

class XmlDocument
{
public:
    /// Throws ParseError at the place where the text stops being well-formed XML.
    /// \param text must outlive the document
    XmlDocument(std::string_view text, std::string file);

    [[nodiscard]] std::string_view text() const { return text_; }

    /// The outermost element; none in a text without elements.
    [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }

    /// The place of an element's `<`. O(file), in total too where places are asked for in their order.
    [[nodiscard]] SourceLocation where(pugi::xml_node element) const;

    [[noreturn]] void fail(pugi::xml_node element, const std::string &what) const;

    /// The value of an attribute that has to be there. Throws ParseError where it is missing.
    [[nodiscard]] std::string_view required(pugi::xml_node element, const char *attribute) const;

    /// Throws ParseError where an element has an attribute twice.
    void checkAttributes(pugi::xml_node element) const;

private:
    [[nodiscard]] SourceLocation locate(std::size_t offset) const;

    std::string_view text_;
    std::string file_;
    pugi::xml_document document_;
    mutable std::size_t knownOffset_ = 0; ///< of the place that was located last, and its line
    mutable std::size_t knownLine_ = 1;
};

/// An element's name without its namespace prefix.
[[nodiscard]] std::string_view localName(pugi::xml_node element);

/// Which elements are of the namespace of the outermost one, whatever their prefixes.
class XmlNamespace
{
public:
    /// O(text).
    explicit XmlNamespace(const XmlDocument &document);

    [[nodiscard]] bool contains(pugi::xml_node element) const;

private:
    std::vector<std::string_view> prefixes_;   ///< that mean the namespace everywhere
    bool isScoped_ = false;                    ///< prefixes are declared within the document, too
    std::unordered_set<std::size_t> elements_; ///< of the namespace, where prefixes do not tell
};

} // namespace mrpp
