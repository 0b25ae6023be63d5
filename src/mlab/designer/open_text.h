#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::designer {

/// A text that is being edited: every change can be undone, without limit.
class OpenText {
 public:
  explicit OpenText(std::string text) : text_(std::move(text)) {}

  const std::string& text() const { return text_; }
  /// Grows with every change, undone ones as well.
  std::uint64_t revision() const { return revision_; }

  /// Puts another text in this one's place, as one step. Steps of the same name within a second of each other
  /// are one, where `may_merge`.
  /// @param now  any clock that does not go back [s]
  void change(std::string text, std::string name, double now, bool may_merge = false);
  /// False where there is nothing to undo.
  bool undo();
  bool redo();
  /// What they would do; empty: nothing.
  std::string undo_name() const { return done_ == 0 ? "" : steps_[done_ - 1].name; }
  std::string redo_name() const { return done_ == steps_.size() ? "" : steps_[done_].name; }
  /// The next change is a step of its own.
  void separate() { may_merge_ = false; }

 private:
  struct Splice {
    std::size_t begin = 0;
    std::string removed;
    std::string inserted;
  };
  struct Step {
    std::string name;
    double time = 0.0;
    std::vector<Splice> splices;
  };

  std::string text_;
  std::uint64_t revision_ = 1;
  std::vector<Step> steps_;
  std::size_t done_ = 0;
  bool may_merge_ = false;
};

/// Two changes of the same text as one: by lines, as `diff3` does.
/// @return  nothing where both changed the same lines in different ways
std::optional<std::string> merged(std::string_view base, std::string_view ours, std::string_view theirs);

/// What a text without a file is called: the file that it was imported from, what it declares, or that it is
/// new.
std::string unsaved_title(std::string_view text);

/// What a configuration is for: the first sentence of the comment that it begins with, at most some 140
/// letters; empty where it begins with none.
/// @param text  its beginning is enough
std::string said_of(std::string_view text);

}  // namespace mlab::designer
