#pragma once

#include <string>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/mission/mission.h"
#include "mlab/overlay/overlay.h"

namespace mlab::console {

/// What names there are to be completed.
struct KnownNames {
  const mission::Mission* mission = nullptr;  ///< units and robot types; null: none are known
  const overlay::Overlay* map = nullptr;      ///< places; null: none are known
  std::vector<std::string> overlay_files;     ///< as a mission would name them
};

/// What could stand at the cursor: the words of the language that fit there, units, places, formations, ...
/// that begin with what is written (letter case aside; places also without the word for their kind). In the
/// middle of a comment or where only a new name or a number can stand, there is nothing.
///
/// @param request  its cursor may be anywhere; text that is not UTF-8 and broken statements do no harm
Completions complete(const Complete& request, const KnownNames& names);

namespace completion {

/// Gathers what begins with what is written.
class Candidates {
 public:
  /// @param written  up to the cursor, without a quote before it
  Candidates(std::string written, bool is_quoted) : written_(std::move(written)), is_quoted_(is_quoted) {}

  void add(const std::string& text, const std::string& kind, const std::string& help = "");
  /// A name, which gets quotes where it needs them. Found by `also`, too.
  void add_name(const std::string& name, const std::string& kind, const std::string& help,
                const std::string& also = "");
  static constexpr std::size_t kMost = 200;
  std::vector<Completions::Item> take() { return std::move(items_); }

 private:
  bool matches(std::string_view candidate) const;

  std::string written_;
  bool is_quoted_;
  std::vector<Completions::Item> items_;
};

/// @param before  the text up to the word at the cursor
void complete_mission(const std::string& before, bool is_typed, const KnownNames& names, Candidates& out);
void complete_overlay(const std::string& before, Candidates& out);

}  // namespace completion
}  // namespace mlab::console
