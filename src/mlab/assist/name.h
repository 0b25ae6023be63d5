#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/text/source.h"

namespace mlab::assist {

/// What a name stands for, in any of the languages.
enum class NameKind : std::uint8_t {
  kAssemblage,
  kProcedure,
  kBinding,
  kClass,
  kRobot,
  kOperator,
  kSociety,
  kTest,     ///< of a component
  kPercept,  ///< that a test gives, or an action that it expects
  kParameter,
  kArgument,  ///< a parameter or input, where it is given
  kLet,
  kNode,
  kState,
  kDevice,
  kBodySetting,
  kType,
  kUnit,  ///< of measure
  kWord,  ///< of a type: `Flag`
  kFile,
  kArchitecture,
  kTeam,       ///< a mission's UNIT
  kRobotType,  ///< a mission's NEW-ROBOT
  kPlace,      ///< a control measure
  kModule,
  kLabel,  ///< a mission's step
  kTitle
};

/// As `Candidate::kind` and `Symbol::kind`.
std::string_view name_of(NameKind kind);

/// One place of a text where something is named.
struct Name {
  text::Span span;  ///< of the name alone, without quotes
  NameKind kind = NameKind::kNode;
  bool is_declaration = false;
  std::string text;
  text::Place target;  ///< the name where it is declared; no source: in no text that is known
  bool is_library = false;
  /// What stands here means it without saying its name: `forager.cdl` a robot that is called as its type.
  bool is_unsaid = false;
};

}  // namespace mlab::assist
