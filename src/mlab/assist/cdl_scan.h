#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "mlab/assist/component.h"
#include "mlab/assist/name.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/text/source.h"

/// A configuration as far as it is written, out of the parser's tree: everything that has a name, what each
/// name is, and what could come next where the text ends.
namespace mlab::assist {

/// `let NAME = ...;`
struct CdlLet {
  std::string name;
  text::Span span;
  text::Span whole;
  std::string help;
  const cdl::Expression* value = nullptr;
  bool is_subject = false;  ///< of a test: `it`, which nobody has written
};

struct CdlState {
  std::string name;
  text::Span span;
  text::Span whole;  ///< with its transitions
  std::string help;
  std::uint32_t sequence = 0;  ///< where its sequence begins
  bool is_start = false;
  bool is_final = false;
};

/// `... as NAME`
struct CdlNode {
  std::string name;
  text::Span span;
  const cdl::Expression* value = nullptr;
};

/// A sensor or actuator of a class of robots.
struct CdlDevice {
  std::string name;
  text::Span span;
  text::Span whole;
  std::string binds;
  std::string by;
  std::string help;
  bool is_actuator = false;
};

struct CdlParameter {
  ComponentInput input;
  text::Span span;  ///< of its name
  text::Span whole;
};

struct CdlDeclaration {
  NameKind kind = NameKind::kAssemblage;
  std::string name;
  text::Span span;
  text::Span whole;
  std::string help;
  std::vector<CdlParameter> parameters;
  std::string result_type;
  const cdl::Assemblage* assemblage = nullptr;  ///< that it is
  const cdl::Robot* robot = nullptr;
  std::vector<CdlLet> lets;
  std::vector<CdlState> states;
  std::vector<CdlNode> nodes;
  std::vector<const cdl::Expression*> formulas;  ///< arithmetic, the outer ones first
  std::vector<CdlDevice> devices;
  std::string class_name;  ///< of a robot
};

/// Which value is expected at a place.
struct CdlWanted {
  int call = -1;              ///< index of the callee among the names; -1: no call
  std::string argument = {};  ///< its name; empty: by position
  int position = 0;
  ValueType type = {};   ///< where it is no call that says it
  bool in_list = false;  ///< inside of `[...]`
};

struct CdlName {
  text::Span span;
  NameKind kind = NameKind::kNode;
  bool is_declaration = false;
  bool is_value = false;  ///< a name that stands for a value: let, parameter or word
  std::string text = {};
  int declaration = -1;        ///< that it stands in
  std::uint32_t sequence = 0;  ///< of a state, where it begins
  CdlWanted wanted = {};       ///< of a value; the call of an argument
  int owner = -1;              ///< of a layout: index of its owner's name
  int before = -1;             ///< of a layout: index of the name that it stands inside of
};

/// What could come where the text ends.
struct CdlWant {
  enum class Kind : std::uint8_t {
    kKeyword,   ///< one of `words`
    kValue,     ///< an expression of what is wanted
    kArgument,  ///< the name of an argument of `wanted.call`, or a value
    kUnit,      ///< a unit for what is wanted
    kUnitName,  ///< any unit
    kType,      ///< a type
    kState,     ///< a state of `sequence`
    kOperator,  ///< a procedure with a list input
    kClass,     ///< a class of robots
    kMember,    ///< a robot or society
    kSocietyOperator,
    kDevice,    ///< a device of the robot's class
    kBinding,   ///< a binding point
    kActuator,  ///< a binding point or device that a robot drives
    kBodySetting,
    kCaseValue,  ///< a word of what `selector` gives
    kNode,       ///< a node or state of what a layout is of
    kOwner,      ///< a declaration
    kPercept,    ///< what a test may say that is sensed
    kAction,     ///< what a test may expect to be done
    kTestState,  ///< a state of what the call `wanted.call` instantiates
    kFile
  };
  Kind kind = Kind::kKeyword;
  std::vector<std::string> words = {};
  CdlWanted wanted = {};
  const cdl::Expression* selector = nullptr;  ///< kCaseValue
  std::set<std::string> given = {};           ///< arguments that are there already
  int positional = 0;                         ///< how many are given by position
  std::uint32_t sequence = 0;                 ///< where it begins
  std::string device = {};                    ///< chosen one, where its binding is wanted
};

struct CdlScan {
  text::SourcePtr source;
  cdl::PartialFile written;  ///< what follows points into it
  std::vector<CdlDeclaration> declarations;
  std::vector<CdlName> names;
  std::vector<CdlName> uses;    ///< files, without quotes
  std::vector<CdlName> places;  ///< the texts of `place("Pond")`, without quotes
  /// A number, text or list that is given to a call.
  struct Literal {
    text::Span span;
    CdlWanted wanted;
    bool lacks_unit = false;  ///< a number that says none
  };
  std::vector<Literal> literals;
  // Where the text ends:
  std::vector<CdlWant> wants;
  int open_declaration = -1;  ///< that the end stands in
  /// Calls whose parentheses are open at the end, the innermost last: index of the callee, arguments before.
  struct OpenCall {
    int callee = -1;
    int position = 0;
    std::string argument;
  };
  std::vector<OpenCall> open_calls;
};

/// Reads any text. Never fails; deep nesting is cut off.
CdlScan scan_cdl(const text::SourcePtr& source);

}  // namespace mlab::assist
