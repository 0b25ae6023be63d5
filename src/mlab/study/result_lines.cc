#include "mlab/study/result_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/mcap/encode.h"
#include "mlab/text/shown.h"

namespace mlab::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr const char* kMark = "mlab_batch";
constexpr const char* kEnd = "is_over";
constexpr const char* kRecording = "recording";
constexpr const char* kCheck = "crc";

// What a line ends with: the last member of its object, of all that is before it.
std::string check_of(std::string_view before) {
  return fmt::format(R"(,"{}":"{:08x}"}})", kCheck, mcap::crc32(std::as_bytes(std::span(before))));
}

std::string line_of(const Json& json) {
  std::string out = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  out.pop_back();
  return out + check_of(out) + "\n";
}

// Nothing that counts where the line is not as it was written.
Json json_in(std::string_view line) {
  Json out = Json::parse(line, nullptr, false);
  if (!out.is_object() || !out.contains(kCheck)) return out;
  const std::size_t size = check_of("").size();
  const bool fits = line.size() > size && line.ends_with(check_of(line.substr(0, line.size() - size)));
  if (!fits) out = Json::value_t::discarded;
  return out;
}

Json row_json(const Row& row) {
  Json numbers = Json::array();
  for (const double number : row.numbers)
    numbers.push_back(std::isnan(number) ? Json(nullptr) : Json(number));
  Json out = {{"key", {row.key.version, row.key.combination, row.key.run}},
              {"seed", row.seed},
              {"success", row.success},
              {"outcome", row.outcome},
              {"numbers", std::move(numbers)}};
  if (!row.cause.empty()) out["cause"] = row.cause;
  if (!row.message.empty()) out["message"] = row.message;
  return out;
}

bool is_whole(const Json& value, std::uint64_t most) {
  return value.is_number_unsigned() && value.get<std::uint64_t>() <= most;
}

std::optional<RunKey> key_in(const Json& key) {
  if (!key.is_array() || key.size() != 3) return std::nullopt;
  for (const Json& part : key) {
    if (!is_whole(part, UINT32_MAX)) return std::nullopt;
  }
  return RunKey{key[0].get<std::uint32_t>(), key[1].get<std::uint32_t>(), key[2].get<std::uint32_t>()};
}

std::optional<std::pair<RunKey, std::string>> recording_in(const Json& json) {
  if (!json.is_object() || !json.contains(kRecording) || !json[kRecording].is_string() ||
      !json.contains("key"))
    return std::nullopt;
  const auto key = key_in(json["key"]);
  if (!key) return std::nullopt;
  return std::pair(*key, json[kRecording].get<std::string>());
}

// Nothing where the line is none of ours.
std::optional<Row> row_in(const Json& json) {
  if (!json.is_object() || !json.contains("key") || !json.contains("numbers") || !json.contains("seed") ||
      !json.contains("success") || !json.contains("outcome"))
    return std::nullopt;
  const auto key = key_in(json["key"]);
  const Json& numbers = json["numbers"];
  if (!key || !numbers.is_array() || numbers.size() != kNumbers.size() ||
      !is_whole(json["seed"], UINT64_MAX) || !json["success"].is_boolean() || !json["outcome"].is_string())
    return std::nullopt;
  Row out;
  out.key = *key;
  out.seed = json["seed"].get<std::uint64_t>();
  out.success = json["success"].get<bool>();
  out.outcome = json["outcome"].get<std::string>();
  for (std::size_t i = 0; i < kNumbers.size(); ++i) {
    if (numbers[i].is_number()) out.numbers[i] = numbers[i].get<double>();
  }
  for (const auto& [name, into] : {std::pair("cause", &out.cause), std::pair("message", &out.message)}) {
    if (json.contains(name) && json[name].is_string()) *into = json[name].get<std::string>();
  }
  return out;
}

}  // namespace

std::string header_line(const Identity& identity) {
  Json out;
  out[kMark] = kFormat;
  for (const auto& [name, word] : identity) out["batch"][name] = word;
  return line_of(out);
}

std::string row_line(const Row& row) {
  return line_of(row_json(row));
}

std::string recording_line(const RunKey& key, const std::string& file) {
  return line_of({{"key", {key.version, key.combination, key.run}}, {kRecording, file}});
}

std::string end_line() {
  return line_of({{kEnd, true}});
}

std::optional<Identity> header_in(std::string_view line) {
  const Json json = json_in(line);
  if (!json.is_object() || !json.contains(kMark) || json[kMark] != kFormat || !json.contains("batch") ||
      !json["batch"].is_object())
    return std::nullopt;
  Identity out;
  for (const auto& [name, word] : json["batch"].items()) {
    if (word.is_string()) out.emplace_back(name, word.get<std::string>());
  }
  return out;
}

std::string word_in(const Identity& identity, std::string_view name) {
  for (const auto& [key, word] : identity) {
    if (key == name) return word;
  }
  return {};
}

bool has_word(const Identity& identity, std::string_view name) {
  return std::ranges::any_of(identity, [&](const auto& word) { return word.first == name; });
}

std::string difference(const Identity& there, const Identity& here) {
  for (const auto& [name, word] : here) {
    const std::string other = word_in(there, name);
    if (other == word) continue;
    if (name == "texts")
      return "holds runs of another batch: the mission, or a file that it takes, has changed since";
    return fmt::format("holds runs of another batch: its {} is `{}`, here it is `{}`", name,
                       text::shown(other, 100), text::shown(word, 100));
  }
  return {};
}

std::expected<Contents, std::string> understand(std::string_view all) {
  Contents out;
  std::size_t line = 0;
  while (out.size < all.size()) {
    const std::size_t end = all.find('\n', out.size);
    const std::string_view text = all.substr(out.size, end - out.size);
    if (++line == 1) {
      auto header = end == std::string_view::npos ? std::nullopt : header_in(text);
      if (!header)
        return std::unexpected(
            "is no file of a batch's results, or its first line is damaged, which says of which batch they "
            "are; it is left alone: to begin anew move it away, or name another file by --results");
      out.header = std::move(*header);
    } else if (end != std::string_view::npos) {
      const Json json = json_in(text);
      if (json.is_object() && json.contains(kEnd)) {
        out.is_over = true;
      } else if (auto row = row_in(json)) {
        out.rows.push_back(std::move(*row));
      } else if (!recording_in(json)) {
        if (out.damaged++ == 0) out.first_damaged = line;
      }
    }
    if (end == std::string_view::npos) break;
    out.size = end + 1;
  }
  return out;
}

std::vector<Row> rows_in(std::string_view lines, std::size_t& size) {
  std::vector<Row> out;
  size = 0;
  for (std::size_t end = lines.find('\n'); end != std::string_view::npos; end = lines.find('\n', size)) {
    if (auto row = row_in(json_in(lines.substr(size, end - size)))) out.push_back(std::move(*row));
    size = end + 1;
  }
  return out;
}

std::map<RunKey, std::string> recordings_in(std::string_view lines) {
  std::map<RunKey, std::string> out;
  for (std::size_t end = lines.find('\n'); end != std::string_view::npos; end = lines.find('\n')) {
    if (auto one = recording_in(json_in(lines.substr(0, end))))
      out.insert_or_assign(one->first, std::move(one->second));
    lines.remove_prefix(end + 1);
  }
  return out;
}

}  // namespace mlab::study
