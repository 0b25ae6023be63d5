#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/designer.pb.h"
#include "mlab/designer/graph.h"
#include "mlab/designer/workspace.h"

namespace mlab::designer {

/// One page of a workspace's text as it stands.
struct PageView {
  const OwnerGraph* graph = nullptr;
  const GraphPage* page = nullptr;

  const GraphNode& node(int at) const { return page->nodes[static_cast<std::size_t>(at)]; }
  const std::vector<cdl::Let>& lets() const { return graph->lets(); }
};

/// An input that a change speaks of: of a node, or what the page gives.
struct Spot {
  PageView view;
  int node = -1;  ///< -1: what the page gives
  int input = -1;
  std::string drive;  ///< an actuator that nothing drives yet

  bool is_result() const { return node < 0 && drive.empty(); }
  const GraphInput* at() const {
    return node < 0 ? nullptr : &view.node(node).inputs[static_cast<std::size_t>(input)];
  }
};

/// Does the changes of an Edit to a workspace. The methods stand in edit_*.cc by what they change.
class Editor {
 public:
  explicit Editor(Workspace& work) : work_(work) {}
  Done apply(const Change& change);

 private:
  // ---- edit_find.cc: what the names of a change stand for
  text::Result<PageView> page(const std::string& path) const;
  text::Result<int> node(const PageView& view, const std::string& name) const;
  /// @param for_new  an open place of a list is meant where no index is said
  text::Result<Spot> spot(const PageView& view, const std::string& node, const std::string& port,
                          std::optional<std::uint32_t> index, bool for_new) const;
  /// The expression that stands there; null: nothing.
  const cdl::Expression* written(const Spot& spot) const;
  /// The node that drives it and is written there; -1: none.
  int inline_node(const Spot& spot) const;
  cdl::PortType wanted(const Spot& spot) const;
  cdl::PortType given(const PageView& view, int node) const;
  std::string free_name(const PageView& view, const std::string& wanted) const;
  bool is_taken(const PageView& view, std::string_view name) const;
  /// Whether a value of `to` goes, directly or not, into `from` without a delay: a wire from `from` to `to`
  /// would close a loop.
  bool reaches(const PageView& view, int from, int to) const;

  // ---- edit_wires.cc: primitives and wires
  /// The words of an expression without its `as`.
  Fragment value(const cdl::Expression& expression) const;
  /// The same with a name, where it needs one.
  Fragment value_as(const cdl::Expression& expression, const std::string& name) const;
  /// From the first to the last of its words, parentheses around it included where they are only its own.
  text::Span outer(const cdl::Expression& expression) const;
  /// What stands at the spot afterwards. What stood there before is lost, unless it is a node: then it gets a
  /// `let`.
  Done write(const Spot& spot, const Fragment& what);
  Done write_argument(const Spot& spot, const Fragment& what);
  Done write_new(const Spot& spot, const Fragment& what);
  Done clear(const Spot& spot);
  void clear_argument(const Spot& spot);
  void clear_operand(const Spot& spot);
  void clear_member(const Spot& spot);
  /// A `let` for the node that is written at a spot, with its help. Splices only.
  std::string save_inline(const Spot& spot);
  std::string add_let(const PageView& view, const std::string& name, const Fragment& value,
                      const std::string& help = "");
  void erase_let(const cdl::Let& let);
  /// Whether a block or a big call may stand there.
  bool takes(const Spot& spot, const cdl::Expression& expression) const;
  std::string neutral(const cdl::PortType& type) const;

  Done connect(const Connect& change);
  Done disconnect(const Disconnect& change);
  Done set_value(const SetValue& change);
  Done place(const Place& change);
  Done remove(const Remove& change);
  Done remove_node(const std::string& page, int handle, const std::vector<int>& others);
  Done set_active(const SetActive& change);
  Done replace(const Replace& change);
  Done expose(const Expose& change);
  int follow(const PageView& view, int node);
  /// Where it is now: its page and its place there.
  std::optional<std::pair<PageView, int>> followed(const std::string& owner, int handle) const;

  // ---- edit_names.cc
  Done rename(const Rename& change);
  Done rename_declaration(const std::string& from, const std::string& to);
  Done rename_local(const PageView& view, const std::string& from, const std::string& to);
  Done rename_state(const PageView& view, const std::string& from, const std::string& to);
  Done arrange(const Arrange& change);
  Done set_note(const SetNote& change);
  Done set_help(const SetHelp& change);
  void write_help(std::uint32_t statement, const std::string& help);
  Done set_layout(const std::string& page, const std::vector<std::pair<std::string, std::string>>& entries);

  // ---- edit_declarations.cc
  Done add_declaration(const AddDeclaration& change);
  Done add_text(const std::string& text);
  Done set_parameter(const SetParameter& change);
  Done remove_parameter(const RemoveParameter& change);
  Done copy_component(const CopyComponent& change);
  Done remove_declarations(const Remove& change);
  /// The parameters of a declaration, and the name behind which they stand.
  const std::vector<cdl::Parameter>* parameters(std::string_view owner, text::Span& name) const;

  // ---- edit_states.cc
  text::Result<const cdl::Sequence*> sequence(const std::string& page) const;
  Done add_state(const AddState& change);
  Done set_state(const SetState& change);
  Done add_transition(const AddTransition& change);
  Done set_transition(const SetTransition& change);
  Done remove_transition(const RemoveTransition& change);
  Done remove_states(const PageView& view, const Remove& change);

  // ---- edit_robots.cc
  Done set_class(const SetClass& change);
  Done use_device(const UseDevice& change);
  Done set_member(const SetMember& change);
  Done set_coordinator(const cdl::SocietyMember& caste, const std::string& by);
  Done remove_member(const RemoveMember& change);

  // ---- edit_groups.cc
  /// A node that is followed, and where it stood [px].
  struct Stood {
    int handle = -1;
    double x = 0.0;
    double y = 0.0;
  };
  Done group(const Group& change);
  std::vector<Stood> places(const PageView& view, const std::string& page, const std::set<int>& nodes);
  Done arrange_group(const Group& change, const std::vector<Stood>& stood);
  Done ungroup(const Ungroup& change);

  // ---- edit_clipboard.cc
  Done paste(const Paste& change);

  Workspace& work_;
};

/// Whether a text can stand as a value: it is one expression and nothing behind it.
bool is_expression(std::string_view text);
bool is_cdl_name(std::string_view text);
/// A type as a parameter's is written: `length`, `double [kg]`.
std::string type_words(const cdl::PortType& type);

}  // namespace mlab::designer
