#pragma once
/// \file
/// SQLite's C interface with owners: connections, statements and transactions that close themselves, and
/// errors that say what was being done.

#include "framework/run/RunRecord.h"
#include "framework/system/FileSystem.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace mrpp::sqlite
{

/// One open database file. For one thread at a time.
class Connection
{
public:
    enum class Mode
    {
        read,
        write, ///< makes the file where it is missing
    };

    /// Throws FileError where the file cannot be opened.
    /// \param abilities of its file system: without shared memory there is no write-ahead mode, without locks
    /// nothing keeps other processes away
    Connection(const std::filesystem::path &file, Mode mode, const FileSystemAbilities &abilities = {});
    ~Connection();
    Connection(const Connection &) = delete;
    Connection &operator=(const Connection &) = delete;

    /// Runs statements without parameters, separated by semicolons. Throws FileError.
    void run(const std::string &sql);

    /// Begins write-ahead mode where the file system can do that, else a journal for each transaction.
    void beginLog();

    /// Leaves write-ahead mode: afterwards the file alone holds everything. Changes nothing while another
    /// connection is open, and does not wait for it.
    void foldLog() noexcept;

    [[nodiscard]] bool hasTable(const std::string &name);
    /// Small letters and capitals are the same.
    [[nodiscard]] bool hasColumn(const std::string &table, const std::string &name);
    [[nodiscard]] std::int64_t lastRowId() const;

    /// Throws FileError for a result code that is a failure, with SQLite's message and, where there is one,
    /// what would help.
    void check(int code) const;

    [[nodiscard]] sqlite3 *handle() const { return handle_; }

private:
    [[nodiscard]] int open(const std::string &name, int flags);

    std::filesystem::path file_;
    FileSystemAbilities abilities_;
    sqlite3 *handle_ = nullptr;
};

/// A prepared statement; parameters count from 1, columns from 0.
class Statement
{
public:
    /// Throws FileError where the SQL does not fit the database.
    Statement(Connection &connection, const std::string &sql);
    ~Statement();
    Statement(const Statement &) = delete;
    Statement &operator=(const Statement &) = delete;

    Statement &bind(int parameter, const Value &value);
    Statement &bind(int parameter, std::span<const std::uint8_t> bytes);
    /// The cell of another statement's row, whatever its type.
    Statement &bind(int parameter, const Statement &row, int column);

    /// True while there is a row. Throws FileError.
    bool step();

    /// Runs to the end and makes the statement ready for new parameters. Throws FileError.
    void execute();
    void reset();

    [[nodiscard]] Value column(int index) const;
    [[nodiscard]] std::string text(int index) const;
    /// The same, valid until the next step.
    [[nodiscard]] std::string_view view(int index) const;
    [[nodiscard]] std::int64_t integer(int index) const;
    [[nodiscard]] std::vector<std::uint8_t> bytes(int index) const;
    [[nodiscard]] int columnCount() const;
    [[nodiscard]] std::string columnName(int index) const;

private:
    Connection &connection_;
    sqlite3_stmt *handle_ = nullptr;
};

/// Everything between its construction and commit() happens as a whole or not at all.
class Transaction
{
public:
    explicit Transaction(Connection &connection);
    ~Transaction();
    Transaction(const Transaction &) = delete;
    Transaction &operator=(const Transaction &) = delete;

    void commit();

private:
    Connection &connection_;
    bool open_ = true;
};

/// "name", fit to stand in SQL as an identifier.
[[nodiscard]] std::string quoted(std::string_view name);

} // namespace mrpp::sqlite
