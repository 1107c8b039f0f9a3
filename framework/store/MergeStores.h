#pragma once
/// \file
/// The runs of several result stores in one: what shards of a campaign, or two goes at one shard, have kept.

#include "framework/store/Sqlite.h"

#include <filesystem>
#include <map>
#include <string>

namespace mrpp
{

class StoreMerger
{
public:
    struct Counts
    {
        std::size_t taken = 0; ///< runs that are new
        std::size_t twice = 0; ///< runs that were there already
    };

    /// \param out a result store, open for writing, which outlives this; its own runs came from \param folder
    StoreMerger(sqlite::Connection &out, const std::filesystem::path &folder);

    /// Takes what DIR/results.sqlite has and `out` has not: runs, and what belongs to them in other tables
    /// (their solutions, progress, columns that only some have). A run that is there already stays; its
    /// answer must be the same, as one question has one answer, unless a limit ended one of the two. Throws
    /// InputError that names both folders where it is not, and FileError where the folder holds no store;
    /// `out` is then half merged, and its transaction not to be committed.
    Counts take(const std::filesystem::path &folder);

private:
    class Source;

    [[nodiscard]] bool isThere(const Source &source, const sqlite::Statement &run);
    Counts takeRuns(Source &source);
    void takeAttempts(Source &source);
    void takeRest(Source &source, const std::string &table);

    sqlite::Connection &out_;
    std::map<std::string, std::filesystem::path> origins_; ///< by run key
};

} // namespace mrpp
