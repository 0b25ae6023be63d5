#include "mlab/study/results_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <string_view>
#include <system_error>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/text/shown.h"

namespace mlab::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr const char* kMark = "mlab_batch";

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json header_json(const Identity& identity) {
  Json out;
  out[kMark] = kFormat;
  for (const auto& [name, word] : identity) out["batch"][name] = word;
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

// Nothing where the line is none of ours.
std::optional<Row> row_in(const Json& json) {
  const auto is_whole = [](const Json& value, std::uint64_t most) {
    return value.is_number_unsigned() && value.get<std::uint64_t>() <= most;
  };
  if (!json.is_object() || !json.contains("key") || !json.contains("numbers") || !json.contains("seed") ||
      !json.contains("success") || !json.contains("outcome"))
    return std::nullopt;
  const Json& key = json["key"];
  const Json& numbers = json["numbers"];
  if (!key.is_array() || key.size() != 3 || !numbers.is_array() || numbers.size() != kNumbers.size() ||
      !is_whole(json["seed"], UINT64_MAX) || !json["success"].is_boolean() || !json["outcome"].is_string())
    return std::nullopt;
  for (const Json& part : key) {
    if (!is_whole(part, UINT32_MAX)) return std::nullopt;
  }
  Row out;
  out.key = {key[0].get<std::uint32_t>(), key[1].get<std::uint32_t>(), key[2].get<std::uint32_t>()};
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

std::string system_error(const char* what) {
  return fmt::format("can't be {}: {}", what, std::generic_category().message(errno));
}

std::optional<std::string> read_all(int descriptor) {
  std::string out;
  char block[1 << 16];
  for (;;) {
    const ssize_t n = ::read(descriptor, block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return std::nullopt;
    if (n == 0) return out;
    out.append(block, static_cast<std::size_t>(n));
  }
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

// Where this batch and that of the file part; empty: nowhere.
std::string difference(const Json& header, const Identity& identity) {
  for (const auto& [name, word] : identity) {
    const bool is_there = header["batch"].contains(name) && header["batch"][name].is_string();
    const std::string there = is_there ? header["batch"][name].get<std::string>() : "";
    if (there == word) continue;
    return fmt::format("holds runs of another batch: its {} is `{}`, here it is `{}`", name,
                       text::shown(there, 100), text::shown(word, 100));
  }
  return {};
}

struct Contents {
  std::vector<Row> rows;
  std::size_t size = 0;  // of whole lines
};

// @param identity  null: whose runs they are does not matter
std::expected<Contents, std::string> understand(std::string_view all, const Identity* identity) {
  Contents out;
  std::size_t line = 0;
  while (out.size < all.size()) {
    const std::size_t end = all.find('\n', out.size);
    const Json json = end == std::string_view::npos
                          ? Json(nullptr)
                          : Json::parse(all.substr(out.size, end - out.size), nullptr, false);
    ++line;
    if (line == 1) {
      if (!json.is_object() || !json.contains(kMark) || json[kMark] != kFormat || !json.contains("batch"))
        return std::unexpected("is no file of a batch's results, and is left alone");
      if (std::string what = identity != nullptr ? difference(json, *identity) : ""; !what.empty())
        return std::unexpected(std::move(what));
    } else if (end != std::string_view::npos) {
      auto row = row_in(json);
      if (!row) return std::unexpected(fmt::format("has something else than a run in line {}", line));
      out.rows.push_back(std::move(*row));
    }
    if (end == std::string_view::npos) break;
    out.size = end + 1;
  }
  return out;
}

}  // namespace

std::optional<std::string> ResultsFile::kept_word(const std::string& path, const std::string& name) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return std::nullopt;
  const auto all = read_all(descriptor);
  ::close(descriptor);
  if (!all) return std::nullopt;
  const Json json = Json::parse(all->substr(0, all->find('\n')), nullptr, false);
  if (!json.is_object() || !json.contains("batch") || !json["batch"].contains(name) ||
      !json["batch"][name].is_string())
    return std::nullopt;
  return json["batch"][name].get<std::string>();
}

std::expected<ResultsFile::Opened, std::string> ResultsFile::open(const std::string& path,
                                                                  const Identity& identity, bool resumes) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
  if (descriptor < 0) return std::unexpected(system_error("opened"));
  Opened out;
  out.file.reset(new ResultsFile(path, descriptor));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0)
    return std::unexpected("is in use by another batch that runs now");
  const auto all = read_all(descriptor);
  if (!all) return std::unexpected(system_error("read"));
  auto contents = understand(*all, resumes ? &identity : nullptr);
  // What was killed before its first line was whole has begun nothing.
  const bool is_unbegun =
      all->find('\n') == std::string::npos && header_json(identity).dump().starts_with(all->substr(0, 12));
  if (is_unbegun) contents = Contents{};
  if (!contents) return std::unexpected(std::move(contents.error()));
  if (!resumes && !contents->rows.empty())
    return std::unexpected(fmt::format(
        "holds {} runs of a batch that was interrupted: --resume goes on with them; else remove it",
        contents->rows.size()));
  if (!resumes) contents->size = 0;  // it was begun and has nothing: perhaps for another batch
  if (::ftruncate(descriptor, static_cast<off_t>(contents->size)) != 0 ||
      ::lseek(descriptor, 0, SEEK_END) < 0 ||
      (contents->size == 0 && !write_all(descriptor, line_of(header_json(identity)))))
    return std::unexpected(system_error("written"));
  out.rows = std::move(contents->rows);
  return out;
}

ResultsFile::~ResultsFile() {
  ::close(descriptor_);
}

bool ResultsFile::append(const Row& row) const {
  return write_all(descriptor_, line_of(row_json(row)));
}

}  // namespace mlab::study
