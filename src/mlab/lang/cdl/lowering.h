#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"
#include "mlab/lang/cdl/body.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/elaboration.h"
#include "mlab/lang/cdl/lower.h"
#include "mlab/lang/cdl/node_names.h"
#include "mlab/lang/cdl/port_type.h"
#include "mlab/lang/cdl/tests.h"
#include "mlab/lang/cdl/types.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// ` [m/s]`; nothing for no unit.
std::string bracketed(const std::string& unit);

/// What an expression stands for.
struct Value {
  enum class Kind {
    kNone,    ///< it was wrong, and that was said
    kWire,    ///< the output of a node, or a parameter of the network
    kNumber,  ///< with `unit`
    kWord,    ///< a word of the type that is wanted
    kText,
    kList,
    kSink  ///< a node without an output
  };
  Kind kind = Kind::kNone;
  std::string text;  ///< name of the node or parameter, word, text
  double number = 0.0;
  std::string unit;  ///< kNumber: as written
  PortType type;     ///< kWire; a constant that came through a parameter has the parameter's
  /// kWire: the unit in which the network counts it; what came through a declaration has that one's in
  /// `type`.
  std::string counted_in;
  std::string named;     ///< the name by which it was asked for; empty: none
  text::Place declared;  ///< of that name
  std::vector<Value> items;
  text::Place place;                    ///< where the author wrote it: for a constant, where it was given
  const struct Scope* scope = nullptr;  ///< kWord: where it was looked up in vain
};

/// A number with its unit, as it is quoted in messages.
std::string quoted_number(const Value& value);

/// Where a node goes.
struct Spot {
  std::string path;
  const NamesBelow* taken;  ///< what stands right below it already
};

/// Of what is only checked: nobody asks what its nodes are called.
inline const NodeNames kUnnamed;

/// The names that expressions of one instance may use.
struct Scope {
  struct Named {
    Value value;
    const Parameter* parameter = nullptr;
    const Let* let = nullptr;
    enum class State { kReady, kWaiting, kOpen } state = State::kReady;
    bool was_promised = false;  ///< somebody took its wire before it was there
  };
  std::string path;                  ///< where the instance runs
  const NodeNames* nodes = nullptr;  ///< what its nodes are called below that
  std::map<std::string, Named, std::less<>> names;
  std::map<const Expression*, std::size_t> times;  ///< how often it was evaluated what is so repeatedly
};

/// One flattening of a configuration to the network of a robot. The methods stand in lower_*.cc by construct.
class Lowering {
 public:
  Lowering(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink,
           Said& said)
      : configuration_(configuration),
        library_(library),
        elaboration_(configuration, library),
        types_(elaboration_.types()),
        sink_(sink),
        said_(said) {}

  LoweredRobot robot(const Robot& robot);
  /// Checks an assemblage by itself: its parameters have values of their type, or their defaults.
  void check_assemblage(const Assemblage& assemblage);
  /// Checks devices and body of a class by themselves.
  void check_class(const RobotClass& robot_class);
  void check_operator(const SocietyOperator& op);
  LoweredTest test(const Test& test);

 private:
  using Link = flow::Link;

  // lower_expression.cc
  Value lower(const Expression& expression, Scope& scope);
  Value lower_what(const Expression& expression, Scope& scope, const std::string& inside);
  Value lower_name(const Name& name, Scope& scope, const text::Place& place);
  Value lower_let(Scope::Named& named, Scope& scope);
  Value lower_list(const List& list, Scope& scope, const text::Place& place);
  Value lower_logic(const Logic& logic, Scope& scope, const std::string& path, const text::Place& place);
  Value lower_arithmetic(const Expression& expression, const Arithmetic& arithmetic, Scope& scope,
                         const std::string& path, const text::Place& place);
  Value lower_delay(const Delay& delay, Scope& scope, const std::string& path, const text::Place& place);
  Value lower_active(const Expression& expression, Scope& scope, const NodeNames::Paths& paths);
  Types::Names types_in(const Scope& scope) const;

  // lower_arithmetic.cc
  /// What is computed of values, and where the author wrote them.
  struct Operand {
    Value value;
    PortType type;
    text::Place place;
    std::string angle;  ///< node that counts it in radians
  };
  /// @param of     the sign or function that takes it
  /// @param angle  of the node that counts it in radians, if that is needed
  std::optional<Operand> operand(const Expression& expression, std::string_view of, std::string angle,
                                 Scope& scope);
  static void settle_lists(std::vector<Operand>& operands);
  Value compute(const Computation& how, const std::vector<Operand>& operands, const std::string& path,
                const text::Place& place);
  Value fold(const Computation& how, const std::vector<Operand>& operands, const text::Place& place);
  Value in_radians(Value value, const std::string& path, const std::string& angle, const text::Place& place);
  void link_operand(const Operand& operand, const flow::Input& input, flow::Node& node);
  void refuse(const Computation& how, const std::vector<Operand>& operands, const text::Place& place);
  Value call_function(const Expression& expression, const Call& call, const Function& function, Scope& scope,
                      const Spot& spot, const text::Place& place);
  /// The position of a named place: a parameter of the network that the mission sets.
  Value call_place(const Call& call, Scope& scope, const text::Place& place);
  /// What the parameter of a named place is called that has none yet.
  std::string place_parameter(std::string_view place);
  /// The name of the place, where the expression is `place("Gate")`; null: it is something else, or wrong.
  const std::string* named_place(const Expression& expression) const;

  // lower_call.cc
  Value lower_call(const Call& call, Scope& scope, const Spot& spot, const text::Place& place);
  Value call_binding(const Call& call, const Binding& binding, Scope& scope, const Spot& spot,
                     const text::Place& place);
  /// An argument with the scope that it is to be read in.
  struct Given {
    Word name;  ///< empty: by position
    ExpressionPtr value;
    Scope* scope = nullptr;
    std::optional<Value> ready = std::nullopt;  ///< instead of `value`
    text::Place place = {};
  };
  Value serve(const DeviceUse& use, std::vector<Given> asked, const Spot& spot, const text::Place& place);
  /// What a device's arguments are read in: its class's names, where the device runs.
  Scope& device_scope(const DeviceUse& use, const Spot& spot);
  const DeviceUse* device_serving(const Word& binding);
  Value instantiate(const Word& callee, const std::vector<Given>& given, const Spot& spot,
                    const text::Place& place);
  Value instantiate_procedure(const Word& callee, const flow::Library::Entry& entry,
                              const std::vector<Given>& given, const std::string& path,
                              const text::Place& place);
  Value instantiate_assemblage(const Word& callee, const Assemblage& assemblage,
                               const std::vector<Given>& given, const Spot& spot, const text::Place& place);
  Value lower_assemblage(const Assemblage& assemblage, Scope& scope, const text::Place& place);
  Value stand_still(const Assemblage& assemblage, Scope& scope, const PortType& result,
                    const text::Place& place);
  Value default_of(const Parameter& parameter, Scope& scope);
  Value value_of(const Given& given);
  void link_argument(const InputView& view, const Given& given, flow::Node& node);
  std::vector<Given> given_by(const Call& call, Scope& scope) const;
  /// Per argument the index of what it is for; -1 where that is wrong, which was said.
  std::vector<int> match(const Word& callee, const std::vector<Given>& given,
                         const std::vector<std::string>& names, const Assemblage* assemblage = nullptr);
  void say_missing(const Word& callee, const std::string& name, const PortType& type,
                   const std::string& help);
  Value unknown_callee(const Word& callee);
  bool enter_assemblage(const Assemblage& assemblage, const Word& callee);

  // lower_operators.cc
  Value lower_cooperate(const Cooperate& what, Scope& scope, const std::string& path,
                        const text::Place& place);
  Value lower_compete(const Compete& what, Scope& scope, const std::string& path, const text::Place& place);
  Value lower_generic(const Call& by, const std::vector<Member>& members, Scope& scope,
                      const std::string& path, const text::Place& place);
  Value lower_sequence(const Sequence& what, Scope& scope, const std::string& path, const text::Place& place);
  flow::State lower_state(const State& state, Scope& scope, Value& member);
  Value lower_select(const Select& what, Scope& scope, const std::string& path, const text::Place& place);
  std::optional<std::int64_t> case_value(const Word& word, const flow::TypeInfo& type);
  bool check_members(const std::vector<Member>& members, const char* what, const text::Place& place);
  /// The type that members of a sequence or select have in common.
  PortType common_type(const std::vector<Value>& members, const text::Place& place, const char* what);

  // lower_bind.cc
  /// What is linked to an input of the type; nothing where the value is none of it, which is said at `place`.
  std::optional<flow::Source> bind(const Value& value, const PortType& type, const flow::Input* input,
                                   const std::string& name, const text::Place& place);
  std::optional<flow::Source> bind_number(const Value& value, const PortType& type, const flow::Input* input,
                                          const std::string& name, const text::Place& place);
  std::optional<flow::Source> bind_word(const Value& value, const PortType& type, const std::string& name,
                                        const text::Place& place);
  std::optional<flow::Source> bind_coordinates(const Value& value, const PortType& type,
                                               const std::string& name, const text::Place& place);
  /// A wire that its declaration gives a unit is a value in it from there on.
  static void declare_unit(Value& value, const PortType& declared);
  /// False where the unit that is declared for a wire is an angle's, which its number would have to be
  /// converted from, and nobody can: the network knows no unit of it.
  bool is_convertible(const Value& value, const PortType& want, const std::string& name,
                      const text::Place& place);
  bool fits(const PortType& have, const PortType& want, const std::string& name, const text::Place& place,
            const Value* about = nullptr);
  /// A value for a parameter: checked against the declaration, and with its type.
  Value pass(const Value& value, const Parameter& parameter, const PortType& type, const text::Place& place);
  bool check_range(const Value& value, const Parameter& parameter, const PortType& type);
  PortType type_of(const Parameter& parameter);
  PortType type_named(const Word& name);

  // lower_robot.cc
  Scope& declare_class(const RobotClass& robot_class, Scope& own);
  void declare_network_parameter(const Parameter& parameter, Scope& scope);
  void find_devices(const Robot& robot, Scope& own, LoweredRobot& out);
  void choose_devices(const Robot& robot);
  void lower_drive(const Drive& drive, Scope& scope);
  void drive_device(const DeviceUse& use, const Value& value, const std::string& path,
                    const text::Place& place);
  const DeviceUse* actuator_of(const Drive& drive);
  void lower_body(const RobotClass& robot_class, Scope& scope, LoweredRobot& out);
  std::optional<double> body_number(const BodySetting& setting, const BodyProperty& property,
                                    const Value& value);
  void check_device(const Device& device);
  void declare_lets(const std::vector<Let>& lets, Scope& scope);
  void declare_typed(const std::vector<Parameter>& parameters, Scope& scope);

  // lower_tests.cc
  /// @param around  of the test: what it computes is not sensed
  void lower_percept(const TestStep& step, const Scope& around, LoweredStep& out);
  /// Says why a test can't say that something is sensed so. True: it can.
  bool may_be_sensed(const Given& given, const TestInput& input, const Scope& around,
                     const LoweredStep& step);
  void lower_percept_value(const Given& given, const TestInput& input, LoweredStep& out);
  void lower_condition(const TestStep& step, Scope& scope, LoweredStep& out);
  void lower_fact(const TestStep& step, LoweredStep& out);
  std::uint32_t cycles_of(const TestStep& step);
  /// These nodes are evaluated though nobody reads them; and notes all states that there are.
  void keep_awake(const std::set<std::string>& nodes);
  void check_places(const LoweredTest& test);

  // lowering.cc
  /// Says it once: an assemblage that is used twice is wrong once. A name that is unknown in several places
  /// of one declaration is one slip.
  text::Diagnostic& error(std::string kind, const text::Place& place, std::string message);
  text::Diagnostic& warning(std::string kind, const text::Place& place, std::string message);
  text::Diagnostic& report(text::Severity severity, std::string kind, const text::Place& place,
                           std::string message, const std::string& about = {});
  std::string key_of(const std::string& kind, const text::Place& place, const std::string& message,
                     const std::string& about) const;
  void hint_nearest(text::Diagnostic& d, std::string_view name,
                    const std::vector<std::string>& candidates) const;
  /// What the nodes of an expression are called that is evaluated now.
  const NodeNames::Paths& paths_of(const Expression& expression, Scope& scope) const;
  /// As above, of an expression that was asked for already.
  const NodeNames::Paths& last_paths_of(const Expression& expression, const Scope& scope) const;
  /// The node that counts in radians what an expression computes, and what its operand is.
  std::string angle_of(const Expression& expression, const Scope& scope) const;
  std::string angle_of_operand(const Expression& expression, std::size_t operand, const Scope& scope) const;
  /// The node between an expression that was evaluated and who reads it.
  std::string path_behind(const Expression& expression, const Scope& scope) const;
  Value wire(const std::string& node, const PortType& type, const text::Place& place) const;
  Scope& new_scope();

  const Configuration& configuration_;
  const flow::Library& library_;
  const Elaboration elaboration_;
  const Types& types_;
  text::Diagnostics& sink_;
  flow::Network network_;
  std::deque<Scope> scopes_;
  std::unordered_map<std::string, std::string> places_;  // parameters of named places
  std::unordered_map<std::string, int> place_stems_;     // how many places asked for a parameter's name
  std::unordered_set<std::string> place_names_;          // of those parameters
  std::vector<const Assemblage*> open_;                  // assemblages that are being instantiated
  std::vector<DeviceUse> devices_;
  Scope* class_scope_ = nullptr;  // names of the robot's class; null: there are none
  std::set<const Device*> driven_;
  Word robot_name_;
  const NamesBelow* robot_names_ = nullptr;  // of all that stands in the robot itself; null: there is none
  std::string class_name_;
  text::Place class_place_;
  bool class_is_broken_ = false;  // it was said; what it would offer is unknown
  bool is_checking_ = false;      // nobody runs it: binding points are taken as they are declared
  std::map<std::string, std::vector<std::string>, std::less<>> tested_states_;  // their paths, by name
  int depth_ = 0;
  Said& said_;
  text::Diagnostic muted_;              // takes what is said of something that was said before
  const Assemblage* inside_ = nullptr;  // whose names are being read; null: the robot's
};

}  // namespace mlab::cdl
