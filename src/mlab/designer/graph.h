#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/designer/components.h"
#include "mlab/lang/cdl/tree.h"

namespace mlab::designer {

/// What an input of a node is in the text.
enum class Role {
  kArgument,  ///< of a call, or of an operator's call
  kMember,    ///< of an operator
  kWeight,    ///< in front of a member's colon
  kOperand,   ///< of `not`, `and`, `or`
  kDelayed,   ///< what a delay delays
  kInitial,   ///< and what it gives first
  kSelector,  ///< behind `select by`
  kCase,      ///< of a selection
  kActive,    ///< the part that moves a sensor
  kDrive,     ///< what an actuator of a robot is driven by
  kValue      ///< of a `let` that is a constant or another name
};

/// One input of a node, driven or not.
struct GraphInput {
  std::string port;
  std::optional<std::uint32_t> index;  ///< of a list
  Role role = Role::kArgument;
  cdl::ExpressionPtr written;  ///< null: nothing stands there
  int from = -1;               ///< node of the page that drives it
  bool is_inline = false;      ///< that node is written right here
  int at = -1;                 ///< of the arguments, members, operands, cases
  int item = -1;               ///< of the list that is written there; -1: it is no list
  bool is_open = false;        ///< takes one more of a list
};

/// What stands on a page.
struct GraphNode {
  enum class Kind {
    kCall,
    kCooperate,
    kCompete,
    kCoordinate,
    kFuse,
    kSequence,
    kSelect,
    kLogic,
    kDelay,
    kValue,      ///< a `let` that is a constant or another name
    kParameter,  ///< of the owner
    kOuter,      ///< a `let` of the owner, seen from inside of one of its states
    kActuator
  };
  Kind kind = Kind::kCall;
  std::string name;  ///< on the page, unique
  std::string path;  ///< of its value in the owner, as lowering names it; empty: the owner's own
  const cdl::Expression* expression = nullptr;  ///< null for parameters, outer nodes, actuators
  const cdl::Let* let = nullptr;                ///< whose value it is
  const cdl::Parameter* parameter = nullptr;
  const cdl::Drive* drive = nullptr;
  int reader = -1;  ///< node in which it is written; -1: in a `let`, a drive, or as the page's result
  int reader_input = -1;
  int inner = -1;  ///< page of its states
  std::vector<GraphInput> inputs;
};

/// One level of an assemblage or a robot: a dataflow, or the states of a sequence.
struct GraphPage {
  std::string path;  ///< `Forage.Searching`
  std::string base;  ///< the same without the owner: where its nodes are found below the owner's
  int parent = -1;
  const cdl::Expression* root = nullptr;    ///< what the page gives; null: nothing, or drives
  const cdl::Sequence* sequence = nullptr;  ///< of a page of states
  const cdl::State* state = nullptr;        ///< whose member the page shows
  std::vector<int> states;                  ///< pages of the sequence's states, in their order
  std::vector<GraphNode> nodes;
  int result = -1;  ///< the node that gives the page's value

  int find(std::string_view name) const;
};

/// All levels of an assemblage or robot. Points into the tree.
struct OwnerGraph {
  std::string name;
  const cdl::Assemblage* assemblage = nullptr;
  const cdl::Robot* robot = nullptr;
  Components::Scope scope;
  std::vector<GraphPage> pages;  ///< the first is the owner's own
  /// What is not drawn, triggers of transitions above all: where its values are, as `GraphNode::path`.
  std::map<const cdl::Expression*, std::string> hidden;

  const std::vector<cdl::Let>& lets() const { return *scope.lets; }
  const std::vector<cdl::Parameter>& parameters() const { return *scope.parameters; }
  /// -1 where there is none.
  int find_page(std::string_view path) const;
};

/// @param shown  names of `let`s that the layout of an inner page has, by the page's path: they are shown
/// there though
///               nothing there reads them
OwnerGraph graph_of(const cdl::Assemblage& assemblage, const Components& components,
                    const std::multimap<std::string, std::string>& shown = {});
OwnerGraph graph_of(const cdl::Robot& robot, const Components& components,
                    const std::multimap<std::string, std::string>& shown = {});

/// What of a trigger is computed: a `not` around it is part of the transition, as lowering has it.
const cdl::Expression& condition_of(const cdl::Expression& trigger);
/// What a node is called that nobody gave a name: `Noise`, `cooperate`.
std::string default_name(const cdl::Expression& expression);
/// How often the name of a `let` or parameter is used inside of its owner.
int count_uses(const OwnerGraph& graph, std::string_view name);
/// All names that something of the owner uses.
std::set<std::string, std::less<>> names_used(const OwnerGraph& graph);

}  // namespace mlab::designer
