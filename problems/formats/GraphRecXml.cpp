/// The reader of GraphRec's XML.

#include "framework/support/Config.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/GraphRecBuilder.h"
#include "problems/formats/support/TextReader.h"
#include "problems/formats/support/XmlDocument.h"

namespace mrpp
{

namespace
{

class Reader
{
public:
    Reader(std::string_view text, const std::string &file) : document_(text, file), builder_(file) {}

    GraphRecFile read()
    {
        const pugi::xml_node root = document_.root();
        if (localName(root) != "graphrec")
            document_.fail(root, "the outermost element is <" + std::string(root.name()) +
                                     ">; expected <graphrec>");
        if (document_.required(root, "version") != "1.0")
            document_.fail(root, "the version is " + inQuotes(root.attribute("version").value()) +
                                     "; expected 1.0");
        const pugi::xml_node solution = onlyChild(root, "solution");
        for (const pugi::xml_node element : onlyChild(solution, "graph").children())
            readGraphElement(element);
        if (const pugi::xml_node scenario = solution.child("scenario"))
            for (const pugi::xml_node move : scenario.children("move"))
                check(move, builder_.addMove(number(move, "tms"), number(move, "src"), number(move, "dst"),
                                             document_.where(move).line));
        return builder_.take();
    }

private:
    pugi::xml_node onlyChild(pugi::xml_node parent, const char *name) const
    {
        const pugi::xml_node child = parent.child(name);
        if (!child)
            document_.fail(parent, "there is no <" + std::string(name) + "> in it");
        if (const pugi::xml_node second = child.next_sibling(name))
            document_.fail(second, "this is a second <" + std::string(name) + ">; a file holds one here");
        return child;
    }

    void readGraphElement(pugi::xml_node element)
    {
        const std::string_view name = element.name();
        if (name == "node")
        {
            const std::int64_t id = number(element, "id");
            check(element, builder_.addVertex(id));
            if (element.attribute("ent"))
                check(element, builder_.setStart(id, number(element, "ent")));
            if (element.attribute("x") || element.attribute("y"))
                check(element, builder_.setPosition(id, coordinate(element, "x"), coordinate(element, "y")));
        }
        else if (name == "edge")
        {
            check(element, builder_.addEdge(number(element, "n1"), number(element, "n2")));
        }
    }

    void check(pugi::xml_node element, const std::optional<std::string> &complaint) const
    {
        if (complaint)
            document_.fail(element, *complaint);
    }

    std::int64_t number(pugi::xml_node element, const char *attribute) const
    {
        const std::string_view text = document_.required(element, attribute);
        const auto value = parseInteger(text);
        if (!value)
            document_.fail(element,
                           inQuotes(text) + " is no whole number, but '" + attribute + "' must be one");
        return *value;
    }

    double coordinate(pugi::xml_node element, const char *attribute) const
    {
        const std::string_view text = document_.required(element, attribute);
        const auto value = parseNumber(text);
        if (!value)
            document_.fail(element, inQuotes(text) + " is no number, but '" + attribute + "' must be one");
        return *value;
    }

    XmlDocument document_;
    GraphRecBuilder builder_;
};

} // namespace

GraphRecFile parseGraphRecXml(std::string_view text, const std::string &file)
{
    return readAs(FormatId::graphRecXml, text, file, [&] { return Reader(text, file).read(); });
}

} // namespace mrpp
