#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/text/source.h"

namespace mlab::console {

/// Bytes [begin, end) of a source, and what stands there afterwards.
struct Splice {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::string text;
};

/// Gathers changes of words of a text, so that all else in it stays byte for byte: comments, layout,
/// characters that mean nothing. Positions are those of the text before.
class Splices {
 public:
  /// @param words  of the language that the text is in, in order
  Splices(text::SourcePtr source, std::vector<text::Span> words);

  const text::SourcePtr& source() const { return source_; }

  /// Another word, or several, in place of one.
  void replace(text::Span word, std::string_view by);
  /// The words that lie in the range go, with the blanks and line ends that only they needed.
  void erase(text::Span range);
  /// Words behind a word.
  void insert_behind(text::Span word, std::string_view what);
  /// A line behind the line of a word; where another word follows on that line, between the two.
  void add_line_behind(text::Span word, std::string_view line);
  /// A line before a word.
  void add_line_before(text::Span word, std::string_view line);
  /// A line at the end of the text.
  void add_line_at_end(std::string_view line);

  /// All changes as one; nothing where two of them are about the same words and differ.
  std::optional<Splice> joined() const;
  bool is_empty() const { return splices_.empty() && lines_at_end_.empty(); }

 private:
  void erase_run(std::uint32_t begin, std::uint32_t end);
  bool is_blank(std::size_t at) const;
  bool is_space(std::size_t at) const;
  bool starts_line(std::size_t at) const;
  std::uint32_t next_word(std::uint32_t from) const;
  std::string line(std::string_view text) const;

  text::SourcePtr source_;
  std::string_view text_;
  std::vector<text::Span> words_;
  std::string line_end_;
  std::vector<Splice> splices_;
  std::string lines_at_end_;
};

}  // namespace mlab::console
