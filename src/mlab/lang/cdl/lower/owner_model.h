#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/cdl/lower/elaboration.h"
#include "mlab/lang/cdl/syntax/tree.h"
#include "mlab/lang/cdl/types/port_type.h"

namespace mlab::cdl {

/// What an input of a node is in the text.
enum class InputRole {
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
  kValue,     ///< of a `let` that is a constant or another name
  kFormula,   ///< the words of a formula
  kTerm       ///< what a formula reads from other nodes
};

/// One input of a node, driven or not.
struct ModelInput {
  std::string port;
  std::optional<std::uint32_t> index;  ///< of a list
  InputRole role = InputRole::kArgument;
  ExpressionPtr written;   ///< null: nothing stands there
  int from = -1;           ///< node of the page that drives it
  bool is_inline = false;  ///< that node is written right here
  int at = -1;             ///< of the arguments, members, operands, cases
  int item = -1;           ///< of the list that is written there; -1: it is no list
  bool is_open = false;    ///< takes one more of a list
};

/// What stands on a page.
struct ModelNode {
  enum class Kind {
    kCall,
    kCooperate,
    kCompete,
    kCoordinate,
    kFuse,
    kSequence,
    kSelect,
    kLogic,
    kFormula,  ///< arithmetic, with functions in it, that reads other nodes
    kDelay,
    kValue,      ///< a `let` that is a constant or another name
    kParameter,  ///< of the owner
    kOuter,      ///< a `let` of the owner, seen from inside of one of its states
    kActuator
  };
  Kind kind = Kind::kCall;
  std::string name;                        ///< on the page, unique
  std::string path;                        ///< of its value in the owner, below it; empty: the owner's own
  const Expression* expression = nullptr;  ///< null for parameters, outer nodes, actuators
  const Let* let = nullptr;                ///< whose value it is
  const Parameter* parameter = nullptr;
  const Drive* drive = nullptr;
  int reader = -1;  ///< node in which it is written; -1: in a `let`, a drive, or as the page's result
  int reader_input = -1;
  int inner = -1;  ///< page of its states
  std::vector<ModelInput> inputs;
};

/// One level of an assemblage or a robot: a dataflow, or the states of a sequence.
struct ModelPage {
  std::string path;  ///< `Forage.Searching`
  std::string base;  ///< the same without the owner: where its nodes are found below the owner's
  int parent = -1;
  const Expression* root = nullptr;    ///< what the page gives; null: nothing, or drives
  const Sequence* sequence = nullptr;  ///< of a page of states
  const State* state = nullptr;        ///< whose member the page shows
  const Transition* asks = nullptr;    ///< whose trigger the page shows
  std::vector<int> states;             ///< pages of the sequence's states, in their order
  std::vector<ModelNode> nodes;
  int result = -1;  ///< the node that gives the page's value

  int find(std::string_view name) const;
};

/// All levels of an assemblage or robot. Points into the tree and the elaboration, which must outlive it.
struct OwnerModel {
  std::string name;
  const Assemblage* assemblage = nullptr;  ///< either this
  const Robot* robot = nullptr;            ///< or this
  const Elaboration* elaboration = nullptr;
  std::vector<ModelPage> pages;  ///< the first is the owner's own
  /// What is not drawn, triggers of transitions above all: where its values are, as `ModelNode::path`.
  std::map<const Expression*, std::string> hidden;

  const std::vector<Let>& lets() const;
  const std::vector<Parameter>& parameters() const;
  /// -1 where there is none.
  int find_page(std::string_view path) const;
  /// What a node gives; without a type where it can't be told, or it gives nothing.
  PortType type_of(const ModelNode& node) const;
  /// What an expression of the owner gives; without a type where it is a number by itself.
  PortType type_of(const Expression& expression) const;
};

/// @param shown  names of `let`s that the layout of an inner page has, by the page's path: they are shown
///               there though nothing there reads them
OwnerModel model_of(const Assemblage& assemblage, const Elaboration& elaboration,
                    const std::multimap<std::string, std::string>& shown = {});
OwnerModel model_of(const Robot& robot, const Elaboration& elaboration,
                    const std::multimap<std::string, std::string>& shown = {});

/// What a transition asks, as the last page of a model of its own: triggers are not drawn where their states
/// are. The pages before it mean nothing.
/// @param states  page of the owner with the states
/// @param path    of the new page
OwnerModel trigger_model(const OwnerModel& owner, const ModelPage& states, const Transition& transition,
                         const std::string& path);

/// How often the name of a `let` or parameter is used inside of its owner.
int count_uses(const OwnerModel& model, std::string_view name);
/// All names that something of the owner uses.
std::set<std::string, std::less<>> names_used(const OwnerModel& model);

}  // namespace mlab::cdl
