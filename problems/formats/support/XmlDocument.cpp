#include "problems/formats/support/XmlDocument.h"

#include "problems/formats/support/TextReader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace mrpp
{

namespace
{
const char *explain(pugi::xml_parse_status status)
{
    switch (status)
    {
    case pugi::status_no_document_element:
        return "there is no element";
    case pugi::status_end_element_mismatch:
        return "an end tag that does not fit the element that is open here (or one that is never closed)";
    case pugi::status_bad_start_element:
        return "a tag that is cut short or has a broken name";
    case pugi::status_bad_end_element:
        return "an end tag that is cut short or has a broken name";
    case pugi::status_bad_attribute:
        return "a broken attribute; expected name=\"value\" (is a quotation mark missing?)";
    case pugi::status_bad_cdata:
        return "a CDATA section that is not closed by ']]>'";
    case pugi::status_bad_comment:
        return "a comment that is not closed by '-->'";
    case pugi::status_bad_pi:
        return "a processing instruction that is not closed by '?>'";
    case pugi::status_bad_doctype:
        return "a broken document type declaration";
    case pugi::status_out_of_memory:
        return "the file is too large for the memory";
    default:
        return "something that is no XML";
    }
}
} // namespace

XmlDocument::XmlDocument(std::string_view text, std::string file)
    : text_(withoutByteOrderMark(text)), file_(std::move(file))
{
    if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF"))
        throw ParseError(locate(0), "this is a text in UTF-16; expected UTF-8");
    const std::size_t first = text_.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text_[first] != '<')
        throw ParseError(locate(std::min(first, text_.size())),
                         std::string("not XML: ") + explain(pugi::status_no_document_element));
    const pugi::xml_parse_result result =
        document_.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result)
        throw ParseError(locate(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0))),
                         std::string("not well-formed XML: ") + explain(result.status));
    for (pugi::xml_node other = root().next_sibling(); other; other = other.next_sibling())
        if (other.type() == pugi::node_element)
            fail(other, "not well-formed XML: a second outermost element");
}

SourceLocation XmlDocument::locate(std::size_t offset) const
{
    const std::string_view before = text_.substr(0, offset);
    if (before.size() < knownOffset_)
    {
        knownOffset_ = 0;
        knownLine_ = 1;
    }
    const std::string_view since = before.substr(knownOffset_);
    knownLine_ += static_cast<std::size_t>(std::count(since.begin(), since.end(), '\n'));
    knownOffset_ = before.size();
    const std::size_t lineStart = before.rfind('\n') + 1; // npos + 1 is 0
    return {file_, knownLine_, before.size() - lineStart + 1};
}

SourceLocation XmlDocument::where(pugi::xml_node element) const
{
    const std::ptrdiff_t name = element.offset_debug();
    return name < 1 ? SourceLocation{file_, 1, 1} : locate(static_cast<std::size_t>(name) - 1);
}

void XmlDocument::fail(pugi::xml_node element, const std::string &what) const
{
    throw ParseError(where(element), what);
}

std::string_view XmlDocument::required(pugi::xml_node element, const char *attribute) const
{
    const std::string_view value = element.attribute(attribute).value();
    if (value.empty())
        fail(element, "a <" + std::string(localName(element)) + "> needs an attribute '" + attribute + "'");
    return value;
}

void XmlDocument::checkAttributes(pugi::xml_node element) const
{
    const auto refuse = [&](std::string_view name)
    { fail(element, "the attribute " + inQuotes(name) + " stands twice"); };
    constexpr std::size_t few = 8;
    std::array<std::string_view, few> names;
    std::size_t count = 0;
    std::unordered_set<std::string_view>
        more; // nobody writes so many, but a quadratic search would take hours
    for (const pugi::xml_attribute attribute : element.attributes())
    {
        const std::string_view name = attribute.name();
        if (std::find(names.begin(), names.begin() + count, name) != names.begin() + count ||
            (count == few && !more.insert(name).second))
            refuse(name);
        if (count < few)
            names[count++] = name;
    }
}

std::string_view localName(pugi::xml_node element)
{
    const std::string_view name = element.name();
    return name.substr(name.find(':') + 1); // npos + 1 is 0
}

namespace
{

/// The namespace prefix of an element's name; empty where it has none.
std::string_view prefixOf(pugi::xml_node element)
{
    const std::string_view name = element.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? std::string_view() : name.substr(0, colon);
}

/// The prefix that an attribute declares, if it declares one: `xmlns` declares the empty one.
std::optional<std::string_view> declaredPrefix(pugi::xml_attribute attribute)
{
    constexpr std::string_view kDeclaration = "xmlns";
    const std::string_view name = attribute.name();
    if (!name.starts_with(kDeclaration))
        return std::nullopt;
    if (name.size() == kDeclaration.size())
        return std::string_view();
    return name[kDeclaration.size()] == ':' ? std::optional(name.substr(kDeclaration.size() + 1))
                                            : std::nullopt;
}

/// The addresses that prefixes stand for, as elements are entered and left.
class Bindings
{
public:
    /// How many the element declares.
    std::size_t enter(pugi::xml_node element)
    {
        std::size_t count = 0;
        for (const pugi::xml_attribute attribute : element.attributes())
            if (const auto prefix = declaredPrefix(attribute))
            {
                addresses_[*prefix].push_back(attribute.value());
                order_.push_back(*prefix);
                ++count;
            }
        return count;
    }

    void leave(std::size_t count)
    {
        for (; count > 0; --count)
        {
            addresses_[order_.back()].pop_back();
            order_.pop_back();
        }
    }

    /// An unknown prefix stands for itself; without prefix and declaration there is no address.
    [[nodiscard]] std::string_view addressOf(pugi::xml_node element) const
    {
        const std::string_view prefix = prefixOf(element);
        const auto found = addresses_.find(prefix);
        return found == addresses_.end() || found->second.empty() ? prefix : found->second.back();
    }

private:
    std::unordered_map<std::string_view, std::vector<std::string_view>> addresses_;
    std::vector<std::string_view> order_;
};

/// How often a text declares a prefix, as far as one can tell without parsing: at least as often as it does.
std::size_t declarationsIn(std::string_view text)
{
    constexpr std::string_view kDeclaration = "xmlns"; // addresses have it behind a slash
    constexpr std::string_view kBlanks = " \t\r\n";
    std::size_t count = 0;
    for (std::size_t at = text.find(kDeclaration); at != std::string_view::npos;
         at = text.find(kDeclaration, at + 1))
        count += at > 0 && kBlanks.find(text[at - 1]) != std::string_view::npos ? 1 : 0;
    return count;
}

} // namespace

XmlNamespace::XmlNamespace(const XmlDocument &document)
{
    const pugi::xml_node root = document.root();
    Bindings bindings;
    const std::size_t declared = bindings.enter(root);
    const std::string_view address = bindings.addressOf(root);
    prefixes_.push_back(prefixOf(root));
    for (const pugi::xml_attribute attribute : root.attributes())
        if (const auto prefix = declaredPrefix(attribute); prefix && attribute.value() == address)
            prefixes_.push_back(*prefix);
    isScoped_ = declarationsIn(document.text()) > declared;
    if (!isScoped_)
        return;
    std::vector<std::size_t> counts = {declared};
    elements_.insert(root.hash_value());
    for (pugi::xml_node element = root.first_child(); element && element != root;)
    {
        counts.push_back(bindings.enter(element));
        if (bindings.addressOf(element) == address)
            elements_.insert(element.hash_value());
        if (element.first_child())
        {
            element = element.first_child();
            continue;
        }
        for (;;)
        {
            bindings.leave(counts.back());
            counts.pop_back();
            if (element == root)
                return;
            if (element.next_sibling())
            {
                element = element.next_sibling();
                break;
            }
            element = element.parent();
        }
    }
}

bool XmlNamespace::contains(pugi::xml_node element) const
{
    if (element.type() != pugi::node_element)
        return false;
    if (isScoped_)
        return elements_.contains(element.hash_value());
    const std::string_view prefix = prefixOf(element);
    return std::find(prefixes_.begin(), prefixes_.end(), prefix) != prefixes_.end();
}

} // namespace mrpp
