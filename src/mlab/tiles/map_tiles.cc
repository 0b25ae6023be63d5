#include "mlab/tiles/map_tiles.h"

#include <sqlite3.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/core.h>

#include "mlab/text/shown.h"
#include "mlab/text/utf8.h"

namespace mlab::tiles {
namespace {

constexpr int kStepsAtOnce = 1000;         // of SQLite's machine, between two looks at how many there were
constexpr std::int64_t kMostSteps = 5000;  // thousands of steps for one answer: a fraction of a second
constexpr int kMostMetadata = 200;         // rows

std::string column_text(sqlite3_stmt* statement, int column) {
  const void* bytes = sqlite3_column_blob(statement, column);
  const auto count = static_cast<std::size_t>(sqlite3_column_bytes(statement, column));
  return bytes == nullptr ? std::string{} : std::string(static_cast<const char*>(bytes), count);
}

std::optional<double> number(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_all = error == std::errc{} && end == text.data() + text.size();
  return is_all && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// Attributions are written as HTML; the page shows text.
std::string without_tags(std::string_view html) {
  std::string out;
  bool is_tag = false;
  for (const char c : html.substr(0, 10 * MapTiles::kMostAttribution)) {
    if (c == '<') is_tag = true;
    if (!is_tag && out.size() < MapTiles::kMostAttribution)
      out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    if (c == '>') is_tag = false;
  }
  while (!out.empty() && !text::is_character_boundary(out, out.size())) out.pop_back();
  for (const auto& [entity, sign] : {std::pair{"&copy;", "©"}, std::pair{"&amp;", "&"}}) {
    for (std::size_t at = out.find(entity); at != std::string::npos; at = out.find(entity, at + 1))
      out.replace(at, std::string_view(entity).size(), sign);
  }
  return text::as_utf8(out);
}

// West, south, east, north.
void set_bounds(std::string_view text, Description& out) {
  std::vector<double> four;
  while (four.size() < 4) {
    const std::size_t comma = text.find(',');
    const std::optional<double> one = number(text.substr(0, comma));
    if (!one) return;
    four.push_back(*one);
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  const bool is_box = four.size() == 4 && four[0] >= -180.0 && four[0] < four[2] && four[2] <= 180.0 &&
                      four[1] >= -90.0 && four[1] < four[3] && four[3] <= 90.0;
  if (!is_box) return;
  out.west = four[0];
  out.south = four[1];
  out.east = four[2];
  out.north = four[3];
}

// By its first bytes; empty: no picture that browsers are to be given.
std::string type_of(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
  if (bytes.starts_with("RIFF") && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP") return "image/webp";
  return "";
}

text::Diagnostic no_tiles(const std::string& path, std::string_view why) {
  text::Diagnostic out;
  out.kind = "no-tiles";
  out.message = fmt::format("`{}` is no map in tiles: {}", text::shown(path, 200), why);
  out.hints.emplace_back("expected an MBTiles file of PNG, JPEG or WebP pictures");
  return out;
}

}  // namespace

void MapTiles::Close::operator()(sqlite3* connection) const {
  sqlite3_close_v2(connection);
}

void MapTiles::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

text::Result<std::shared_ptr<MapTiles>> MapTiles::open(const std::string& path) {
  std::shared_ptr<MapTiles> out(new MapTiles);
  std::string wrong = out->connect(path);
  if (wrong.empty()) wrong = out->describe();
  if (wrong.empty()) wrong = out->find_zooms();
  if (wrong.empty()) wrong = out->look_at_one();
  if (!wrong.empty()) return std::unexpected(no_tiles(path, wrong));
  return out;
}

std::string MapTiles::connect(const std::string& path) {
  sqlite3* connection = nullptr;
  const int code = sqlite3_open_v2(
      path.c_str(), &connection, SQLITE_OPEN_READONLY | SQLITE_OPEN_EXRESCODE | SQLITE_OPEN_NOMUTEX, nullptr);
  connection_.reset(connection);
  if (code != SQLITE_OK) return why();
  // Views stay: many files have their tiles in one.
  for (const auto& [option, value] :
       {std::pair{SQLITE_DBCONFIG_DEFENSIVE, 1}, std::pair{SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
        std::pair{SQLITE_DBCONFIG_ENABLE_TRIGGER, 0}})
    sqlite3_db_config(connection, option, value, nullptr);
  sqlite3_limit(connection, SQLITE_LIMIT_LENGTH, static_cast<int>(kMostBytes));
  sqlite3_progress_handler(
      connection, kStepsAtOnce,
      [](void* self) { return ++static_cast<MapTiles*>(self)->steps_ > kMostSteps ? 1 : 0; }, this);
  const Statement check = prepare("PRAGMA cell_size_check = ON");
  if (check) step(check.get());
  return "";
}

std::string MapTiles::describe() {
  const Statement rows = prepare("SELECT name, value FROM metadata");
  if (!rows) return why();
  int code = SQLITE_DONE;
  std::string format;
  description_.least_zoom = description_.most_zoom = -1;
  for (int i = 0; i < kMostMetadata && (code = step(rows.get())) == SQLITE_ROW; ++i) {
    const std::string name = column_text(rows.get(), 0);
    const std::string value = column_text(rows.get(), 1);
    const auto zoom = [&] { return static_cast<int>(std::clamp(number(value).value_or(-1.0), -1.0, 100.0)); };
    if (name == "format") format = value;
    if (name == "minzoom") description_.least_zoom = zoom();
    if (name == "maxzoom") description_.most_zoom = zoom();
    if (name == "bounds") set_bounds(value, description_);
    if (name == "attribution") description_.attribution = without_tags(value);
  }
  if (code != SQLITE_ROW && code != SQLITE_DONE) return why();
  if (format == "pbf" || format == "mvt")
    return fmt::format("its tiles are vectors (`{}`), no pictures", format);
  return "";
}

std::string MapTiles::find_zooms() {
  Description& it = description_;
  if (it.least_zoom < 0 || it.most_zoom < it.least_zoom) {
    const Statement zooms = prepare("SELECT min(zoom_level), max(zoom_level) FROM tiles");
    if (!zooms || step(zooms.get()) != SQLITE_ROW) return why();
    if (sqlite3_column_type(zooms.get(), 0) == SQLITE_NULL) return "it holds no tile";
    it.least_zoom = sqlite3_column_int(zooms.get(), 0);
    it.most_zoom = sqlite3_column_int(zooms.get(), 1);
  }
  if (it.least_zoom < 0 || it.least_zoom > kMostZoom)
    return fmt::format("it begins at zoom {}", it.least_zoom);
  it.most_zoom = std::clamp(it.most_zoom, it.least_zoom, kMostZoom);
  tile_ = prepare("SELECT tile_data FROM tiles WHERE zoom_level = ? AND tile_column = ? AND tile_row = ?");
  return tile_ ? "" : why();
}

std::string MapTiles::look_at_one() {
  const Statement first = prepare("SELECT tile_data FROM tiles LIMIT 1");
  if (!first) return why();
  const int code = step(first.get());
  if (code == SQLITE_DONE) return "it holds no tile";
  if (code != SQLITE_ROW) return why();
  return type_of(column_text(first.get(), 0)).empty() ? "its tiles are no PNG, JPEG or WebP pictures" : "";
}

Tile MapTiles::find(std::uint32_t zoom, std::uint32_t column, std::uint32_t row) const {
  const auto level = static_cast<int>(std::min<std::uint32_t>(zoom, kMostZoom + 1U));
  if (level < description_.least_zoom || level > description_.most_zoom) return {};
  const std::uint32_t side = 1U << zoom;
  if (column >= side || row >= side) return {};
  const std::scoped_lock lock(mutex_);
  sqlite3_bind_int64(tile_.get(), 1, level);
  sqlite3_bind_int64(tile_.get(), 2, column);
  sqlite3_bind_int64(tile_.get(), 3, side - 1 - row);  // in the file, rows count from the south
  Tile out;
  if (step(tile_.get()) == SQLITE_ROW) {
    std::string bytes = column_text(tile_.get(), 0);
    out.content_type = type_of(bytes);
    if (!out.content_type.empty()) out.bytes = std::make_shared<const std::string>(std::move(bytes));
  }
  sqlite3_reset(tile_.get());
  return out;
}

MapTiles::Statement MapTiles::prepare(const char* sql) const {
  steps_ = 0;
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(connection_.get(), sql, -1, &statement, nullptr);
  return Statement(statement);
}

int MapTiles::step(sqlite3_stmt* statement) const {
  steps_ = 0;
  return sqlite3_step(statement);
}

std::string MapTiles::why() const {
  const int code = connection_ ? sqlite3_extended_errcode(connection_.get()) & 0xff : SQLITE_NOMEM;
  const int system = connection_ ? sqlite3_system_errno(connection_.get()) : 0;
  if (code == SQLITE_CANTOPEN && system != 0) return std::generic_category().message(system);
  if (code == SQLITE_INTERRUPT) return "looking at it takes too long";
  return connection_ ? sqlite3_errmsg(connection_.get()) : sqlite3_errstr(code);
}

}  // namespace mlab::tiles
