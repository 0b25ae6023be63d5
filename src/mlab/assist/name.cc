#include "mlab/assist/name.h"

namespace mlab::assist {

std::string_view name_of(NameKind kind) {
  switch (kind) {
    case NameKind::kAssemblage:
      return "assemblage";
    case NameKind::kProcedure:
      return "procedure";
    case NameKind::kBinding:
      return "binding";
    case NameKind::kClass:
      return "class";
    case NameKind::kRobot:
      return "robot";
    case NameKind::kOperator:
      return "operator";
    case NameKind::kSociety:
      return "society";
    case NameKind::kTest:
      return "test";
    case NameKind::kPercept:
      return "percept";
    case NameKind::kParameter:
      return "parameter";
    case NameKind::kArgument:
      return "argument";
    case NameKind::kLet:
      return "let";
    case NameKind::kNode:
      return "node";
    case NameKind::kState:
      return "state";
    case NameKind::kDevice:
      return "device";
    case NameKind::kBodySetting:
      return "body setting";
    case NameKind::kType:
      return "type";
    case NameKind::kUnit:
      return "unit";
    case NameKind::kWord:
      return "word";
    case NameKind::kFile:
      return "file";
    case NameKind::kArchitecture:
      return "architecture";
    case NameKind::kTeam:
      return "team";
    case NameKind::kRobotType:
      return "robot type";
    case NameKind::kPlace:
      return "place";
    case NameKind::kModule:
      return "module";
    case NameKind::kLabel:
      return "step";
    case NameKind::kTitle:
      return "title";
  }
  return "";
}

}  // namespace mlab::assist
