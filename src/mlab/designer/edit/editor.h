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

  // ---- edit_triggers.cc
  Done change_trigger(const ChangeTrigger& change);
  text::Result<cdl::ExpressionPtr> condition(const std::string& component) const;
  cdl::ExpressionPtr chosen(const cdl::Expression& old, const Callable& component,
                            const OwnerGraph& graph) const;
  Done place_in_trigger(const PageView& view, const Place& change);

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
