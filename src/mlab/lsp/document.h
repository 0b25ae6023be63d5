#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "mlab/assist/service.h"
#include "mlab/lsp/position.h"
#include "mlab/lsp/server.h"

namespace mlab::lsp {

/// An open text.
struct Server::Document {
  std::string uri;
  std::int64_t version = 0;
  assist::Text text;
  std::unique_ptr<LineIndex> lines;
  text::Diagnostics problems;      ///< as they were told last
  text::SourcePtr known;           ///< the text that has them; null: none was told yet
  bool is_unchecked = true;        ///< it changed since
  bool has_unchecked_code = true;  ///< its C++ was not given to the compiler since it was opened or saved

  void set(std::string content) {
    text.source = std::make_shared<const text::Source>(text.source->name(), std::move(content));
    lines = std::make_unique<LineIndex>(text.source->text());
    is_unchecked = true;
  }
};

/// Places of one answer: each text's lines are counted once. For as long as the server's texts stay.
class Server::Locations {
 public:
  explicit Locations(const Server& server) : server_(server) {}
  nlohmann::json at(const text::Place& place);

 private:
  struct KnownSource {
    text::SourcePtr source;
    std::string uri;
    LineIndex lines;
  };
  const Server& server_;
  std::map<const text::Source*, KnownSource> known_;
};

/// Why a request can't be answered.
struct Server::Failure {
  int code = 0;
  std::string message;
};

inline constexpr int kParseError = -32700;
inline constexpr int kInvalidRequest = -32600;
inline constexpr int kMethodNotFound = -32601;
inline constexpr int kInvalidParams = -32602;
inline constexpr int kServerNotInitialized = -32002;
inline constexpr int kRequestFailed = -32803;
inline constexpr int kRequestCancelled = -32800;

inline nlohmann::json position_json(const LineIndex& lines, std::uint32_t offset) {
  const Position at = lines.position(offset);
  return {{"line", at.line}, {"character", at.character}};
}
inline nlohmann::json range_json(const LineIndex& lines, text::Span span) {
  return {{"start", position_json(lines, span.begin)}, {"end", position_json(lines, span.end)}};
}
/// SymbolKind of assist::Symbol::kind
int symbol_kind(const std::string& kind);
/// @return the first line's start where it is no position
Position position_of(const nlohmann::json& json);
/// Both the first line's start where it is no range.
std::pair<Position, Position> positions_of(const nlohmann::json& range);
text::Span span_of(const LineIndex& lines, const nlohmann::json& range);

}  // namespace mlab::lsp
