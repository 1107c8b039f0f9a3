#pragma once
/// \file
/// The tables of a result store: those that OMPL's Planner Arena reads, and the store's own.

#include "framework/store/Sqlite.h"

#include <filesystem>
#include <string>

namespace mrpp
{

/// Makes the tables where the file is empty; else checks that it is a store of a version known here. Throws
/// FileError.
void openResultSchema(sqlite::Connection &database, const std::filesystem::path &file, bool mayCreate);

/// The rows of `SELECT * FROM runs` as records; looks its columns up once.
class RunRows
{
public:
    explicit RunRows(const sqlite::Statement &rows);

    [[nodiscard]] RunRecord record(const sqlite::Statement &row) const;

private:
    struct Cell
    {
        std::string name;
        const RunColumn *column = nullptr; ///< null for one that an event added
        int index = 0;
    };
    std::vector<Cell> cells_;
    int status_ = 0;
};

/// The record in a row of `SELECT * FROM runs`.
[[nodiscard]] RunRecord recordOf(const sqlite::Statement &row);

/// Columns of `runs` that are not columns of RunRecord.
[[nodiscard]] bool isKeyColumn(const std::string &name);

/// `VARCHAR(…)`, `REAL`, ….
[[nodiscard]] std::string sqlType(RunColumn::Type type);

} // namespace mrpp
