#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::text {

/// A half-open range of bytes of one source.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  friend constexpr bool operator==(Span, Span) = default;
};

/// Where a byte stands for a person: both count from 1; columns count UTF-8 characters, a tab is one.
struct LineColumn {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

/// The text of one file (or of one typed line), with its name for messages. Immutable, shared by all that
/// point at it.
class Source {
 public:
  /// Parsers take at most this many bytes; `read_source` refuses a larger file.
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

  Source(std::string name, std::string text);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  std::string_view text(Span span) const { return text().substr(span.begin, span.end - span.begin); }
  /// Line and column of a byte offset; an offset past the end counts as the end.
  LineColumn line_column(std::uint32_t offset) const;
  /// The text of a line, counted from 1, without its line end; empty where there is no such line.
  std::string_view line(std::uint32_t number) const;
  std::uint32_t line_count() const { return static_cast<std::uint32_t>(line_starts_.size()); }

 private:
  std::string name_;
  std::string text_;
  std::vector<std::uint32_t> line_starts_;
};

using SourcePtr = std::shared_ptr<const Source>;

/// A place in a source. Without a source it is "nowhere", which a diagnostic prints without a location.
struct Place {
  SourcePtr source;
  Span span;
};

}  // namespace mlab::text
