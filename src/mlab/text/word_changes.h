#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/text/source.h"
#include "mlab/text/splice.h"

namespace mlab::text {

/// A word that is to stand in a statement.
struct Word {
  std::string text;          ///< of one that is new
  std::optional<Span> from;  ///< it stands in the text already, and stays as its author wrote it
};

/// Gathers changes of words of a text, so that all else in it stays byte for byte: comments, layout,
/// characters that mean nothing. Positions are those of the text before.
class WordChanges {
 public:
  /// @param words  of the language that the text is in, in order
  WordChanges(SourcePtr source, std::vector<Span> words);

  const SourcePtr& source() const { return source_; }

  /// Another word, or several, in place of one.
  void replace(Span word, std::string_view by);
  /// The words that lie in the range become these: those that stand there already stay, in their order; of
  /// the others as many are written in the place of old ones as there are, and the rest comes or goes.
  void reword(Span range, const std::vector<Word>& now);
  /// The words that lie in the range go, with the blanks and line ends that only they needed.
  void erase(Span range);
  /// Words behind a word.
  void insert_behind(Span word, std::string_view what);
  /// A line behind the line of a word; where another word follows on that line, between the two.
  void add_line_behind(Span word, std::string_view line);
  /// A line before a word.
  void add_line_before(Span word, std::string_view line);
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

  SourcePtr source_;
  std::string_view text_;
  std::vector<Span> words_;
  std::string line_end_;
  std::vector<Splice> splices_;
  std::string lines_at_end_;
};

}  // namespace mlab::text
