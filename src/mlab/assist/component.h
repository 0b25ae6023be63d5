#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/behavior.h"
#include "mlab/flow/library.h"
#include "mlab/lang/cdl/types/arithmetic.h"
#include "mlab/lang/cdl/types/port_type.h"
#include "mlab/lang/cnl/tree.h"
#include "mlab/text/source.h"

namespace mlab::assist {

/// A type of values with the unit of its numbers; empty: not known.
struct ValueType {
  std::string type;  ///< a type of the runtime: `double`, never `length`
  std::string unit;
};

/// One input of a component, or one parameter.
struct ComponentInput {
  std::string name;
  std::string type;     ///< as its author wrote it
  std::string unit;     ///< as said beside the type
  ValueType value;      ///< what that means
  std::string initial;  ///< its default; empty: has to be given
  std::string low;      ///< of its range; empty: none
  std::string high;
  std::string help;
  bool is_list = false;
  text::Place declaration;  ///< its name there; no source: it was compiled in
};

/// What can be called: a procedure, an assemblage or a binding point. Wherever it was declared, this is all
/// that completion, hovering and checking of calls need of it.
struct Component {
  std::string name;
  std::string kind;  ///< `procedure`, `assemblage`, `binding`
  std::string help;
  std::vector<ComponentInput> inputs;
  ValueType output;  ///< empty: gives nothing, or nobody knows
  bool is_sink = false;
  bool is_own = false;      ///< declared in the project, not in the library
  std::string source;       ///< of its formula
  std::string file;         ///< where it was declared, for people
  text::Place declaration;  ///< its name there; no source: it was compiled in
};

Component component_of(const flow::Behavior& behavior);
Component component_of(const cnl::Procedure& procedure);
/// What its inputs and its value are depends on each other; what is sure is said.
Component component_of(const cdl::Function& function, const flow::Library& library);

const ComponentInput* find_input(const Component& component, std::string_view name);

/// The first sentence of a help text.
std::string first_sentence(std::string_view help);
/// ` [s]`; empty for a plain number.
std::string bracketed(std::string_view unit);
/// `double [s]`
std::string shown_type(const ValueType& type);
/// `persistence: double [s] = 6 in 0 .. 100`
std::string shown_input(const ComponentInput& input);
/// `Noise(persistence: double [s] = 6) -> Vector`
std::string shown_signature(const Component& component);
/// The whole as markdown: signature, help, a table of the inputs, source.
std::string markdown_of(const Component& component);
/// One input as markdown.
std::string markdown_of(const ComponentInput& input);

/// What a type's name means: `length` is a `double` in m. Unknown names stay as they are.
ValueType value_type(std::string_view type, std::string_view unit);
ValueType value_type(const cdl::PortType& type);
/// Whether a value of the one type may stand where the other is expected. Unknown types fit everything.
bool fits(const ValueType& have, const ValueType& want);
/// The words of a type (`Column`, `Flag`, `true`); empty for types of numbers and for unknown ones.
std::vector<std::string> words_of(std::string_view type);
/// All units that measure the same as this one; empty for a plain number.
std::vector<std::string> units_like(std::string_view unit);

}  // namespace mlab::assist
