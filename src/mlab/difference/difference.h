#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "mlab/lang/cdl/lower/elaboration.h"
#include "mlab/lang/cdl/syntax/tree.h"
#include "mlab/text/source.h"

namespace mlab::difference {

/// What became of a thing.
enum class What : std::uint8_t { kAdded, kRemoved, kChanged, kRenamed, kMoved };

/// What it is that was compared.
enum class Thing : std::uint8_t {
  kUse,           ///< `use "skills.cdl"`
  kArchitecture,  ///< `architecture UGV`
  kDeclaration,   ///< an assemblage, a robot, a class, ...
  kParameter,
  kSetting,  ///< of a class's body
  kDevice,
  kChoice,  ///< `use sonars for sense_obstacles`
  kNode,
  kResult,  ///< what a page gives
  kState,
  kTransition,
  kNote  ///< a comment or frame on the canvas
};

/// One thing about something that both versions have: `persistence` was `12 s` and is `6 s`.
struct Detail {
  std::string what;
  std::string before;  ///< empty: nothing stood there
  std::string after;
};

struct Difference {
  What what = What::kChanged;
  Thing thing = Thing::kNode;
  std::string kind;         ///< in a word: `assemblage`, the component of a node, where a transition goes
  std::string page_before;  ///< path of the page it is on, or its declaration; empty: the file's own
  std::string page_after;
  std::string name_before;  ///< of a transition its state; empty: it was not there
  std::string name_after;
  int index_before = -1;  ///< of a transition, among those of its state
  int index_after = -1;
  text::Place place_before;  ///< without a source where it was not there
  text::Place place_after;
  std::vector<Detail> details;
};

/// A page that both versions have, with what its nodes and states are called in both.
struct SamePage {
  std::string before;
  std::string after;
  std::vector<std::pair<std::string, std::string>> names;
};

struct Comparison {
  std::vector<Difference> meaning;
  std::vector<Difference> layout;  ///< what was only moved on a page, and notes on it
  /// Of assemblages and robots in which something differs; all others are the same page by page.
  std::vector<SamePage> pages;
  std::vector<std::pair<std::string, std::string>> owners;  ///< all that both have, what they are called
  bool is_partial = false;                                  ///< of one of both, some could not be read
  bool is_same_text = false;                                ///< byte for byte
  bool has_other_comments = false;                          ///< comments or help differ
  bool has_other_layout = false;                            ///< layouts differ, `layout` may say in what
  bool is_written_otherwise =
      false;  ///< other words, or in another order, though nothing in `meaning` is told

  /// Nothing in `meaning` is told; of a partial one it says so only of what could be read.
  bool is_same() const { return meaning.empty(); }
};

/// One of the two texts. Both parts must outlive the comparison.
struct Version {
  const cdl::Tree& tree;
  const cdl::Elaboration& elaboration;
  bool has_errors = false;  ///< so that something of it may be no part of the tree
};

/// What differs between two texts, as a drawing of them shows it. Whatever could be read is compared; holes
/// in a tree are compared as such. A pure function: the same texts give the same answer.
///
/// Which thing is which is decided so: what its author gave a name is what has that name in the other
/// version. Of the rest, what says the same, word for word; then what drives the same input of the same thing
/// and is of the same component; at last the only one of its component that is left on either side. A name
/// that has gone and one that has come are one thing renamed where what they stand for is the same, or stands
/// in the same place and is of the same component; of declarations, where three fifths of their words are the
/// same.
Comparison compare(const Version& before, const Version& after);

}  // namespace mlab::difference
