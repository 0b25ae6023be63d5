#include "mlab/journal/journal.h"

#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/journal/database.h"
#include "mlab/text/shown.h"

namespace mlab::journal {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kApplication = 0x6d6c6162;  // "mlab"
constexpr const char* kSession = "session";
constexpr const char* kProgress = "progress";

// `hash` is of the bytes beside it: SQLite looks at its pages' structure, not at what stands in them.
constexpr const char* kTables =
    "CREATE TABLE entry (number INTEGER PRIMARY KEY, hash INTEGER NOT NULL, bytes BLOB NOT NULL);"
    "CREATE TABLE note (number INTEGER PRIMARY KEY, bytes BLOB NOT NULL);"
    "CREATE TABLE state (name TEXT PRIMARY KEY, bytes BLOB NOT NULL) WITHOUT ROWID;";

std::int64_t hash_of(std::string_view bytes) {
  return static_cast<std::int64_t>(base::hash_text(bytes));
}

std::string about(const std::string& path, const std::string& message) {
  return fmt::format("`{}`: {}", text::shown(path), message);
}

std::string as_text(const char* sql, std::int64_t number) {
  return fmt::format("{} = {};", sql, number);
}

}  // namespace

struct Journal::State {
  std::string path;
  std::optional<Database> database;
  std::optional<Statement> put_entry;
  std::optional<Statement> put_note;
  std::optional<Statement> drop_notes;
  std::optional<Statement> put_state;
  std::optional<Reach> reach;
  bool has_tables = false;

  Sql<void> open();
  Sql<void> begin(Reach wanted);
  Sql<void> make_tables();
  Sql<void> put(const Batch& batch);
  Sql<void> put(const char* name, std::string_view bytes);
  void close();
};

Sql<void> Journal::State::open() {
  auto opened = Database::open(path, Database::Opening::kMade);
  if (!opened) return std::unexpected(opened.error());
  database = std::move(*opened);
  return database->run("PRAGMA journal_mode = WAL;");
}

Sql<void> Journal::State::begin(Reach wanted) {
  if (reach != wanted) {
    reach.reset();
    auto set = database->run(wanted == Reach::kMachine ? "PRAGMA synchronous = FULL;"
                                                       : "PRAGMA synchronous = NORMAL;");
    if (!set) return set;
    reach = wanted;
  }
  return database->run("BEGIN IMMEDIATE;");
}

Sql<void> Journal::State::make_tables() {
  for (const std::string& sql : {std::string(kTables), as_text("PRAGMA application_id", kApplication),
                                 as_text("PRAGMA user_version", kFormat)}) {
    if (auto made = database->run(sql.c_str()); !made) return made;
  }
  return {};
}

Sql<void> Journal::State::put(const char* name, std::string_view bytes) {
  for (const auto& [index, value] : {std::pair<int, std::string_view>{1, name}, {2, bytes}}) {
    if (auto set = put_state->set(index, value); !set) return set;
  }
  return put_state->run();
}

Sql<void> Journal::State::put(const Batch& batch) {
  if (!put_entry) {
    const auto prepare = [this](std::optional<Statement>& out, const char* sql) -> Sql<void> {
      auto made = database->prepare(sql);
      if (!made) return std::unexpected(made.error());
      out = std::move(*made);
      return {};
    };
    if (auto made = prepare(put_state, "INSERT OR REPLACE INTO state VALUES (CAST(?1 AS TEXT), ?2)"); !made)
      return made;
    if (auto made = prepare(drop_notes, "DELETE FROM note WHERE number <= ?1"); !made) return made;
    if (auto made = prepare(put_note, "INSERT OR REPLACE INTO note VALUES (?1, ?2)"); !made) return made;
    if (auto made = prepare(put_entry, "INSERT INTO entry (hash, bytes) VALUES (?1, ?2)"); !made) return made;
  }
  for (const std::string& entry : batch.entries) {
    if (auto set = put_entry->set(1, hash_of(entry)); !set) return set;
    if (auto set = put_entry->set(2, entry); !set) return set;
    if (auto put = put_entry->run(); !put) return put;
  }
  for (const Note& note : batch.notes) {
    if (auto set = put_note->set(1, static_cast<std::int64_t>(note.number)); !set) return set;
    if (auto set = put_note->set(2, note.bytes); !set) return set;
    if (auto put = put_note->run(); !put) return put;
  }
  if (!batch.notes.empty() && batch.notes.back().number > kMostNotes) {
    const std::uint64_t last = batch.notes.back().number - kMostNotes;
    if (auto set = drop_notes->set(1, static_cast<std::int64_t>(last)); !set) return set;
    if (auto dropped = drop_notes->run(); !dropped) return dropped;
  }
  if (batch.session) {
    if (auto done = put(kSession, *batch.session); !done) return done;
  }
  return batch.progress ? put(kProgress, batch.progress->SerializeAsString()) : Sql<void>{};
}

void Journal::State::close() {
  for (std::optional<Statement>* one : {&put_entry, &put_note, &drop_notes, &put_state}) one->reset();
  database.reset();
}

Journal::Journal(std::unique_ptr<State> state) : state_(std::move(state)) {}

Journal::~Journal() {
  state_->close();
}

std::expected<std::unique_ptr<Journal>, std::string> Journal::create(const std::string& path) {
  std::error_code failure;
  if (fs::exists(path, failure)) return std::unexpected(about(path, "it is there already"));
  auto state = std::make_unique<State>();
  state->path = path;
  if (auto opened = state->open(); !opened) {
    state->close();
    fs::remove(path, failure);
    return std::unexpected(about(path, opened.error().message));
  }
  return std::unique_ptr<Journal>(new Journal(std::move(state)));
}

std::expected<void, std::string> Journal::write(const Batch& batch, Reach reach) {
  State& state = *state_;
  if (!state.database) return std::unexpected(about(state.path, "it was removed"));
  auto done = state.begin(reach);
  const bool has_begun = done.has_value();
  if (done && !state.has_tables) done = state.make_tables();
  if (done) done = state.put(batch);
  if (done) done = state.database->run("COMMIT;");
  if (done) {
    state.has_tables = true;
    return {};
  }
  // SQLite may have rolled back by itself; then this says so, and that is no error.
  if (has_begun) [[maybe_unused]]
    const auto undone = state.database->run("ROLLBACK;");
  if (!state.has_tables) {
    // Prepared for tables that are not there.
    for (std::optional<Statement>* one :
         {&state.put_entry, &state.put_note, &state.drop_notes, &state.put_state})
      one->reset();
  }
  return std::unexpected(about(state.path, done.error().message));
}

void Journal::remove() {
  state_->close();
  std::error_code gone;
  for (const char* end : {"", "-wal", "-shm", "-journal"}) fs::remove(state_->path + end, gone);
}

const std::string& Journal::path() const {
  return state_->path;
}

// ---- what was left

namespace {

Unreadable unreadable(const std::string& path, const SqlError& error) {
  using Kind = Unreadable::Kind;
  const Kind kind = error.kind == SqlError::Kind::kHeld      ? Kind::kHeld
                    : error.kind == SqlError::Kind::kDamaged ? Kind::kForeign
                                                             : Kind::kOther;
  return {kind, about(path, error.message)};
}

std::unexpected<Unreadable> foreign(const std::string& path, const std::string& why) {
  return std::unexpected(Unreadable{Unreadable::Kind::kForeign, about(path, why)});
}

std::expected<Database, Unreadable> open_journal(const std::string& path) {
  auto database = Database::open(path, Database::Opening::kThere);
  if (!database) return std::unexpected(unreadable(path, database.error()));
  database->leave_as_it_is();
  const auto application = database->number("PRAGMA application_id");
  const auto version = application ? database->number("PRAGMA user_version") : application;
  const auto tables = version ? database->number("SELECT count(*) FROM sqlite_master") : version;
  if (!tables) return std::unexpected(unreadable(path, tables.error()));
  if (*application == 0 && *tables == 0)
    return std::unexpected(Unreadable{Unreadable::Kind::kEmpty, about(path, "nothing is in it")});
  if (*application != kApplication) return foreign(path, "it is no journal of a run");
  if (*version != Journal::kFormat)
    return foreign(path, fmt::format("it is of format {}, and this program reads format {}", *version,
                                     Journal::kFormat));
  return std::move(*database);
}

// @return  nothing where it is not there
Sql<std::optional<std::string>> state_of(Database& database, const char* name) {
  auto statement = database.prepare("SELECT bytes FROM state WHERE name = CAST(?1 AS TEXT)");
  if (!statement) return std::unexpected(statement.error());
  if (auto set = statement->set(1, name); !set) return std::unexpected(set.error());
  const auto found = statement->step();
  if (!found) return std::unexpected(found.error());
  if (!*found) return std::nullopt;
  return statement->bytes(0);
}

std::expected<Stand, Unreadable> stand_of(Database& database, const std::string& path) {
  Stand out;
  const auto session = state_of(database, kSession);
  const auto progress = session ? state_of(database, kProgress) : session;
  if (!progress) return std::unexpected(unreadable(path, progress.error()));
  const bool is_whole = *session && *progress && out.session.ParseFromString(**session) &&
                        out.progress.ParseFromString(**progress) && std::isfinite(out.progress.time()) &&
                        std::isfinite(out.progress.written_at()) && std::isfinite(out.session.speed());
  if (!is_whole) return foreign(path, "it does not say how the run stood");
  return out;
}

// The history up to the first entry that is not as it was written.
Sql<void> read_entries(Database& database, Kept& out) {
  auto statement = database.prepare("SELECT hash, bytes FROM entry ORDER BY number");
  if (!statement) return std::unexpected(statement.error());
  for (;;) {
    const auto found = statement->step();
    if (!found) {
      out.cut =
          fmt::format("it can be read up to cycle {}: {}", out.history->last_cycle(), found.error().message);
      return {};
    }
    if (!*found) return {};
    const std::string bytes = statement->bytes(1);
    wire::HistoryEntry entry;
    const bool is_whole = statement->number(0) == hash_of(bytes) && entry.ParseFromString(bytes);
    const std::optional<std::string> problem = is_whole ? out.history->add(entry) : "an entry was damaged";
    if (!problem) continue;
    out.cut = fmt::format("it can be read up to cycle {}: {}", out.history->last_cycle(), *problem);
    return {};
  }
}

Sql<void> read_notes(Database& database, std::vector<Note>& out) {
  auto statement = database.prepare("SELECT number, bytes FROM note ORDER BY number");
  if (!statement) return std::unexpected(statement.error());
  for (;;) {
    const auto found = statement->step();
    if (!found) return std::unexpected(found.error());
    if (!*found) return {};
    out.push_back({static_cast<std::uint64_t>(statement->number(0)), statement->bytes(1)});
  }
}

// The run had come as far as its progress says, whatever was last entered.
void go_to(const wire::JournalProgress& progress, history::History& history) {
  wire::HistoryEntry reached;
  reached.set_cycle(progress.cycle());
  reached.set_time(progress.time());
  history.add(reached);  // where it is before the last entry, that says it
}

}  // namespace

std::expected<Stand, Unreadable> read_stand(const std::string& path) {
  auto database = open_journal(path);
  if (!database) return std::unexpected(database.error());
  return stand_of(*database, path);
}

std::expected<Kept, Unreadable> read_journal(const std::string& path) {
  auto database = open_journal(path);
  if (!database) return std::unexpected(database.error());
  auto stand = stand_of(*database, path);
  if (!stand) return std::unexpected(stand.error());
  Kept out{path, std::move(*stand), std::make_shared<history::History>(), {}, "", nullptr};
  auto read = read_entries(*database, out);
  if (read) read = read_notes(*database, out.notes);
  if (!read) return std::unexpected(unreadable(path, read.error()));
  if (!out.history->has_begun()) return foreign(path, "it does not say what the run was made from");
  if (out.cut.empty()) go_to(out.stand.progress, *out.history);
  out.hold = std::make_shared<Database>(std::move(*database));
  return out;
}

}  // namespace mlab::journal
