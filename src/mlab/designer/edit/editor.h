#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/designer.pb.h"
#include "mlab/designer/drawing/graph.h"
#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/edit/change/layout.h"
#include "mlab/designer/edit/find/declared.h"
#include "mlab/designer/edit/find/devices.h"
#include "mlab/designer/edit/find/followed.h"
#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/find/sequences.h"
#include "mlab/designer/edit/page_writer.h"
#include "mlab/designer/edit/workspace.h"

namespace mlab::designer {

/// Does the changes of an Edit to a workspace. The methods stand in edit_*.cc by what they change.
class Editor {
 public:
  explicit Editor(Workspace& work) : work_(work), pages_(work) {}
  Done apply(const Change& change);

 private:
  // ---- edit_connect.cc
  Done connect(const Connect& change);
  Done connect_let(const PageView& view, int from, const Spot& to);
  Done disconnect(const Disconnect& change);
  Done set_value(const SetValue& change);
  Done place(const Place& change);
  Done place_sink(const PageView& view, const Place& change);
  Done remove(const Remove& change);
  Done remove_node(const std::string& page, int handle, const std::vector<int>& others);
  Done set_active(const SetActive& change);
  Done replace(const Replace& change);
  Done replace_operator(const PageView& view, int at, const cdl::Expression& other);
  Done replace_call(const std::string& owner, int handle, const Callable& other);
  Done expose(const Expose& change);

  // ---- edit_declarations.cc
  Done add_declaration(const AddDeclaration& change);
  Done set_parameter(const SetParameter& change);
  text::Result<cdl::Parameter> parameter_of(const SetParameter& change) const;
  void change_parameter(const cdl::Parameter& old, const cdl::Parameter& said, bool stays);
  Done remove_parameter(const RemoveParameter& change);
  Done copy_component(const CopyComponent& change);
  Done remove_declarations(const Remove& change);
  /// Of an assemblage, a robot, a class; null: there is none.
  const std::vector<cdl::Parameter>* parameters(std::string_view owner) const;
  void visit_owner(std::string_view name, const auto& visit) const;

  // ---- edit_triggers.cc
  Done change_trigger(const ChangeTrigger& change);
  text::Result<cdl::ExpressionPtr> condition(const std::string& component) const;
  cdl::ExpressionPtr chosen(const cdl::Expression& old, const Callable& component,
                            const OwnerGraph& graph) const;
  Done place_in_trigger(const PageView& view, const Place& change);

  // ---- edit_robots.cc
  Done set_class(const SetClass& change);
  Done use_device(const UseDevice& change);

  // ---- edit_devices.cc
  text::Result<const cdl::Binding*> binding(const std::string& name) const;
  /// A component that can serve the binding point.
  text::Result<Callable> server(const std::string& component, const cdl::Binding& binding) const;
  std::string free_device_name(const Equipped& owner, const std::string& binding) const;
  Done set_device(const SetDevice& change);
  Done add_device(const Equipped& owner, const SetDevice& change);
  void drop_choices(const std::string& robot_class, const std::string& device);
  Done remove_devices(const Remove& change);
  Done set_equipment_value(const SetValue& change);
  bool name_arguments(const cdl::Call& call, const Callable& component, const cdl::Argument* gone);
  Done set_body(const SetValue& change);
  Done expose_equipment(const Expose& change);
  text::Result<SetParameter> exposed(const Expose& change, const cdl::RobotClass& robot_class) const;
  std::string text_of(const cdl::Expression& expression) const;
  Done connect_device(const Connect& change);
  Done place_device(const Place& change);
  std::string point_for(const Equipped& owner, const Callable& by) const;
  Done set_binding(const SetBinding& change);
  Done add_class_for(const std::string& name, const std::string& robot_name);

  // ---- edit_groups.cc
  /// A node that is followed, and where it stood [px].
  struct NodePosition {
    int handle = -1;
    double x = 0.0;
    double y = 0.0;
  };
  Done group(const Group& change);
  text::Result<int> output_of(const PageView& view, const std::set<int>& chosen) const;
  std::vector<NodePosition> places(const PageView& view, const std::string& page, const std::set<int>& nodes);
  Done arrange_group(const Group& change, const std::vector<NodePosition>& stood);
  Done ungroup(const Ungroup& change);
  text::Result<std::map<std::string, cdl::ExpressionPtr>> values_of(const cdl::Call& call,
                                                                    const cdl::Assemblage& assemblage) const;

  // ---- edit_clipboard.cc
  using Renamed = std::vector<std::pair<std::string, std::string>>;  // what they were called, and are
  Done paste(const Paste& change);
  Done paste_declarations(const std::string& text);
  text::Result<Renamed> paste_states(const PageView& view, std::vector<cdl::State> states);
  text::Result<Renamed> paste_lets(const PageView& view, std::vector<cdl::Let> lets);
  Done arrange_pasted(const Paste& change, const Renamed& renamed,
                      const std::vector<cdl::LayoutEntry>& places);

  Workspace& work_;
  PageWriter pages_;
};

}  // namespace mlab::designer
