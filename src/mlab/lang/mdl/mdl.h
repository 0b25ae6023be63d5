#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/mission/mission.h"
#include "mlab/overlay/overlay.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"
#include "mlab/text/source.h"

/// The mission description language: from text to a mission that can be carried out, and back to tidy text.
namespace mlab::mdl {

/// What a mission file says, before any name is looked up. Defined in tree.h.
struct Statement;
struct Tree;

/// Reads the text of a mission, or of a typed command with the words IMMEDIATE COMMAND: before it.
///
/// After an error it goes on with the next statement or step, so one call reports all that is wrong. The tree
/// holds what was understood; where there were errors it is good for looking at, not for printing.
Tree parse(const text::SourcePtr& source, text::Diagnostics& diagnostics);

/// The mission in its canonical layout: one statement per line, keywords in capitals, comments kept.
/// Printing what was parsed from it again changes nothing.
///
/// @param tree  parsed without errors
std::string print(const Tree& tree);

/// One statement as it stands there, without comments and line end. Its numbers and marks have their `text`.
std::string print(const Statement& statement);

/// Says who belongs to the society that NEW-ROBOT names at `place` as its program: the programs of its
/// robots, each with how many there are of it, in rank order.
/// @return  nothing where it names no society; then it is the program of one robot
/// @errors  whatever keeps it from knowing
using SocietyReader = std::function<std::optional<std::vector<std::pair<std::string, int>>>(
    const std::string& program, const text::Place& place, text::Diagnostics& diagnostics)>;

/// What a mission is to have in place of what its text says: `base_velocity=2`.
///
/// - a parameter of robots: of all types that know it, or of one of them: `scout:base_velocity`. It counts as
///   if it stood last in NEW-ROBOT
/// - a number that SET gives: `OBSTACLE-COVERAGE`, in all of the mission
/// - `OVERLAY`, the file in place of the overlay that the mission names; where it names several,
///   `OVERLAY:democ.odl` says which
/// - `FORMATION`, in place of each formation that a command of the plan names, but for No-Formation
struct Setting {
  std::string name;
  std::string value;
  text::Place name_place;
  text::Place value_place;
};

/// What a mission needs from outside its file.
struct LoadOptions {
  /// For CREATE-OBSTACLES where the mission does not SET SEED.
  std::uint64_t seed = 0;
  /// Where overlays and pictures are looked for after the mission's own folder and the current one.
  std::vector<std::string> overlay_folders;
  /// How the mission and all that it names is read.
  text::Files files = text::files_on_disk();
  /// Null: there are no societies.
  SocietyReader societies = nullptr;
  /// Of equal names the last counts.
  std::vector<Setting> settings = {};
};

/// Everything a run needs: overlays loaded, names resolved, robots numbered, random obstacles created.
///
/// @return null where there were errors
/// @errors in `diagnostics`: whatever keeps the mission from being understood; warnings for the rest
std::shared_ptr<const mission::Mission> load_mission(const std::string& path, text::Diagnostics& diagnostics,
                                                     const LoadOptions& options = {});
/// The same for text that is already at hand.
///
/// @param folder  where overlays are looked for first; empty: the current folder
std::shared_ptr<const mission::Mission> check_mission(const text::SourcePtr& source,
                                                      const std::string& folder,
                                                      text::Diagnostics& diagnostics,
                                                      const LoadOptions& options = {});

/// Only the map: what the overlays and the preamble say of it, as far as they can be understood, whatever is
/// wrong with the rest. For a mission without errors it is that mission's overlay.
overlay::Overlay check_map(const text::SourcePtr& source, const std::string& folder,
                           text::Diagnostics& diagnostics, const LoadOptions& options = {});

/// Where the overlay that a mission of this folder names `name` is; nothing where there is none.
std::optional<std::string> find_overlay(const std::string& name, const std::string& folder,
                                        const LoadOptions& options);

/// A line typed by the operator, resolved against the mission that is loaded.
struct Immediate {
  /// For mission::event::Typed. Their units are indices into `edited` where there is one, else into the
  /// mission that the line was read against.
  std::vector<mission::Command> commands;
  /// The mission with the units, robots, obstacles and settings that the line added. Its first units and
  /// robots are the old ones, unmoved, unless a name was defined anew. Null where the line added nothing.
  std::shared_ptr<const mission::Mission> edited;
  /// The obstacles of `edited` are not those of the mission before.
  bool changes_obstacles = false;
};

/// Reads a typed line: `UNIT scouts MOVETO PP-Charlie`, several joined by AND, IMMEDIATE COMMAND: before it
/// or not.
///
/// @return nothing where there were errors
std::optional<Immediate> parse_immediate(const std::string& line, const mission::Mission& mission,
                                         text::Diagnostics& diagnostics, const LoadOptions& options = {});

/// Tells a mission from the other languages by what stands in it.
bool looks_like_mdl(std::string_view text);

}  // namespace mlab::mdl
