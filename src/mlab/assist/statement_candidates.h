#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mlab/assist/service.h"
#include "mlab/lang/odl/write.h"
#include "mlab/mission/mission.h"
#include "mlab/overlay/overlay.h"

namespace mlab::assist {

/// What names there are to be completed in missions and typed commands.
struct KnownNames {
  const mission::Mission* mission = nullptr;  ///< units and robot types; null: none are known
  const overlay::Overlay* map = nullptr;      ///< places; null: none are known
  std::vector<std::string> overlay_files;     ///< as a mission would name them
};

enum class StatementKind : std::uint8_t { kTyped, kMission, kOverlay };

/// What could stand at the end of a text of statements, in the order in which they are declared: words,
/// units, places (found also without the word for their kind), formations, ... that begin with what is
/// written, letter case aside. Names that need quotes have them.
///
/// @param text  up to the cursor
Completions complete_statement(std::string_view text, StatementKind kind, const KnownNames& names);

/// A name as MDL and ODL both read it.
using odl::written_name;
/// The same for a name in a mission, where words of the language stand in quotes.
std::string written_reference(const std::string& name);

/// Gathers what begins with what is written.
class StatementCandidates {
 public:
  /// @param written  up to the cursor, without a quote before it
  StatementCandidates(std::string written, bool is_quoted)
      : written_(std::move(written)), is_quoted_(is_quoted) {}

  void add(const std::string& text, const std::string& kind, const std::string& help = "");
  /// A name, which gets quotes where it needs them. Found by `also`, too.
  void add_name(const std::string& name, const std::string& kind, const std::string& help,
                const std::string& also = "");
  std::vector<Candidate> take() { return std::move(items_); }

 private:
  bool matches(std::string_view candidate) const;

  std::string written_;
  bool is_quoted_;
  std::vector<Candidate> items_;
};

/// @param before  the text up to the word at the cursor
void complete_mission(const std::string& before, bool is_typed, const KnownNames& names,
                      StatementCandidates& out);
void complete_overlay(const std::string& before, StatementCandidates& out);

}  // namespace mlab::assist
