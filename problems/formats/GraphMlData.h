#pragma once
/// \file
/// What the `<key>`s of a GraphML file declare, and what its elements say under them. Internal to the GraphML
/// reader.

#include "framework/model/Graph.h"
#include "problems/formats/support/XmlDocument.h"

#include <array>
#include <initializer_list>
#include <optional>
#include <unordered_map>
#include <vector>

namespace mrpp
{

class GraphMlData
{
public:
    /// Reads the keys under the outermost element. Throws ParseError for one without an id or with another's.
    /// \param document must outlive the object
    explicit GraphMlData(const XmlDocument &document);
    GraphMlData(const GraphMlData &) = delete; // it points into itself
    GraphMlData &operator=(const GraphMlData &) = delete;

    /// Whether an element belongs to GraphML, and not to somebody's extension.
    [[nodiscard]] bool isOurs(pugi::xml_node element) const;

    /// Throws ParseError where an element of GraphML has another name than these.
    void checkName(pugi::xml_node element, std::initializer_list<const char *> known) const;

    /// Throws ParseError where data of a node or edge has a key that is not declared, or where it holds what
    /// would be lost.
    void checkContent(pugi::xml_node element) const;

    /// Whether an element only looks as if it belonged to GraphML: its name does, its namespace does not.
    [[nodiscard]] bool isStranger(pugi::xml_node element) const;

    /// Throws ParseError where it is malformed.
    [[nodiscard]] std::optional<Point> coordinate(pugi::xml_node node) const;
    /// 1 where the file does not say. Throws ParseError where it is no number.
    [[nodiscard]] double weight(pugi::xml_node edge) const;
    /// Throws ParseError where it is neither up nor down.
    [[nodiscard]] YAxis yAxis(pugi::xml_node graph) const;

private:
    struct Key
    {
        pugi::xml_node element;
        std::string_view id;
        std::string_view name;
        std::string_view scope; ///< node, edge, graph, all, …
        std::string_view defaultValue;
    };

    [[nodiscard]] const Key *find(std::string_view id) const;
    [[nodiscard]] const Key *findNamed(std::string_view scope,
                                       std::initializer_list<const char *> names) const;
    [[nodiscard]] pugi::xml_node dataElement(pugi::xml_node element, const Key &key) const;
    [[nodiscard]] std::string_view textOf(pugi::xml_node element) const;
    [[nodiscard]] std::string_view valueOf(pugi::xml_node element, const Key &key) const;
    [[nodiscard]] pugi::xml_node placeOf(pugi::xml_node element, const Key &key) const;
    [[nodiscard]] double number(pugi::xml_node place, std::string_view text, const char *what) const;
    [[nodiscard]] Point parsePoint(pugi::xml_node node, std::string_view text) const;
    [[nodiscard]] std::optional<Point> separateAxes(pugi::xml_node node) const;
    [[nodiscard]] std::optional<Point> boxCentre(pugi::xml_node node) const;

    const XmlDocument &document_;
    XmlNamespace namespace_;
    std::vector<Key> keys_;
    std::unordered_map<std::string_view, std::size_t> positions_; ///< of the keys, by their ids
    const Key *point_ = nullptr;                                  ///< the whole coordinate in one text
    std::array<const Key *, 3> axes_{};                           ///< x, y, z apart
    const Key *box_ = nullptr;                                    ///< yEd's geometry
    const Key *weight_ = nullptr;
    const Key *yAxis_ = nullptr;
};

} // namespace mrpp
