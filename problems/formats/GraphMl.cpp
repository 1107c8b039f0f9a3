#include "problems/formats/GraphMl.h"

#include "framework/support/Config.h"
#include "framework/support/File.h"
#include "framework/support/Suggestion.h"
#include "problems/formats/TextReader.h"
#include "problems/formats/XmlDocument.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <unordered_map>

namespace mrpp
{

namespace
{

bool equalIgnoringCase(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// "1 vertex" or "3 vertices", to begin a warning with.
std::string counted(std::size_t count, const char *one, const char *many)
{
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

class Reader
{
public:
    Reader(std::string_view text, const std::string &file) : document_(text, file) {}

    GraphMl read()
    {
        const pugi::xml_node root = document_.root();
        if (localName(root) != "graphml")
            document_.fail(root, "the outermost element is <" + std::string(root.name()) +
                                     ">, but GraphML begins with <graphml>");
        prefix_ = namespacePrefix(root);
        readKeys(root);
        const pugi::xml_node graph = onlyGraph(root);
        readDirection(graph);
        readNodes(graph);
        readEdges(graph);
        warnAboutIds();
        GraphMl result;
        result.graph = Graph::fromEdges(nodes_.size(), edges_, takeCoordinates(), yAxis_);
        warnAboutEdges(*result.graph);
        result.warnings = std::move(warnings_);
        return result;
    }

private:
    struct Key
    {
        pugi::xml_node element;
        std::string_view id;
        std::string_view name;
        std::string_view scope; ///< node, edge, graph, all, …
        std::string_view defaultValue;
    };

    [[nodiscard]] bool isOurs(pugi::xml_node element) const
    {
        return element.type() == pugi::node_element && namespacePrefix(element) == prefix_;
    }

    void readKeys(pugi::xml_node root)
    {
        for (const pugi::xml_node child : root.children())
        {
            if (!isOurs(child) || localName(child) != "key")
                continue;
            document_.checkAttributes(child);
            Key key{child,
                    document_.required(child, "id"),
                    child.attribute("attr.name").value(),
                    child.attribute("for").value(),
                    {}};
            for (const pugi::xml_node part : child.children())
                if (isOurs(part) && localName(part) == "default")
                    key.defaultValue = trimmed(part.child_value());
            if (findKey(key.id) != nullptr)
                document_.fail(child, "a key " + inQuotes(key.id) + " is declared already");
            keys_.push_back(key);
        }
        constexpr std::array pointNames = {"Coordinate", "coords", "pos", "position"};
        constexpr std::array weightNames = {"Weight", "length", "distance", "cost"};
        point_ = findNamed("node", pointNames);
        axes_ = {findNamed("node", std::array{"x"}), findNamed("node", std::array{"y"}),
                 findNamed("node", std::array{"z"})};
        weight_ = findNamed("edge", weightNames);
        axis_ = findNamed("graph", std::array{"YAxis"});
        for (const Key &key : keys_)
            if (equalIgnoringCase(key.element.attribute("yfiles.type").value(), "nodegraphics"))
                geometry_ = &key;
    }

    [[nodiscard]] const Key *findKey(std::string_view id) const
    {
        const auto found =
            std::find_if(keys_.begin(), keys_.end(), [id](const Key &key) { return key.id == id; });
        return found == keys_.end() ? nullptr : &*found;
    }

    template <class Names>
    [[nodiscard]] const Key *findNamed(std::string_view scope, const Names &names) const
    {
        for (const char *name : names)
            for (const Key &key : keys_)
                if ((key.scope == scope || key.scope == "all" || key.scope.empty()) &&
                    equalIgnoringCase(key.name, name))
                    return &key;
        return nullptr;
    }

    [[nodiscard]] pugi::xml_node onlyGraph(pugi::xml_node root) const
    {
        pugi::xml_node graph;
        for (const pugi::xml_node child : root.children())
        {
            if (!isOurs(child))
                continue;
            if (localName(child) == "graph")
            {
                if (graph)
                    document_.fail(child, "a second <graph>; a file holds one");
                graph = child;
            }
            else
            {
                checkName(child, {"key", "data", "desc"});
            }
        }
        if (!graph)
            document_.fail(root, "the <graphml> has no <graph>");
        document_.checkAttributes(graph);
        return graph;
    }

    void checkName(pugi::xml_node element, std::initializer_list<const char *> known) const
    {
        const std::vector<std::string> names(known.begin(), known.end());
        if (std::find(names.begin(), names.end(), localName(element)) == names.end())
            document_.fail(element, "<" + std::string(element.name()) + "> does not belong into a <" +
                                        std::string(element.parent().name()) + ">" +
                                        suggestion(localName(element), names));
    }

    void readDirection(pugi::xml_node graph)
    {
        const std::string_view direction = graph.attribute("edgedefault").value();
        if (!direction.empty() && direction != "undirected" && direction != "directed")
            document_.fail(graph,
                           "edgedefault is " + inQuotes(direction) + "; expected 'undirected' or 'directed'");
        directed_ = direction == "directed";
        const std::string_view axis = axis_ == nullptr ? "" : dataOf(graph, *axis_);
        if (!axis.empty() && axis != "up" && axis != "down")
            document_.fail(graph, "the graph's YAxis is " + inQuotes(axis) + "; expected 'up' or 'down'");
        if (axis == "down")
            yAxis_ = YAxis::down;
    }

    /// The text that an element gives to a key, or the key's default; empty where there is neither.
    [[nodiscard]] std::string_view dataOf(pugi::xml_node element, const Key &key) const
    {
        const pugi::xml_node data = dataElement(element, key);
        return data ? trimmed(data.child_value()) : key.defaultValue;
    }

    [[nodiscard]] pugi::xml_node dataElement(pugi::xml_node element, const Key &key) const
    {
        for (const pugi::xml_node child : element.children())
            if (isOurs(child) && localName(child) == "data" && key.id == child.attribute("key").value())
                return child;
        return {};
    }

    /// Refuses data of keys that nobody declares and elements that would be lost.
    void checkContent(pugi::xml_node element) const
    {
        for (const pugi::xml_node child : element.children())
        {
            if (!isOurs(child))
                continue;
            if (localName(child) == "graph")
                document_.fail(child, "a graph within a node; a file holds one graph (ungroup it before "
                                      "exporting)");
            checkName(child, {"data", "desc", "port"});
            if (localName(child) == "data" && findKey(document_.required(child, "key")) == nullptr)
                document_.fail(child,
                               "there is no <key> with the id " + inQuotes(child.attribute("key").value()));
        }
    }

    void readNodes(pugi::xml_node graph)
    {
        for (const pugi::xml_node child : graph.children())
        {
            if (!isOurs(child))
                continue;
            if (localName(child) == "hyperedge")
                document_.fail(child, "a <hyperedge> joins more than two vertices; only <edge> is known");
            checkName(child, {"node", "edge", "data", "desc"});
            if (localName(child) != "node")
                continue;
            document_.checkAttributes(child);
            checkContent(child);
            const std::string_view id = document_.required(child, "id");
            const auto [known, isNew] = ids_.emplace(id, static_cast<Vertex>(nodes_.size()));
            if (!isNew)
                document_.fail(child, "the id " + inQuotes(id) + " belongs to the node in line " +
                                          std::to_string(document_.where(nodes_[known->second]).line) +
                                          " already");
            nodes_.push_back(child);
            readCoordinate(child);
        }
    }

    void readCoordinate(pugi::xml_node node)
    {
        Point point;
        if (point_ != nullptr)
        {
            const std::string_view text = dataOf(node, *point_);
            if (text.empty())
                return;
            point = parsePoint(node, text);
        }
        else if (axes_[0] != nullptr && axes_[1] != nullptr)
        {
            const std::array slots = {&point.x, &point.y, &point.z};
            for (std::size_t i = 0; i < slots.size(); ++i)
            {
                const std::string_view text = axes_[i] == nullptr ? "" : dataOf(node, *axes_[i]);
                if (text.empty() && i < 2)
                    return;
                if (!text.empty())
                    *slots[i] = number(node, axes_[i], text, "coordinate");
            }
        }
        else if (geometry_ == nullptr || !readGeometry(node, point))
        {
            return;
        }
        coordinates_.push_back(point);
    }

    [[nodiscard]] Point parsePoint(pugi::xml_node node, std::string_view text) const
    {
        constexpr std::string_view separators = " \t\r\n,;()[]";
        std::array<double, 3> numbers{};
        std::size_t count = 0;
        for (std::string_view rest = text;;)
        {
            rest.remove_prefix(std::min(rest.find_first_not_of(separators), rest.size()));
            if (rest.empty())
                break;
            const std::size_t end = std::min(rest.find_first_of(separators), rest.size());
            const auto value = parseNumber(rest.substr(0, end));
            if (!value || count == numbers.size())
                count = numbers.size() + 1;
            if (count > numbers.size())
                break;
            numbers[count++] = *value;
            rest.remove_prefix(end);
        }
        if (count < 2 || count > 3)
            document_.fail(placeOf(node, *point_),
                           inQuotes(text) +
                               " is no coordinate; expected two or three numbers, as in '0.5 2 0'");
        return {numbers[0], numbers[1], numbers[2]};
    }

    /// yEd keeps the upper left corner and the size of the box that it draws; y grows downwards.
    bool readGeometry(pugi::xml_node node, Point &point)
    {
        for (const pugi::xml_node shape : dataElement(node, *geometry_).children())
        {
            for (const pugi::xml_node part : shape.children())
            {
                if (localName(part) != "Geometry")
                    continue;
                const auto read = [&](const char *name)
                { return number(part, nullptr, document_.required(part, name), name); };
                point = {read("x") + read("width") / 2, read("y") + read("height") / 2, 0};
                yAxis_ = YAxis::down;
                return true;
            }
        }
        return false;
    }

    /// The data element of that key, or the key itself where its default is to blame.
    [[nodiscard]] pugi::xml_node placeOf(pugi::xml_node element, const Key &key) const
    {
        const pugi::xml_node data = dataElement(element, key);
        return data ? data : key.element;
    }

    [[nodiscard]] double number(pugi::xml_node element, const Key *key, std::string_view text,
                                const char *what) const
    {
        const auto value = parseNumber(text);
        if (!value)
            document_.fail(key == nullptr ? element : placeOf(element, *key),
                           inQuotes(text) + " is no number, but the " + what + " must be one");
        return *value;
    }

    void readEdges(pugi::xml_node graph)
    {
        for (const pugi::xml_node child : graph.children())
        {
            if (!isOurs(child) || localName(child) != "edge")
                continue;
            document_.checkAttributes(child);
            checkContent(child);
            Graph::Edge edge{endOf(child, "source"), endOf(child, "target"), 1};
            if (weight_ != nullptr)
                if (const std::string_view text = dataOf(child, *weight_); !text.empty())
                    edge.weight = number(child, weight_, text, "weight");
            const std::string_view own = child.attribute("directed").value();
            if (own.empty() ? directed_ : own == "true" || own == "1")
                arcs_.push_back({edge.a, edge.b});
            edges_.push_back(edge);
        }
    }

    [[nodiscard]] Vertex endOf(pugi::xml_node edge, const char *end) const
    {
        const std::string_view id = document_.required(edge, end);
        const auto found = ids_.find(id);
        if (found == ids_.end())
            document_.fail(edge, std::string("the edge's ") + end + " is " + inQuotes(id) +
                                     ", but there is no <node> with that id");
        return found->second;
    }

    [[nodiscard]] std::vector<Point> takeCoordinates()
    {
        if (coordinates_.size() == nodes_.size())
            return std::move(coordinates_);
        if (!coordinates_.empty())
            warnings_.push_back("only " + std::to_string(coordinates_.size()) + " of " +
                                std::to_string(nodes_.size()) +
                                " vertices have coordinates; all of them are ignored");
        return {};
    }

    /// Instances count vertices by position; who reads the digits of ids as numbers must know.
    void warnAboutIds()
    {
        for (std::size_t v = 0; v < nodes_.size(); ++v)
        {
            std::string_view digits = nodes_[v].attribute("id").value();
            if (digits.front() == 'n')
                digits.remove_prefix(1);
            const auto value = parseInteger(digits);
            if (!value || *value == static_cast<std::int64_t>(v))
                continue;
            warnings_.push_back("the node with id '" + std::string(nodes_[v].attribute("id").value()) +
                                "' is vertex " + std::to_string(v) +
                                ": vertices are numbered by their position in the file, not by their ids");
            return;
        }
    }

    void warnAboutEdges(const Graph &graph)
    {
        const auto loops = static_cast<std::size_t>(std::count_if(
            edges_.begin(), edges_.end(), [](const Graph::Edge &edge) { return edge.a == edge.b; }));
        if (loops > 0)
            warnings_.push_back(counted(loops, "loop is", "loops are") + " dropped");

        std::sort(arcs_.begin(), arcs_.end());
        arcs_.erase(std::unique(arcs_.begin(), arcs_.end()), arcs_.end());
        std::size_t opposites = 0; // arcs whose opposite is there too
        std::size_t oneWay = 0;
        for (const auto &[a, b] : arcs_)
            if (a != b)
                ++(std::binary_search(arcs_.begin(), arcs_.end(), std::pair(b, a)) ? opposites : oneWay);
        if (oneWay > 0)
            warnings_.push_back(counted(oneWay, "directed edge has", "directed edges have") +
                                " no opposite; robots may go both ways along every edge");

        const std::size_t parallel = edges_.size() - loops - opposites / 2 - graph.edgeCount();
        if (parallel > 0)
            warnings_.push_back(counted(parallel, "parallel edge is", "parallel edges are") +
                                " merged with the first between the same vertices");
        if (graph.isWeighted())
            warnings_.push_back("some edges have a weight other than 1; it is kept, but every move takes one "
                                "unit of time");
    }

    XmlDocument document_;
    std::string_view prefix_;
    std::vector<Key> keys_;
    const Key *point_ = nullptr;
    std::array<const Key *, 3> axes_{};
    const Key *geometry_ = nullptr;
    const Key *weight_ = nullptr;
    const Key *axis_ = nullptr;
    bool directed_ = false;
    YAxis yAxis_ = YAxis::up;
    std::vector<pugi::xml_node> nodes_;
    std::unordered_map<std::string_view, Vertex> ids_;
    std::vector<Point> coordinates_;
    std::vector<Graph::Edge> edges_;
    std::vector<std::pair<Vertex, Vertex>> arcs_; ///< the directed edges among them
    std::vector<std::string> warnings_;
};

/// The shortest digits that read back as the same double.
void appendNumber(std::string &text, double value)
{
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text.append(buffer.data(), result.ptr);
}

} // namespace

GraphMl readGraphMl(const std::filesystem::path &file)
{
    return parseGraphMl(readFile(file), file.string());
}

GraphMl parseGraphMl(std::string_view text, const std::string &file)
{
    return Reader(text, file).read();
}

std::string formatGraphMl(const Graph &graph)
{
    const bool downwards = graph.hasCoordinates() && graph.yAxis() == YAxis::down;
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\"\n"
                       "         xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"\n"
                       "         xsi:schemaLocation=\"http://graphml.graphdrawing.org/xmlns "
                       "http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd\">\n"
                       "  <key id=\"key0\" for=\"node\" attr.name=\"Coordinate\" attr.type=\"string\"/>\n"
                       "  <key id=\"key1\" for=\"edge\" attr.name=\"Weight\" attr.type=\"double\"/>\n";
    if (downwards)
        text += "  <key id=\"key2\" for=\"graph\" attr.name=\"YAxis\" attr.type=\"string\"/>\n";
    text += "  <graph id=\"G\" edgedefault=\"undirected\" parse.nodeids=\"canonical\" "
            "parse.edgeids=\"canonical\" parse.order=\"nodesfirst\">\n";
    if (downwards)
        text += "    <data key=\"key2\">down</data>\n";
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
    {
        text += "    <node id=\"n" + std::to_string(v) + "\"";
        if (!graph.hasCoordinates())
        {
            text += "/>\n";
            continue;
        }
        const Point &point = graph.coordinate(v);
        text += "><data key=\"key0\">";
        appendNumber(text, point.x);
        text += ' ';
        appendNumber(text, point.y);
        text += ' ';
        appendNumber(text, point.z);
        text += "</data></node>\n";
    }
    std::size_t index = 0;
    for (const Graph::Edge &edge : graph.edges())
    {
        text += "    <edge id=\"e" + std::to_string(index++) + "\" source=\"n" + std::to_string(edge.a) +
                "\" target=\"n" + std::to_string(edge.b) + "\"><data key=\"key1\">";
        appendNumber(text, edge.weight);
        text += "</data></edge>\n";
    }
    text += "  </graph>\n</graphml>\n";
    return text;
}

} // namespace mrpp
