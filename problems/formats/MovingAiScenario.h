#pragma once
/// \file
/// Scenarios of the Moving AI Lab's pathfinding benchmarks (`.scen`): starts and goals on a map.
///
/// \code
/// version 1
/// 0	room.map	6	4	0	0	3	0	3.00000000
/// \endcode
///
/// A record is: bucket, map, map's width, map's height, start x, start y, goal x, goal y, length of a
/// shortest path in *octile* moves (never a bound for 4-connected moves). The robots of an instance are the
/// first records. Fields are separated by tabs or blanks.

#include "framework/model/Instance.h"
#include "framework/system/Supervision.h"
#include "problems/formats/MovingAiMap.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

struct Scenario
{
    struct Cell
    {
        std::int64_t x = 0;
        std::int64_t y = 0;
        std::size_t column = 0; ///< where the x stands in its line
    };
    struct Record
    {
        std::string map; ///< as the file names it, perhaps with folders
        Cell start;
        Cell goal;
        std::size_t line = 0;
    };

    std::string file;       ///< for messages
    std::int64_t width = 0; ///< of the map, the same in all records; 0 where there is no record
    std::int64_t height = 0;
    std::size_t sizeColumn = 0; ///< where the first record gives the width
    std::vector<Record> records;

    /// The file name of the first record's map, without folders; empty where there is no record.
    [[nodiscard]] std::string mapName() const;
};

/// Reads all records. Throws ParseError for another version than 1, a record that lacks fields, a field that
/// is no number, a cell outside the record's width and height, records that disagree about the map's size.
[[nodiscard]] Scenario readMovingAiScenario(const std::filesystem::path &file);
[[nodiscard]] Scenario parseMovingAiScenario(std::string_view text, const std::string &file);

/// The first `robots` records on their map. Throws ParseError where the map has another size, a robot stands
/// or ends on an obstacle, two of them have one start or one goal; InputError where there are fewer records
/// than robots. O(V + robots).
[[nodiscard]] Instance scenarioInstance(const Scenario &scenario, const GridMap &map, std::size_t robots);

/// Writes version 1 with tabs, 8 decimals, buckets of four. A goal that cannot be reached gets length 0.
/// \param mapName what the records call the map
/// \param supervision hears of the lengths (OctileDistances.h), which take longest; its stop makes those that
/// are left 0
/// \pre the instance stands on the map's graph
[[nodiscard]] std::string formatMovingAiScenario(const GridMap &map, const Instance &instance,
                                                 const std::string &mapName,
                                                 const Supervision &supervision = {});

} // namespace mrpp
