#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mlab/documents/drafts.h"

namespace mlab::documents {

/// What is known of the draft of an open text.
struct DraftState {
  std::uint64_t kept = 0;    ///< revision of the text that it has; 0: there is none
  std::uint64_t synced = 0;  ///< revision that is on the disk for sure
  std::uint64_t tried = 0;   ///< revision at which it was tried last to bring it up to date
  double time = -1e9;        ///< when that was [s]
  std::string problem;       ///< why it is not up to date; empty: it is
};

/// Brings drafts up to date with their texts, and knows why where that can't be done.
class DraftKeeper {
 public:
  /// A text, of which a draft is wanted while it is not saved.
  struct Text {
    std::string_view path;
    std::string_view text;
    const std::string* file;     ///< what stands on disk; null: it has no file
    std::uint64_t revision = 0;  ///< grows with every change
    bool is_unsaved = false;
    std::string_view older_file =
        {};  ///< digest of what it was typed on, where that is not `file`; else empty
  };
  enum class When { kNowAndThen, kAtOnce };

  explicit DraftKeeper(Drafts& drafts) : drafts_(drafts), folder_problem_(drafts.problem()) {}

  /// @param now   any clock that does not go back [s]
  /// @param when  what failed is tried again at once, or after a second
  void follow(const Text& text, DraftState& state, double now, When when = When::kNowAndThen);
  /// Waits until the draft is on the disk.
  void sync(std::string_view path, DraftState& state) const;
  /// Looks now and then whether drafts that could not be kept can be by now.
  void look(double now);
  /// Why no draft could be kept; empty: one could.
  const std::string& folder_problem() const { return folder_problem_; }

 private:
  Drafts& drafts_;
  std::string folder_problem_;
  double looked_ = -1e9;
};

}  // namespace mlab::documents
