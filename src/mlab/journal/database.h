#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace mlab::journal {

/// Why SQLite did not do something.
struct SqlError {
  enum class Kind : std::uint8_t {
    kOther,    ///< the disk is full, say: later it may go well
    kHeld,     ///< another process has the file
    kDamaged,  ///< it is no database, or one that was damaged
  };
  Kind kind = Kind::kOther;
  std::string message;  ///< as a part of a sentence
};
template <class T>
using Sql = std::expected<T, SqlError>;

class Statement;

/// A connection to an SQLite file, which no other process can open meanwhile. Nothing in it throws, and what
/// stands in the file is not trusted.
class Database {
 public:
  enum class Opening : std::uint8_t {
    kMade,   ///< where there is no such file it is made
    kThere,  ///< there has to be one
  };
  static Sql<Database> open(const std::string& path, Opening opening);

  /// Statements without a result.
  Sql<void> run(const char* sql);
  Sql<Statement> prepare(std::string_view sql);
  /// The only number that a statement gives.
  Sql<std::int64_t> number(std::string_view sql);
  /// What it holds is copied to the main file, as far as that can be done, when it is closed: or not.
  void leave_as_it_is();

 private:
  struct Close {
    void operator()(sqlite3* connection) const;
  };
  explicit Database(sqlite3* connection) : connection_(connection) {}

  std::unique_ptr<sqlite3, Close> connection_;
};

/// One statement, for as often as it is needed. Ends before its database.
class Statement {
 public:
  /// @param index  of the statement's values, from 1
  Sql<void> set(int index, std::int64_t value);
  /// @param bytes  outlive the next `step`
  Sql<void> set(int index, std::string_view bytes);
  /// False: there is no further row, and values can be set anew.
  Sql<bool> step();
  /// As `step`, of a statement without rows.
  Sql<void> run();
  /// Of the row that `step` has found.
  /// @param column  from 0
  std::int64_t number(int column) const;
  std::string bytes(int column) const;

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  explicit Statement(sqlite3_stmt* statement) : statement_(statement) {}

  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

}  // namespace mlab::journal
