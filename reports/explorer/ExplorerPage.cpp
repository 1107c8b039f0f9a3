#include "reports/explorer/ExplorerPage.h"

#include "framework/evaluation/Metrics.h"
#include "framework/support/Error.h"
#include "reports/explorer/ExplorerTemplate.h"
#include "reports/explorer/Packing.h"
#include "reports/picture/Palette.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace mrpp
{

namespace
{

using Json = nlohmann::ordered_json;

std::string textOf(const Json &json)
{
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// A column of texts: the distinct ones, and for each row which of them it has.
class TextColumn
{
public:
    void add(const std::string &text)
    {
        const auto [known, isNew] = numbers_.emplace(text, texts_.size());
        if (isNew)
            texts_.push_back(text);
        rows_.push_back(known->second);
    }
    [[nodiscard]] Json json() const { return {{"texts", texts_}, {"rows", rows_}}; }

private:
    std::map<std::string, std::size_t> numbers_;
    std::vector<std::string> texts_;
    std::vector<std::size_t> rows_;
};

/// Whole numbers that JavaScript would round.
bool isTooLarge(const Value &value)
{
    constexpr std::int64_t kLargest = std::int64_t{1} << 53;
    const auto *number = std::get_if<std::int64_t>(&value);
    return number != nullptr && (*number > kLargest || *number < -kLargest);
}

template <class Get>
Json column(const std::string &name, std::span<const RunRecord> records, const Get &get)
{
    Json json{{"name", name}};
    if (const Metric *metric = findMetric(name))
    {
        json["title"] = metric->title;
        json["unit"] = metric->unit;
        json["lowerIsBetter"] = metric->better == Metric::Better::lower;
        json["help"] = metric->description;
    }
    bool isText = false;
    for (const RunRecord &record : records)
    {
        const Value value = get(record);
        isText = isText || std::holds_alternative<std::string>(value) || isTooLarge(value);
    }
    if (isText)
    {
        TextColumn texts;
        for (const RunRecord &record : records)
            texts.add(toText(get(record)));
        json.update(texts.json());
        return json;
    }
    Json &numbers = json["numbers"] = Json::array();
    for (const RunRecord &record : records)
    {
        const Value value = get(record);
        if (const auto *whole = std::get_if<std::int64_t>(&value))
            numbers.push_back(*whole);
        else if (const auto *real = std::get_if<double>(&value))
            numbers.push_back(*real); // null where it is not finite
        else
            numbers.push_back(nullptr);
    }
    return json;
}

/// All columns of all runs.
Json runsJson(const ExplorerContents &contents)
{
    Json columns = Json::array();
    for (const RunColumn &known : runColumns())
        columns.push_back(column(std::string(known.name), contents.records, known.get));
    std::set<std::string> extraNames;
    for (const RunRecord &record : contents.records)
        for (const auto &[name, value] : record.extra)
            extraNames.insert(name);
    for (const std::string &name : extraNames)
        columns.push_back(column(name, contents.records,
                                 [&name](const RunRecord &record)
                                 {
                                     const auto extra = record.extra.find(name);
                                     return extra == record.extra.end() ? Value() : extra->second;
                                 }));
    TextColumn absences;
    for (const std::string &absence : contents.absences)
        absences.add(absence);
    return {{"columns", std::move(columns)}, {"absences", absences.json()}};
}

Json plannersJson(const std::vector<std::string> &names)
{
    Json planners = Json::array();
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        const CurveStyle style = curveStyle(i);
        planners.push_back({{"name", names[i]},
                            {"color", style.color},
                            {"dashes", style.dashes},
                            {"marker", style.filledMarker}});
    }
    return planners;
}

Json explorerJson(const ExplorerContents &contents)
{
    Json json{{"title", contents.title},
              {"facts", contents.facts},
              {"provenance", contents.provenance},
              {"plan", contents.plan},
              {"planners", plannersJson(contents.planners)},
              {"runCount", contents.records.size()}};
    std::size_t robots = 0;
    Json &cases = json["cases"] = Json::array();
    for (const PlayableCase &one : contents.playable->cases())
    {
        robots = std::max(robots, one.robots);
        cases.push_back({{"name", one.name}, {"graph", one.graph}, {"robots", one.robots}});
    }
    Json &playable = json["playable"] = Json::array();
    for (const PlayableRun &one : contents.playable->runs())
        playable.push_back({{"run", one.run},
                            {"case", one.inCase},
                            {"sequential", one.isSequential},
                            {"optimized", !one.optimized.empty()}});
    Json &colors = json["robotColors"] = Json::array();
    for (std::size_t robot = 0; robot < robots; ++robot)
        colors.push_back(robotColor(robot));
    return json;
}

void addBlock(std::string &html, const std::string &type, const std::string &id, const std::string &text)
{
    html += "<script type=\"" + type + "\" id=\"" + id + "\">" + text + "</script>\n";
}

/// `<` can only stand inside JSON's texts, where it may be written like this; then no text can end the
/// element.
std::string harmless(const std::string &json)
{
    std::string text;
    text.reserve(json.size());
    for (const char c : json)
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text;
}

std::span<const std::uint8_t> bytesOf(const std::string &text)
{
    return {reinterpret_cast<const std::uint8_t *>(text.data()), text.size()};
}

std::string dataBlocks(const ExplorerContents &contents)
{
    std::string html;
    addBlock(html, "application/json", "explorer", harmless(textOf(explorerJson(contents))));
    const auto addPacked = [&html](const std::string &name, std::size_t number, const std::string &text)
    { addBlock(html, "application/octet-stream", name + std::to_string(number), text); };
    addBlock(html, "application/octet-stream", "runs", packedText(bytesOf(textOf(runsJson(contents)))));
    const PlayableRuns &playable = *contents.playable;
    for (std::size_t i = 0; i < playable.graphs().size(); ++i)
        addPacked("graph", i, playable.graphs()[i]);
    for (std::size_t i = 0; i < playable.cases().size(); ++i)
        addPacked("case", i, playable.cases()[i].robotsText);
    for (std::size_t i = 0; i < playable.runs().size(); ++i)
    {
        addPacked("solution", i, playable.runs()[i].solution);
        if (!playable.runs()[i].optimized.empty())
            addPacked("optimized", i, playable.runs()[i].optimized);
    }
    return html;
}

} // namespace

bool hasExplorer()
{
    return !explorerTemplate().empty();
}

std::string explorerPage(const ExplorerContents &contents)
{
    if (!hasExplorer())
        throw InputError("this mrppsim was built without the explorer; build it where Node.js and npm are "
                         "installed (MRPP_WEB=ON)");
    const std::string_view page = explorerTemplate();
    const std::size_t place = page.find(kExplorerData);
    std::string html(page.substr(0, place));
    html += dataBlocks(contents);
    html += page.substr(place + kExplorerData.size());
    return html;
}

} // namespace mrpp
