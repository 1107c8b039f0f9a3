#include "problems/formats/GraphMlData.h"

#include "framework/support/Config.h"
#include "framework/support/Suggestion.h"
#include "problems/formats/support/TextReader.h"

#include <algorithm>
#include <cctype>

namespace mrpp
{

namespace
{
bool equalIgnoringCase(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}
} // namespace

GraphMlData::GraphMlData(const XmlDocument &document) : document_(document), namespace_(document)
{
    for (const pugi::xml_node child : document.root().children())
    {
        if (!isOurs(child) || localName(child) != "key")
            continue;
        document.checkAttributes(child);
        Key key{child,
                document.required(child, "id"),
                child.attribute("attr.name").value(),
                child.attribute("for").value(),
                {}};
        for (const pugi::xml_node part : child.children())
            if (isOurs(part) && localName(part) == "default")
                key.defaultValue = textOf(part);
        if (!positions_.emplace(key.id, keys_.size()).second)
            document.fail(child, "a key " + inQuotes(key.id) + " is declared already");
        keys_.push_back(key);
    }
    point_ = findNamed("node", {"Coordinate", "coords", "pos", "position"});
    axes_ = {findNamed("node", {"x"}), findNamed("node", {"y"}), findNamed("node", {"z"})};
    weight_ = findNamed("edge", {"Weight", "length", "distance", "cost"});
    yAxis_ = findNamed("graph", {"YAxis"});
    for (const Key &key : keys_)
        if (equalIgnoringCase(key.element.attribute("yfiles.type").value(), "nodegraphics"))
            box_ = &key;
}

bool GraphMlData::isOurs(pugi::xml_node element) const
{
    return namespace_.contains(element);
}

bool GraphMlData::isStranger(pugi::xml_node element) const
{
    const std::string_view name = localName(element);
    return element.type() == pugi::node_element && !isOurs(element) &&
           (name == "node" || name == "edge" || name == "graph" || name == "key" || name == "data");
}

const GraphMlData::Key *GraphMlData::find(std::string_view id) const
{
    const auto found = positions_.find(id);
    return found == positions_.end() ? nullptr : &keys_[found->second];
}

const GraphMlData::Key *GraphMlData::findNamed(std::string_view scope,
                                               std::initializer_list<const char *> names) const
{
    for (const char *name : names)
        for (const Key &key : keys_)
            if ((key.scope == scope || key.scope == "all" || key.scope.empty()) &&
                equalIgnoringCase(key.name, name))
                return &key;
    return nullptr;
}

void GraphMlData::checkName(pugi::xml_node element, std::initializer_list<const char *> known) const
{
    const std::string_view name = localName(element);
    if (std::find(known.begin(), known.end(), name) == known.end())
        document_.fail(element, "<" + std::string(element.name()) + "> does not belong into a <" +
                                    std::string(element.parent().name()) + ">" +
                                    suggestion(name, std::vector<std::string>(known.begin(), known.end())));
}

void GraphMlData::checkContent(pugi::xml_node element) const
{
    for (const pugi::xml_node child : element.children())
    {
        if (!isOurs(child))
            continue;
        if (localName(child) == "graph")
            document_.fail(child,
                           "a graph within a node; a file holds one graph (ungroup it before exporting)");
        checkName(child, {"data", "desc", "port"});
        if (localName(child) == "data" && find(document_.required(child, "key")) == nullptr)
            document_.fail(child,
                           "there is no <key> with the id " + inQuotes(child.attribute("key").value()));
    }
}

pugi::xml_node GraphMlData::dataElement(pugi::xml_node element, const Key &key) const
{
    for (const pugi::xml_node child : element.children())
        if (isOurs(child) && localName(child) == "data" && key.id == child.attribute("key").value())
            return child;
    return {};
}

/// What stands in an element, be it as CDATA.
std::string_view GraphMlData::textOf(pugi::xml_node element) const
{
    std::string_view text;
    for (const pugi::xml_node child : element.children())
    {
        const std::string_view piece = trimmed(child.value());
        if ((child.type() != pugi::node_pcdata && child.type() != pugi::node_cdata) || piece.empty())
            continue;
        if (!text.empty())
            document_.fail(element, "something stands amid the text here; expected the text alone");
        text = piece;
    }
    return text;
}

/// The text that an element gives to a key, or the key's default; empty where there is neither.
std::string_view GraphMlData::valueOf(pugi::xml_node element, const Key &key) const
{
    const pugi::xml_node data = dataElement(element, key);
    return data ? textOf(data) : key.defaultValue;
}

/// The data element of that key, or the key itself where its default is to blame.
pugi::xml_node GraphMlData::placeOf(pugi::xml_node element, const Key &key) const
{
    const pugi::xml_node data = dataElement(element, key);
    return data ? data : key.element;
}

double GraphMlData::number(pugi::xml_node place, std::string_view text, const char *what) const
{
    const auto value = parseNumber(text);
    if (!value)
        document_.fail(place, inQuotes(text) + " is no number, but the " + what + " must be one");
    return *value;
}

std::optional<Point> GraphMlData::coordinate(pugi::xml_node node) const
{
    if (point_ != nullptr)
    {
        const std::string_view text = valueOf(node, *point_);
        return text.empty() ? std::nullopt : std::optional(parsePoint(node, text));
    }
    if (axes_[0] != nullptr && axes_[1] != nullptr)
        return separateAxes(node);
    return box_ == nullptr ? std::nullopt : boxCentre(node);
}

Point GraphMlData::parsePoint(pugi::xml_node node, std::string_view text) const
{
    constexpr std::string_view separators = " \t\r\n,;()[]";
    std::array<double, 3> numbers{};
    std::size_t count = 0;
    bool wellFormed = true;
    for (std::string_view rest = text; wellFormed;)
    {
        rest.remove_prefix(std::min(rest.find_first_not_of(separators), rest.size()));
        if (rest.empty())
            break;
        const std::size_t end = std::min(rest.find_first_of(separators), rest.size());
        const auto value = parseNumber(rest.substr(0, end));
        wellFormed = value && count < numbers.size();
        if (wellFormed)
            numbers[count++] = *value;
        rest.remove_prefix(end);
    }
    if (!wellFormed || count < 2)
        document_.fail(placeOf(node, *point_),
                       inQuotes(text) + " is no coordinate; expected two or three numbers, as in '0.5 2 0'");
    return {numbers[0], numbers[1], numbers[2]};
}

std::optional<Point> GraphMlData::separateAxes(pugi::xml_node node) const
{
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
        if (axes_[i] == nullptr) // z; the others are there
            continue;
        const std::string_view text = valueOf(node, *axes_[i]);
        if (!text.empty())
            numbers[i] = number(placeOf(node, *axes_[i]), text, "coordinate");
        else if (i < 2)
            return std::nullopt;
    }
    return Point{numbers[0], numbers[1], numbers[2]};
}

/// yEd keeps the upper left corner and the size of the box that it draws.
std::optional<Point> GraphMlData::boxCentre(pugi::xml_node node) const
{
    for (const pugi::xml_node shape : dataElement(node, *box_).children())
        for (const pugi::xml_node part : shape.children())
        {
            if (localName(part) != "Geometry")
                continue;
            if (!part.attribute("x") && !part.attribute("y"))
                return std::nullopt; // never laid out
            const auto read = [&](const char *name)
            { return number(part, document_.required(part, name), name); };
            return Point{read("x") + read("width") / 2, read("y") + read("height") / 2, 0};
        }
    return std::nullopt;
}

double GraphMlData::weight(pugi::xml_node edge) const
{
    if (weight_ == nullptr)
        return 1;
    const std::string_view text = valueOf(edge, *weight_);
    return text.empty() ? 1 : number(placeOf(edge, *weight_), text, "weight");
}

YAxis GraphMlData::yAxis(pugi::xml_node graph) const
{
    if (yAxis_ == nullptr)
    {
        const bool drawnByYEd =
            point_ == nullptr && (axes_[0] == nullptr || axes_[1] == nullptr) && box_ != nullptr;
        return drawnByYEd ? YAxis::down : YAxis::up;
    }
    const std::string_view text = valueOf(graph, *yAxis_);
    if (!text.empty() && text != "up" && text != "down")
        document_.fail(placeOf(graph, *yAxis_),
                       "the graph's YAxis is " + inQuotes(text) + "; expected 'up' or 'down'");
    return text == "down" ? YAxis::down : YAxis::up;
}

} // namespace mrpp
