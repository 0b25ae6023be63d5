#include "mlab/lsp/framing.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

#include <fmt/core.h>

namespace mlab::lsp {
namespace {

bool is_same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// @return nothing where it is missing or no number
std::optional<std::uint64_t> content_length(std::string_view header) {
  std::optional<std::uint64_t> out;
  while (!header.empty()) {
    const std::size_t end = std::min(header.find('\n'), header.size());
    const std::string_view line = header.substr(0, end);
    header.remove_prefix(std::min(end + 1, header.size()));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || !is_same_word(trimmed(line.substr(0, colon)), "Content-Length"))
      continue;
    const std::string_view digits = trimmed(line.substr(colon + 1));
    std::uint64_t value = 0;
    const auto [last, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (failure != std::errc{} || last != digits.data() + digits.size()) return std::nullopt;
    out = value;
  }
  return out;
}

}  // namespace

std::optional<MessageReader::Message> MessageReader::next() {
  if (skip_ > 0) {
    const std::size_t skipped = std::min(skip_, buffer_.size());
    buffer_.erase(0, skipped);
    skip_ -= skipped;
    if (skip_ > 0) return std::nullopt;
  }
  std::size_t end = buffer_.find("\r\n\r\n");
  std::size_t mark = 4;
  if (const std::size_t bare = buffer_.find("\n\n"); bare < end) {
    end = bare;
    mark = 2;
  }
  if (end == std::string::npos) {
    if (buffer_.size() <= kMostHeaderBytes) return std::nullopt;
    buffer_.clear();
    return Message{"", "a header without an end"};
  }
  const std::optional<std::uint64_t> length = content_length(std::string_view(buffer_).substr(0, end));
  if (!length) {
    buffer_.erase(0, end + mark);
    return Message{"", "a header without a `Content-Length` that is a number"};
  }
  if (*length > kMostBytes) {
    buffer_.erase(0, end + mark);
    skip_ = static_cast<std::size_t>(*length);
    return Message{"", fmt::format("a message of {} bytes; at most {} are read", *length, kMostBytes)};
  }
  if (buffer_.size() - end - mark < *length) return std::nullopt;
  Message out{buffer_.substr(end + mark, static_cast<std::size_t>(*length)), ""};
  buffer_.erase(0, end + mark + static_cast<std::size_t>(*length));
  return out;
}

std::string framed(std::string_view body) {
  return fmt::format("Content-Length: {}\r\n\r\n{}", body.size(), body);
}

}  // namespace mlab::lsp
