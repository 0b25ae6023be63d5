#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/text/source.h"

namespace mlab::cdl_historic {

/// A word as its author wrote it, and where. Empty text: it was not said.
struct Word {
  std::string text;
  text::Place place;
};

/// Where a thing stands on the historic screen [pixels, y down], and what is written beside it.
struct Spot {
  bool has_position = false;
  double x = 0.0;
  double y = 0.0;
  Word label;
};

struct Expr;
using ExprPtr = std::shared_ptr<const Expr>;
struct Setting;

/// `{^}`, `{^Type %name}`, `{^Type {& %a %b}}`: a value from further out.
struct PushedUp {
  Word type;
  Word name;    ///< without `%`; empty: the parameter's own
  Word second;  ///< partner that is put behind a comma; empty: none
};

/// `if [ %Delay = {3}, Wait ] goto Going`
struct Rule {
  std::vector<Setting> members;
  Word target;
  Spot spot;
};

/// What stands on the right of `=`.
struct Value {
  enum class Kind {
    kNone,      ///< `p = ,`: left open
    kConstant,  ///< `{0.5}`
    kExpr,
    kPushedUp,
    kBare,  ///< `^`
    kRule,
    kList  ///< `( ... )`
  };
  Kind kind = Kind::kNone;
  Word constant;  ///< kConstant: the text between the braces
  ExprPtr expr;
  PushedUp up;
  std::shared_ptr<const Rule> rule;
  std::vector<Setting> list;
  text::Place place;
};

/// One entry of an argument list, a group or a rule: `name = value`, `name[index] = value`, `%name = value`,
/// or just an expression.
struct Setting {
  Word name;  ///< empty: an expression by itself
  Word index;
  bool is_pushed = false;
  Spot spot;  ///< behind the name or index
  Value value;
};

/// A reference (`Stop`), an instance (`brain:FSA( ... )`) or a group (`[ ... ]`).
struct Expr {
  enum class Kind { kReference, kInstance, kGroup };
  Kind kind = Kind::kReference;
  std::vector<Word> inline_names;  ///< `agent:device:CLASS(`
  Word name;                       ///< what is referred to or instantiated; empty for a group
  std::vector<Setting> settings;   ///< arguments, or members
  Spot spot;
  text::Place place;
};

/// `instAgent <1,2> |text| name from ...;`
struct Instance {
  enum class Kind { kAgent, kOperator, kBindingPoint, kSensor, kActuator, kRobot, kGroup };
  Kind kind = Kind::kAgent;
  Word name;
  Spot spot;
  ExprPtr what;  ///< its inline names are empty, unless it is a device's agent
};

/// `list const double gain = {0.5}` in a definition.
struct ParamDecl {
  Word type;
  Word name;
  bool is_list = false;
  bool is_const = false;
  Word initial;  ///< text between the braces; empty place: none
};

/// `sensor odo:GET_LOCATION` in a robot's definition.
struct SlotDecl {
  bool is_actuator = false;
  Word name;
  Word device_class;
};

/// `defAgent`, `defOp`, `defSensor`, `defRobot`, ...
struct Definition {
  enum class Kind { kAgent, kOperator, kInputPoint, kOutputPoint, kRobotPoint, kSensor, kActuator, kRobot };
  Kind kind = Kind::kAgent;
  Word architecture;  ///< in brackets; empty: the one that is bound
  Word binds;
  Word type;  ///< of its output; empty: none
  Word name;
  Word style;  ///< of operators: `FSAstyle`, ...
  Word label;
  std::vector<ParamDecl> params;
  std::vector<SlotDecl> slots;
};

/// `defNamedValue NAME ForDataType TYPE = {value};`
struct NamedValue {
  Word name;
  Word type;
  Word value;
};

/// One file, in the order of its statements. After errors it has holes, never wrong parts.
struct Tree {
  text::SourcePtr source;
  std::vector<Word> architectures;      ///< `bindArch`, in order
  std::vector<Word> own_architectures;  ///< `defArch`
  std::vector<Word> types;              ///< `defType`
  std::vector<Definition> definitions;
  std::vector<NamedValue> named_values;
  std::vector<Instance> instances;
  std::vector<ExprPtr> expressions;  ///< at the top; the last one is the configuration
};

}  // namespace mlab::cdl_historic
