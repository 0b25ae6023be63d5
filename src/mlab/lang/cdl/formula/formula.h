#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/syntax/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// Brackets of a sentence may stand this deep in each other.
inline constexpr int kMaxFormulaDepth = 1000;

/// What one symbol of a sentence stands for.
struct FormulaName {
  std::string symbol;  ///< `p1`, `+2`
  std::string what;    ///< `DetectObstacles`, `cooperate`, `sequence of Searching, Acquiring`
  std::string owner;   ///< the assemblage or robot that it stands in
};

/// A configuration in the grammar G: a sentence for each society, and for each robot that is in none.
struct Formula {
  std::vector<std::string> sentences;
  std::vector<FormulaName> names;  ///< in the order in which they appear
};

/// The configuration as sentences of G.
///
/// - A motor part without perception has the empty percept `p0`.
/// - Several percepts of one process are a fusion `#`, and so is a percept that is computed from several.
/// - An operator with one member prints as the member; several actuators of a robot are one `@`.
/// - What G has no sign for is left out: gains, triggers, constants.
/// - A node with several readers is one instance and stands wherever it is read, with the same number; the
///   robots of a team are alike, numbers too.
/// - Instances are counted from 1 in the order of the sentence, except for those that are called like one
///   (`p7`, `cooperate { ... } as cooperation3`): they keep their number.
///
/// @param library  tells what gives a movement (a Vector without a unit) and what a percept
/// @errors  `no-robot`; `nested-too-deep`, `recursion`, `formula-too-long`
Formula formula(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink);

/// The sentences, and behind them what the names stand for, as comments: a file that `parse_formula` reads.
std::string print(const Formula& formula);

/// Reads sentences of G. Their tree declares each process as an empty assemblage of its name, so it can be
/// checked, drawn, and filled in. G says nothing of triggers: states follow each other when `advance` is
/// true.
///
/// `formula(parse_formula(text))` has the sentences of the text.
///
/// @errors  `formula-syntax`, `nested-too-deep`, `too-few-members`, `two-meanings` (an instance that is used
///          twice, and not the same way), `instance-of-another-robot`, `unlike-team`, `number-out-of-range`
Tree parse_formula(const text::SourcePtr& source, text::Diagnostics& sink);

/// Whether this is a sentence of G, told by how it starts.
bool looks_like_formula(std::string_view text);

}  // namespace mlab::cdl
