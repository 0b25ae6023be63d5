#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/node_names.h"
#include "mlab/lang/cdl/types/types.h"

namespace mlab::cdl {

/// Calls in calls, `let`s in `let`s: so deep in all.
inline constexpr int kDeepestExpression = 500;

/// Gives nodes their names: the one place that does. Walks in the order in which things are evaluated first,
/// for what comes later yields where a name is taken (`Noise`, `Noise_2`). To be used once.
class Naming {
 public:
  Naming(const Configuration& configuration, const Types& types)
      : configuration_(configuration), types_(types) {}

  /// @param defaults  parameters that nobody gives
  /// @param taken     what stands below the owner already
  NodeNames of(const Assemblage& assemblage, const std::vector<const Parameter*>& defaults,
               const NamesBelow& taken);
  /// Of the call that serves a binding point: its arguments.
  NodeNames of(const Device& device, const NamesBelow& taken);
  /// @param actuators  that its drives speak of, in their order; null: none
  NodeNames of(const Robot& robot, const std::vector<const Device*>& actuators);

 private:
  // Where a node goes: what it stands in, and its name there.
  struct Slot {
    std::string prefix;
    std::string name;         // empty: called as what it is
    bool is_claimed = false;  // `prefix` is the whole path, and nobody else has it
  };
  using Level = std::map<std::string, int, std::less<>>;  // how many asked for each name

  void take(const NamesBelow& taken);
  std::string claim(const std::string& prefix, const std::string& name);
  std::string claim(const Slot& slot, std::string_view fallback);
  NamesBelow names_below(const std::string& path) const;
  void record(const Expression& expression, NodeNames::Paths paths);
  NodeNames::Paths& recorded(const Expression& expression);
  void record_behind(const Expression& expression, std::string path);

  void walk(const ExpressionPtr& expression, const Slot& slot);
  void walk_what(const Expression& expression, const Slot& slot, const std::string* active);
  void walk_parts(const Expression& expression, const std::string& path);
  void walk_call(const Expression& expression, const Call& call, const std::string& path);
  void walk_arguments(const Call& call, const std::string& path);
  void walk_members(const std::vector<Member>& members, const char* weight, const std::string& path);
  void walk_compete(const Compete& compete, const std::string& path);
  void walk_logic(const Logic& logic, const std::string& path);
  void walk_arithmetic(const Expression& expression, const Arithmetic& arithmetic, const std::string& path);
  void walk_operands(const std::vector<ExpressionPtr>& operands, const std::string& path);
  void name_angles(const Expression& expression, const std::vector<ExpressionPtr>& operands,
                   const std::string& path);
  void walk_states(const Sequence& sequence, const std::string& path);
  void walk_select(const Select& select, const std::string& path);
  void walk_name(const Name& name);
  void open_lets(const std::vector<Let>& lets);
  void walk_let(const Let& let);
  void walk_robot_parameter(const Parameter& parameter);
  void walk_class(const Robot& robot);

  PortType type_of(const Expression& expression) const;
  bool is_movement(const Expression& expression) const;
  bool gives_nothing(const Expression& expression, const std::vector<Let>& lets, int depth) const;

  const Configuration& configuration_;
  const Types& types_;
  NodeNames out_;
  std::map<std::string, Level, std::less<>> levels_;  // by what they stand below
  const std::vector<Parameter>* parameters_ = nullptr;
  const std::vector<Let>* lets_ = nullptr;  // null: none can be read here
  std::unordered_map<std::string_view, const Let*> let_named_;
  std::unordered_set<const Let*> walked_;
  int depth_ = 0;
};

/// Whether somebody who calls it gives a value for each parameter.
std::vector<bool> given_parameters(const Call& call, const std::vector<Parameter>& parameters);

}  // namespace mlab::cdl
