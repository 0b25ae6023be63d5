#include "mlab/journal/database.h"

#include <sqlite3.h>

#include <system_error>

#include "mlab/history/history.h"

namespace mlab::journal {
namespace {

// A text of the history and what stands around it.
constexpr int kMostBytes = static_cast<int>(history::History::kMostText) + (1 << 20);

SqlError error_of(sqlite3* connection, int code) {
  switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {SqlError::Kind::kHeld, "another process has it"};
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
    case SQLITE_SCHEMA:
      return {SqlError::Kind::kDamaged, connection != nullptr ? sqlite3_errmsg(connection) : "it is damaged"};
    case SQLITE_FULL:
      return {SqlError::Kind::kOther, std::generic_category().message(ENOSPC)};
    default:
      break;
  }
  const int system = connection != nullptr ? sqlite3_system_errno(connection) : 0;
  const bool is_of_system = (code & 0xff) == SQLITE_IOERR || (code & 0xff) == SQLITE_CANTOPEN;
  if (is_of_system && system != 0) return {SqlError::Kind::kOther, std::generic_category().message(system)};
  return {SqlError::Kind::kOther, connection != nullptr ? sqlite3_errmsg(connection) : sqlite3_errstr(code)};
}

Sql<void> done(sqlite3* connection, int code) {
  if (code == SQLITE_OK) return {};
  return std::unexpected(error_of(connection, code));
}

}  // namespace

void Database::Close::operator()(sqlite3* connection) const {
  sqlite3_close_v2(connection);
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

Sql<Database> Database::open(const std::string& path, Opening opening) {
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_EXRESCODE | SQLITE_OPEN_NOMUTEX |
                    (opening == Opening::kMade ? SQLITE_OPEN_CREATE : 0);
  sqlite3* connection = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &connection, flags, nullptr);
  Database out(connection);
  if (code != SQLITE_OK) return std::unexpected(error_of(connection, code));
  for (const auto& [option, value] :
       {std::pair{SQLITE_DBCONFIG_DEFENSIVE, 1}, std::pair{SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
        std::pair{SQLITE_DBCONFIG_ENABLE_TRIGGER, 0}, std::pair{SQLITE_DBCONFIG_ENABLE_VIEW, 0}}) {
    if (const int set = sqlite3_db_config(connection, option, value, nullptr); set != SQLITE_OK)
      return std::unexpected(error_of(connection, set));
  }
  sqlite3_limit(connection, SQLITE_LIMIT_LENGTH, kMostBytes);
  // One process at a time: then the index of what is not in the main file yet is no file of its own, which
  // a kill could leave behind and a full disk could refuse.
  auto held = out.run("PRAGMA locking_mode = EXCLUSIVE; PRAGMA cell_size_check = ON;");
  if (!held) return std::unexpected(held.error());
  return out;
}

Sql<void> Database::run(const char* sql) {
  return done(connection_.get(), sqlite3_exec(connection_.get(), sql, nullptr, nullptr, nullptr));
}

Sql<Statement> Database::prepare(std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v3(connection_.get(), sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  if (code == SQLITE_OK) return Statement(statement);
  SqlError error = error_of(connection_.get(), code);
  // A table that it should have is missing, say.
  if ((code & 0xff) == SQLITE_ERROR) error.kind = SqlError::Kind::kDamaged;
  return std::unexpected(std::move(error));
}

Sql<std::int64_t> Database::number(std::string_view sql) {
  auto statement = prepare(sql);
  if (!statement) return std::unexpected(statement.error());
  const auto found = statement->step();
  if (!found) return std::unexpected(found.error());
  return *found ? statement->number(0) : 0;
}

void Database::leave_as_it_is() {
  sqlite3_db_config(connection_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

Sql<void> Statement::set(int index, std::int64_t value) {
  return done(sqlite3_db_handle(statement_.get()), sqlite3_bind_int64(statement_.get(), index, value));
}

Sql<void> Statement::set(int index, std::string_view bytes) {
  return done(sqlite3_db_handle(statement_.get()),
              sqlite3_bind_blob64(statement_.get(), index, bytes.data() == nullptr ? "" : bytes.data(),
                                  bytes.size(), SQLITE_STATIC));
}

Sql<bool> Statement::step() {
  sqlite3* const connection = sqlite3_db_handle(statement_.get());
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) {
    sqlite3_reset(statement_.get());
    return false;
  }
  SqlError error = error_of(connection, code);
  sqlite3_reset(statement_.get());
  return std::unexpected(std::move(error));
}

Sql<void> Statement::run() {
  const auto stepped = step();
  if (!stepped) return std::unexpected(stepped.error());
  sqlite3_reset(statement_.get());
  return {};
}

std::int64_t Statement::number(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

std::string Statement::bytes(int column) const {
  const void* const bytes = sqlite3_column_blob(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return bytes == nullptr || size <= 0
             ? std::string()
             : std::string(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

}  // namespace mlab::journal
