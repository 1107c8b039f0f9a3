#include "framework/store/Sqlite.h"

#include "framework/support/Error.h"

#include <sqlite3.h>

namespace mrpp::sqlite
{

namespace
{

constexpr int kPatience = 30000; // milliseconds to wait for another process's lock

std::string advice(int code)
{
    switch (code & 0xff)
    {
    case SQLITE_FULL:
        return "; the disk is full: make room and run the same command again, every finished run is kept";
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
        return "; the folder and its files must be writable";
    case SQLITE_IOERR:
    case SQLITE_PROTOCOL:
        return "; the disk is failing, or its file system lacks what a database needs: try a folder on "
               "another one "
               "(-o)";
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
        return "; the file is damaged or no result store: move it away to begin anew, or restore a copy";
    default:
        return "";
    }
}

/// Opens a file of a folder that cannot be written, in which SQLite cannot make its helper files.
std::string immutableUri(const std::filesystem::path &file)
{
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string uri = "file:";
    for (const char c : std::filesystem::absolute(file).string())
    {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '?' || c == '#' || c == '%')
        {
            uri += '%';
            uri += kDigits[byte >> 4];
            uri += kDigits[byte & 15U];
        }
        else
        {
            uri += c;
        }
    }
    return uri + "?immutable=1";
}

} // namespace

int Connection::open(const std::string &name, int flags)
{
    const char *vfs = abilities_.locks ? nullptr : "unix-none";
    int code = sqlite3_open_v2(name.c_str(), &handle_, flags | SQLITE_OPEN_NOMUTEX, vfs);
    if (code != SQLITE_OK)
        return code;
    sqlite3_extended_result_codes(handle_, 1);
    sqlite3_busy_timeout(handle_, kPatience);
    // A log that was left behind is read without shared memory by who is alone.
    if (!abilities_.sharedMemory)
        sqlite3_exec(handle_, "PRAGMA locking_mode = EXCLUSIVE", nullptr, nullptr, nullptr);
    code = sqlite3_exec(handle_, "SELECT count(*) FROM sqlite_master", nullptr, nullptr, nullptr);
    return code;
}

Connection::Connection(const std::filesystem::path &file, Mode mode, const FileSystemAbilities &abilities)
    : file_(file), abilities_(abilities)
{
    const bool immutable =
        mode == Mode::read && !abilities.locks; // else it might take back what others write
    const int flags =
        (mode == Mode::write ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY) |
        (immutable ? SQLITE_OPEN_URI : 0);
    int code = open(immutable ? immutableUri(file) : file.string(), flags);
    std::error_code error;
    const bool quiet = !std::filesystem::exists(file.string() + "-wal", error); // nobody is writing
    if ((code & 0xff) == SQLITE_CANTOPEN && mode == Mode::read && quiet &&
        std::filesystem::exists(file, error))
    {
        sqlite3_close(handle_);
        code = open(immutableUri(file), flags | SQLITE_OPEN_URI);
    }
    if ((code & 0xff) == SQLITE_READONLY && mode == Mode::read)
    {
        // Its writer was killed within a transaction, which only a connection that may write takes back.
        sqlite3_close(handle_);
        code = open(file.string(), SQLITE_OPEN_READWRITE);
    }
    if (code == SQLITE_OK)
        return;
    const std::string complaint =
        (handle_ == nullptr ? "out of memory" : sqlite3_errmsg(handle_)) + advice(code);
    sqlite3_close(handle_);
    throw FileError({file.string()}, "cannot be opened: " + complaint);
}

Connection::~Connection()
{
    sqlite3_close(handle_);
}

void Connection::run(const std::string &sql)
{
    check(sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr));
}

void Connection::beginLog()
{
    if (abilities_.sharedMemory && abilities_.locks)
        return run("PRAGMA journal_mode = WAL");
    run("PRAGMA journal_mode = DELETE");
    run("PRAGMA locking_mode = NORMAL");
}

void Connection::foldLog() noexcept
{
    sqlite3_busy_timeout(handle_, 0);
    sqlite3_exec(handle_, "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
    sqlite3_busy_timeout(handle_, kPatience);
}

bool Connection::hasTable(const std::string &name)
{
    Statement query(*this, "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?");
    return query.bind(1, name).step();
}

bool Connection::hasColumn(const std::string &table, const std::string &name)
{
    Statement query(*this, "SELECT 1 FROM pragma_table_info(?) WHERE name = ? COLLATE NOCASE");
    return query.bind(1, table).bind(2, name).step();
}

std::int64_t Connection::lastRowId() const
{
    return sqlite3_last_insert_rowid(handle_);
}

void Connection::check(int code) const
{
    if (code != SQLITE_OK && code != SQLITE_ROW && code != SQLITE_DONE)
        throw FileError({file_.string()}, sqlite3_errmsg(handle_) + advice(code));
}

Statement::Statement(Connection &connection, const std::string &sql) : connection_(connection)
{
    connection.check(sqlite3_prepare_v2(connection.handle(), sql.c_str(), -1, &handle_, nullptr));
}

Statement::~Statement()
{
    sqlite3_finalize(handle_);
}

Statement &Statement::bind(int parameter, const Value &value)
{
    struct Binder
    {
        sqlite3_stmt *statement;
        int parameter;

        int operator()(std::monostate) const { return sqlite3_bind_null(statement, parameter); }
        int operator()(std::int64_t number) const { return sqlite3_bind_int64(statement, parameter, number); }
        int operator()(double number) const { return sqlite3_bind_double(statement, parameter, number); }
        int operator()(const std::string &text) const
        {
            return sqlite3_bind_text64(statement, parameter, text.data(), text.size(), SQLITE_TRANSIENT,
                                       SQLITE_UTF8);
        }
    };
    connection_.check(std::visit(Binder{handle_, parameter}, value));
    return *this;
}

Statement &Statement::bind(int parameter, std::span<const std::uint8_t> bytes)
{
    connection_.check(sqlite3_bind_blob64(handle_, parameter, bytes.data(), bytes.size(), SQLITE_TRANSIENT));
    return *this;
}

Statement &Statement::bind(int parameter, const Statement &row, int column)
{
    connection_.check(sqlite3_bind_value(handle_, parameter, sqlite3_column_value(row.handle_, column)));
    return *this;
}

bool Statement::step()
{
    const int code = sqlite3_step(handle_);
    connection_.check(code);
    return code == SQLITE_ROW;
}

void Statement::execute()
{
    while (step())
    {}
    reset();
}

void Statement::reset()
{
    sqlite3_reset(handle_);
    sqlite3_clear_bindings(handle_);
}

Value Statement::column(int index) const
{
    sqlite3_value *cell = sqlite3_column_value(handle_, index);
    switch (sqlite3_value_type(cell))
    {
    case SQLITE_INTEGER:
        return static_cast<std::int64_t>(sqlite3_value_int64(cell));
    case SQLITE_FLOAT:
        return sqlite3_value_double(cell);
    case SQLITE_TEXT:
        return std::string(reinterpret_cast<const char *>(sqlite3_value_text(cell)),
                           static_cast<std::size_t>(sqlite3_value_bytes(cell)));
    default:
        return {};
    }
}

std::string_view Statement::view(int index) const
{
    const unsigned char *data = sqlite3_column_text(handle_, index);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_, index));
    return data == nullptr ? std::string_view()
                           : std::string_view(reinterpret_cast<const char *>(data), size);
}

std::string Statement::text(int index) const
{
    return std::string(view(index));
}

std::int64_t Statement::integer(int index) const
{
    return sqlite3_column_int64(handle_, index);
}

std::vector<std::uint8_t> Statement::bytes(int index) const
{
    const auto *data = static_cast<const std::uint8_t *>(sqlite3_column_blob(handle_, index));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_, index));
    return data == nullptr ? std::vector<std::uint8_t>() : std::vector<std::uint8_t>(data, data + size);
}

int Statement::columnCount() const
{
    return sqlite3_column_count(handle_);
}

std::string Statement::columnName(int index) const
{
    return sqlite3_column_name(handle_, index);
}

Transaction::Transaction(Connection &connection) : connection_(connection)
{
    connection.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction()
{
    if (open_) // some failures have rolled back already; then this one fails, which is as good
        sqlite3_exec(connection_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit()
{
    connection_.run("COMMIT");
    open_ = false;
}

std::string quoted(std::string_view name)
{
    std::string text = "\"";
    for (const char c : name)
    {
        text += c;
        if (c == '"')
            text += c;
    }
    return text + '"';
}

} // namespace mrpp::sqlite
