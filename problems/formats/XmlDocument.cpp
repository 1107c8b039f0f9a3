#include "problems/formats/XmlDocument.h"

#include "problems/formats/TextReader.h"

#include <algorithm>
#include <array>
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
        throw ParseError(locate(0), "this is UTF-16; expected UTF-8");
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

std::string_view namespacePrefix(pugi::xml_node element)
{
    const std::string_view name = element.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? std::string_view() : name.substr(0, colon);
}

} // namespace mrpp
