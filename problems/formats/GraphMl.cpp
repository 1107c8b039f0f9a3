#include "problems/formats/GraphMl.h"

#include "framework/support/Config.h"
#include "framework/system/File.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/GraphMlData.h"
#include "problems/formats/support/TextReader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <unordered_map>

namespace mrpp
{

namespace
{

/// "True" is "true" for many.
std::string lowered(std::string_view word)
{
    std::string lower(word);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

class Reader
{
public:
    Reader(std::string_view text, const std::string &file)
        : document_(text, file), data_(checkedRoot(document_))
    {}

    GraphMl read()
    {
        const pugi::xml_node graph = onlyGraph();
        readNodes(graph);
        strangers_ = 0; // both walks meet them
        readEdges(graph);
        if (strangers_ > 0)
            warnings_.push_back(counted(strangers_, "element is", "elements are") +
                                " skipped: called as GraphML's are, but of another namespace");
        warnAboutIds();
        GraphMl result;
        result.graph = Graph::fromEdges(nodes_.size(), edges_, takeCoordinates(), data_.yAxis(graph));
        warnAboutEdges(*result.graph);
        result.warnings = std::move(warnings_);
        return result;
    }

private:
    struct Named
    {
        pugi::xml_node element;
        Vertex vertex = kNoVertex; ///< none for a group
    };

    static const XmlDocument &checkedRoot(const XmlDocument &document)
    {
        const pugi::xml_node root = document.root();
        if (localName(root) != "graphml")
            document.fail(root, "the outermost element is <" + std::string(root.name()) +
                                    ">, but GraphML begins with <graphml>");
        return document;
    }

    [[nodiscard]] pugi::xml_node onlyGraph() const
    {
        const pugi::xml_node root = document_.root();
        pugi::xml_node graph;
        for (const pugi::xml_node child : root.children())
        {
            if (!data_.isOurs(child))
                continue;
            data_.checkName(child, {"graph", "key", "data", "desc"});
            if (localName(child) != "graph")
                continue;
            if (graph)
                document_.fail(child, "a second <graph>; a file holds one");
            graph = child;
        }
        if (!graph)
            document_.fail(root, "the <graphml> has no <graph>");
        document_.checkAttributes(graph);
        return graph;
    }

    /// Calls `visit(element)` for all elements of the graph, and of yEd's groups in it, in the order of the
    /// file.
    template <class Visitor>
    void forEachElement(pugi::xml_node graph, Visitor &&visit)
    {
        pugi::xml_node inside = graph;
        for (pugi::xml_node element = graph.first_child();;)
        {
            while (!element)
            {
                if (inside == graph)
                    return;
                element = inside.parent().next_sibling();
                inside = inside.parent().parent();
            }
            if (data_.isOurs(element))
                visit(element);
            else if (data_.isStranger(element))
                ++strangers_;
            if (const pugi::xml_node group = graphInGroup(element))
            {
                inside = group;
                element = group.first_child();
            }
            else
                element = element.next_sibling();
        }
    }

    /// What yEd draws as a box around other nodes is a node with a graph in it; none for other elements.
    [[nodiscard]] pugi::xml_node graphInGroup(pugi::xml_node element) const
    {
        if (element.attribute("yfiles.foldertype"))
            for (const pugi::xml_node child : element.children())
                if (data_.isOurs(child) && localName(child) == "graph")
                    return child;
        return {};
    }

    [[nodiscard]] bool isDirected(pugi::xml_node graph) const
    {
        const std::string direction = lowered(graph.attribute("edgedefault").value());
        if (!direction.empty() && direction != "undirected" && direction != "directed")
            document_.fail(graph, "edgedefault is " + inQuotes(graph.attribute("edgedefault").value()) +
                                      "; expected 'undirected' or 'directed'");
        return direction == "directed";
    }

    void readNodes(pugi::xml_node graph)
    {
        (void)isDirected(graph);
        std::size_t groups = 0;
        forEachElement(graph,
                       [&](pugi::xml_node child)
                       {
                           if (localName(child) == "hyperedge")
                               document_.fail(
                                   child, "a <hyperedge> joins more than two vertices; only <edge> is known");
                           data_.checkName(child, {"node", "edge", "data", "desc"});
                           if (localName(child) != "node")
                               return;
                           document_.checkAttributes(child);
                           if (const pugi::xml_node inner = graphInGroup(child))
                           {
                               (void)isDirected(inner);
                               addId(child, kNoVertex);
                               ++groups;
                               return;
                           }
                           data_.checkContent(child);
                           addId(child, static_cast<Vertex>(nodes_.size()));
                           nodes_.push_back(child);
                           if (const auto point = data_.coordinate(child))
                               coordinates_.push_back(*point);
                       });
        if (groups > 0)
            warnings_.push_back(counted(groups, "group is", "groups are") +
                                " dissolved: nodes in a group are vertices, the group is none");
    }

    void addId(pugi::xml_node node, Vertex v)
    {
        const std::string_view id = document_.required(node, "id");
        const auto [known, isNew] = ids_.emplace(id, Named{node, v});
        if (!isNew)
            document_.fail(node, "the id " + inQuotes(id) + " belongs to the node in line " +
                                     std::to_string(document_.where(known->second.element).line) +
                                     " already");
    }

    void readEdges(pugi::xml_node graph)
    {
        forEachElement(
            graph,
            [&](pugi::xml_node child)
            {
                if (localName(child) != "edge")
                    return;
                document_.checkAttributes(child);
                data_.checkContent(child);
                edges_.push_back({endOf(child, "source"), endOf(child, "target"), data_.weight(child)});
                if (isDirectedEdge(child))
                    arcs_.push_back({edges_.back().a, edges_.back().b, edges_.back().weight});
            });
    }

    [[nodiscard]] bool isDirectedEdge(pugi::xml_node edge) const
    {
        const std::string own = lowered(edge.attribute("directed").value());
        if (own.empty())
            return isDirected(edge.parent());
        if (own != "true" && own != "false" && own != "1" && own != "0")
            document_.fail(edge, "'directed' is " + inQuotes(edge.attribute("directed").value()) +
                                     "; expected 'true' or 'false'");
        return own == "true" || own == "1";
    }

    [[nodiscard]] Vertex endOf(pugi::xml_node edge, const char *end) const
    {
        const std::string_view id = document_.required(edge, end);
        const auto found = ids_.find(id);
        if (found == ids_.end())
            document_.fail(edge, std::string("the edge's ") + end + " is " + inQuotes(id) +
                                     ", but there is no <node> with that id");
        if (found->second.vertex == kNoVertex)
            document_.fail(edge, std::string("the edge's ") + end + " is the group " + inQuotes(id) +
                                     ", but no robot can stand on a group; join its nodes");
        return found->second.vertex;
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

        const auto byEnds = [](const Graph::Edge &x, const Graph::Edge &y)
        { return std::pair(x.a, x.b) < std::pair(y.a, y.b); };
        std::stable_sort(arcs_.begin(), arcs_.end(), byEnds);
        arcs_.erase(std::unique(arcs_.begin(), arcs_.end(),
                                [](const Graph::Edge &x, const Graph::Edge &y)
                                { return x.a == y.a && x.b == y.b; }),
                    arcs_.end());
        std::size_t opposites = 0; // arcs whose opposite is there too
        std::size_t oneWay = 0;
        std::size_t uneven = 0; // pairs of opposites with different weights
        for (const Graph::Edge &arc : arcs_)
        {
            if (arc.a == arc.b)
                continue;
            const auto opposite =
                std::lower_bound(arcs_.begin(), arcs_.end(), Graph::Edge{arc.b, arc.a, 1}, byEnds);
            const bool isThere = opposite != arcs_.end() && opposite->a == arc.b && opposite->b == arc.a;
            ++(isThere ? opposites : oneWay);
            uneven += isThere && arc.a < arc.b && opposite->weight != arc.weight ? 1 : 0;
        }
        if (oneWay > 0)
            warnings_.push_back(counted(oneWay, "directed edge has", "directed edges have") +
                                " no opposite; robots may go both ways along every edge");

        if (uneven > 0)
            warnings_.push_back(
                counted(uneven, "edge has", "edges have") +
                " another weight in the opposite direction; the one that comes first is kept");

        const std::size_t parallel = edges_.size() - loops - opposites / 2 - graph.edgeCount();
        if (parallel > 0)
            warnings_.push_back(counted(parallel, "parallel edge is", "parallel edges are") +
                                " merged with the first between the same vertices");
        if (graph.isWeighted())
            warnings_.push_back("some edges have a weight other than 1; it is kept, but every move takes one "
                                "unit of time");
    }

    XmlDocument document_;
    GraphMlData data_;
    std::vector<pugi::xml_node> nodes_;
    std::unordered_map<std::string_view, Named> ids_;
    std::vector<Point> coordinates_;
    std::vector<Graph::Edge> edges_;
    std::vector<Graph::Edge> arcs_; ///< the directed edges among them
    std::size_t strangers_ = 0;     ///< elements of other namespaces that are called as GraphML's are
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
    return readAs(FormatId::graphMl, text, file, [&] { return Reader(text, file).read(); });
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
