#pragma once

#include <string>
#include <vector>

#include "mlab/base/random.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/drawing/model.h"

namespace mlab::designer::testing {

/// Changes as a person might make them: of nodes that are there, mostly, and now and then of what is not.
class RandomEdit {
 public:
  RandomEdit(const Model& model, base::Random& random) : model_(model), random_(random) {}

  Edit make() {
    Edit out;
    fill(*out.add_changes());
    return out;
  }

 private:
  std::size_t below(std::size_t most) {
    return most == 0 ? 0 : static_cast<std::size_t>(random_.below(most));
  }
  bool rarely() { return below(20) == 0; }
  template <class List>
  auto one_of(const List& list) {
    return list[static_cast<int>(below(static_cast<std::size_t>(list.size())))];
  }
  std::string word(const std::vector<std::string>& words) { return words[below(words.size())]; }

  std::string owner() {
    std::vector<std::string> names;
    for (const cdl::Item& item : model_.tree().items) {
      if (const auto* one = std::get_if<cdl::Assemblage>(&item)) names.push_back(one->name.text);
      if (const auto* one = std::get_if<cdl::Robot>(&item)) names.push_back(one->name.text);
    }
    return names.empty() || rarely() ? "Nobody" : word(names);
  }
  void look_at_page() {
    const std::string name = owner();
    page_ = name;
    if (const OwnerGraph* graph = model_.graph(name)) page_ = graph->pages[below(graph->pages.size())].path;
    drawing_ = draw(model_, page_, {"a.cdl", 1, false, [](std::string_view) { return std::string(); }});
  }
  std::string node() {
    return drawing_.nodes().empty() || rarely() ? "Nothing" : one_of(drawing_.nodes()).name();
  }
  std::string state() {
    return drawing_.states().empty() || rarely() ? "Nowhere" : one_of(drawing_.states()).name();
  }
  std::string component() {
    return word({"Noise",
                 "Stand",
                 "cooperate",
                 "compete by priority",
                 "compete by strength",
                 "sequence",
                 "select",
                 "delay",
                 "not",
                 "and",
                 "or",
                 "formula",
                 "min",
                 "distance",
                 "AvoidStaticObstacles",
                 "sense_obstacles",
                 "DetectGoal",
                 "MoveToGoal",
                 "Detect",
                 "Wander",
                 "coordinate by WeightedSum",
                 "NoSuchThing",
                 "Holding",
                 "LookAround"});
  }
  std::string value() {
    return word({"1", "0.5", "2 m", "3 s", "Mine", "\"Flag|Basket\"", "[1, 2]", "true", "", "not a value (",
                 "1 - 2 * 3", "2 * home + 1", "length(way) < 3 m", "-(a) / 2 m", "place(\"Gate\")", "Noise()",
                 "home", "around", "cooperate { 1: Stand(); }"});
  }
  std::string name() {
    return word({"drift", "home", "Noise", "a", "around", "goal_2", "not a name", "Searching", "cooperate"});
  }

  // A node's input, as the drawing has it.
  template <class Change>
  void aim(Change& change) {
    change.set_page(page_);
    if (drawing_.nodes().empty()) return;
    const Node& to = one_of(drawing_.nodes());
    set_node(change, to.name());
    if (to.inputs().empty()) return;
    const Port& port = one_of(to.inputs());
    const bool is_weight = port.is_member() && below(4) == 0;
    set_port(change, is_weight ? "weight" : port.name());
    if (port.has_index()) change.set_index(port.index());
  }
  static void set_node(Connect& change, const std::string& node) { change.set_to_node(node); }
  static void set_node(Disconnect& change, const std::string& node) { change.set_to_node(node); }
  static void set_node(SetValue& change, const std::string& node) { change.set_node(node); }
  static void set_node(Expose& change, const std::string& node) { change.set_node(node); }
  static void set_port(Connect& change, const std::string& port) { change.set_to_port(port); }
  static void set_port(Disconnect& change, const std::string& port) { change.set_to_port(port); }
  static void set_port(SetValue& change, const std::string& port) { change.set_port(port); }
  static void set_port(Expose& change, const std::string& port) { change.set_port(port); }

  void change_trigger(ChangeTrigger& change) {
    change.set_page(page_);
    change.set_from(state());
    change.set_index(static_cast<std::uint32_t>(below(2)));
    while (below(2) == 0) change.add_part(static_cast<std::uint32_t>(below(2)));
    change.set_how(static_cast<ChangeTrigger::How>(below(6)));
    change.set_component(word({"Near", "IsAtGoal", "Detect", "Wander"}));
  }

  // ---- classes, operators, binding points, societies

  // Of that kind, now and then one that is not there.
  template <class Kind>
  std::string declared() {
    std::vector<std::string> names;
    for (const cdl::Item& item : model_.tree().items) {
      if (const auto* one = std::get_if<Kind>(&item)) names.push_back(one->name.text);
    }
    return names.empty() || rarely() ? "Nobody" : word(names);
  }
  std::string equipped_owner() {
    return below(3) == 0 ? declared<cdl::SocietyOperator>() : declared<cdl::RobotClass>();
  }
  // Of the class's page: a device, a part of the body, a binding point.
  void aim_at_equipment(SetValue& change) {
    const Drawing drawing = drawing_of(equipped_owner());
    change.set_page(drawing.page().path());
    if (drawing.nodes().empty()) return;
    const Node& node = one_of(drawing.nodes());
    change.set_node(node.name());
    if (!node.inputs().empty()) change.set_port(one_of(node.inputs()).name());
  }
  std::string device_of(const Drawing& drawing) {
    const auto& devices = drawing.equipment().devices();
    return devices.empty() || rarely() ? "nothing" : one_of(devices).name();
  }
  Drawing drawing_of(const std::string& page) {
    return draw(model_, page, {"a.cdl", 1, false, [](std::string_view) { return std::string(); }});
  }
  std::string binding_point() {
    return word({"sense_obstacles", "sense_robots", "movement", "pantilt", "choose_target", "sense_nothing"});
  }
  std::string server() {
    return word({"DetectObstacles", "DetectRobots", "DriveAndSpin", "Drive", "PanTilt", "Noise", "Nothing"});
  }

  void set_device(SetDevice& change) {
    const Drawing drawing = drawing_of(equipped_owner());
    change.set_owner(drawing.page().path());
    if (below(2) == 0) change.set_device(device_of(drawing));
    if (change.device().empty() || below(2) == 0) change.set_binds(binding_point());
    if (change.device().empty() || below(2) == 0) change.set_component(server());
  }

  // What also stands on other pages: values, names, help, parameters, places, wires.
  void change_equipment(Change& change) {
    const Drawing drawing = drawing_of(equipped_owner());
    const std::string page = drawing.page().path();
    switch (below(8)) {
      case 0:
      case 1:
        aim_at_equipment(*change.mutable_set_value());
        change.mutable_set_value()->set_value(
            below(3) == 0 ? value() : word({"", "30 deg", "2 m", "0.5", "car", "differential", "24"}));
        return;
      case 2: {
        SetValue there;
        aim_at_equipment(there);
        change.mutable_expose()->set_page(there.page());
        change.mutable_expose()->set_node(there.node());
        change.mutable_expose()->set_port(there.port());
        return;
      }
      case 3:
        change.mutable_rename()->set_page(page);
        change.mutable_rename()->set_node(device_of(drawing));
        change.mutable_rename()->set_name(word({"eyes", "wheels", "not a name", "base"}));
        return;
      case 4:
        change.mutable_remove()->set_page(page);
        change.mutable_remove()->add_nodes(
            below(4) == 0 && !drawing.nodes().empty() ? one_of(drawing.nodes()).name() : device_of(drawing));
        return;
      case 5: {
        change.mutable_arrange()->set_page(page);
        Arrange::At& at = *change.mutable_arrange()->add_nodes();
        at.set_node(drawing.nodes().empty() ? "nothing" : one_of(drawing.nodes()).name());
        at.set_x(static_cast<double>(below(500)));
        at.set_y(40.0);
        return;
      }
      case 6:
        change.mutable_connect()->set_page(page);
        change.mutable_connect()->set_from_node(device_of(drawing));
        change.mutable_connect()->set_to_node("$point." + binding_point());
        return;
      default:
        change.mutable_set_help()->set_page(page);
        change.mutable_set_help()->set_node(device_of(drawing));
        change.mutable_set_help()->set_text(word({"", "what it is", "two\nlines"}));
    }
  }

  template <class Path>
  void lead_to_member(const Drawing& drawing, Path& path) {
    if (drawing.nodes().empty()) return;
    const Node& node = one_of(drawing.nodes());
    for (const std::uint32_t at : node.member()) path.Add(at);
    if (below(4) == 0) path.Add(static_cast<std::uint32_t>(below(3)));
  }

  void change_society(Change& change) {
    const std::string society = declared<cdl::Society>();
    const Drawing drawing = drawing_of(society);
    switch (below(6)) {
      case 0:
      case 1: {
        SetMember& one = *change.mutable_set_member();
        one.set_society(society);
        lead_to_member(drawing, *one.mutable_path());
        one.set_name(below(4) == 0 ? declared<cdl::Society>() : declared<cdl::Robot>());
        one.set_count(static_cast<std::uint32_t>(below(4)));
        one.set_is_caste(below(3) == 0);
        if (below(3) == 0) one.set_by(declared<cdl::SocietyOperator>());
        return;
      }
      case 2:
        change.mutable_remove_member()->set_society(society);
        lead_to_member(drawing, *change.mutable_remove_member()->mutable_path());
        return;
      case 3: {
        GroupMembers& one = *change.mutable_group_members();
        one.set_society(society);
        lead_to_member(drawing, *one.mutable_path());
        for (int i = 0; i < 2; ++i) one.add_members(static_cast<std::uint32_t>(below(3)));
        return;
      }
      case 4:
        change.mutable_ungroup_members()->set_society(society);
        lead_to_member(drawing, *change.mutable_ungroup_members()->mutable_path());
        return;
      default:
        change.mutable_move_member()->set_society(society);
        lead_to_member(drawing, *change.mutable_move_member()->mutable_path());
        lead_to_member(drawing, *change.mutable_move_member()->mutable_into());
        change.mutable_move_member()->set_index(static_cast<std::uint32_t>(below(3)));
    }
  }

  void declare(AddDeclaration& change) {
    change.set_kind(word({"class", "operator", "binding", "robot", "society"}));
    change.set_name(word({"Fresh", "Other", "fresh_point", "not a name"}));
    if (change.kind() == "class" && below(2) == 0) change.set_robot(declared<cdl::Robot>());
  }

  // NOLINTNEXTLINE(readability-function-size): a row for each change
  void fill(Change& change) {
    look_at_page();
    switch (below(33)) {
      case 0:
      case 1:
      case 2: {
        Place& one = *change.mutable_place();
        one.set_page(page_);
        one.set_component(component());
        one.set_x(static_cast<double>(below(500)));
        one.set_y(static_cast<double>(below(500)));
        return;
      }
      case 3:
      case 4:
      case 5:
      case 6:
        aim(*change.mutable_connect());
        change.mutable_connect()->set_from_node(node());
        if (below(6) == 0) change.mutable_connect()->set_to_node("$result");
        return;
      case 7:
      case 8:
        aim(*change.mutable_disconnect());
        return;
      case 9:
      case 10:
        aim(*change.mutable_set_value());
        change.mutable_set_value()->set_value(value());
        return;
      case 11:
      case 12:
        change.mutable_remove()->set_page(page_);
        change.mutable_remove()->add_nodes(drawing_.states().empty() || below(2) == 0 ? node() : state());
        if (below(3) == 0) change.mutable_remove()->add_nodes(node());
        return;
      case 13:
        aim(*change.mutable_expose());
        return;
      case 14:
        change.mutable_rename()->set_page(page_);
        change.mutable_rename()->set_node(drawing_.states().empty() || below(2) == 0 ? node() : state());
        change.mutable_rename()->set_name(name());
        return;
      case 15: {
        change.mutable_arrange()->set_page(page_);
        Arrange::At& at = *change.mutable_arrange()->add_nodes();
        at.set_node(node());
        at.set_x(static_cast<double>(below(1000)) - 500.0);
        at.set_y(static_cast<double>(below(1000)));
        return;
      }
      case 16:
        change.mutable_set_active()->set_page(page_);
        change.mutable_set_active()->set_node(node());
        change.mutable_set_active()->set_component(below(2) == 0 ? "" : "LookAround");
        return;
      case 17:
        change.mutable_group()->set_page(page_);
        for (int i = 0; i < 3; ++i) change.mutable_group()->add_nodes(node());
        change.mutable_group()->set_name(word({"Part", "Other", "Wander"}));
        return;
      case 18:
        change.mutable_ungroup()->set_page(page_);
        change.mutable_ungroup()->set_node(node());
        return;
      case 19:
        change.mutable_replace()->set_page(page_);
        change.mutable_replace()->set_node(node());
        change.mutable_replace()->set_component(component());
        return;
      case 20: {
        SetNote& one = *change.mutable_set_note();
        one.set_page(page_);
        one.set_text(word({"a note", "two\nlines \"quoted\"", ""}));
        one.set_width(static_cast<double>(below(2) * 100));
        one.set_is_frame(below(2) == 0);
        if (below(3) == 0) one.set_id("1");
        return;
      }
      case 21:
        change.mutable_set_parameter()->set_owner(std::string(owner_of(page_)));
        change.mutable_set_parameter()->set_name(name());
        change.mutable_set_parameter()->set_type(word({"gain", "length", "angle [deg]", "Vector"}));
        change.mutable_set_parameter()->set_initial(word({"", "1", "2"}));
        change.mutable_set_parameter()->set_help(word({"", "how much"}));
        return;
      case 22:
        if (!drawing_.parameters().empty()) {
          change.mutable_remove_parameter()->set_owner(std::string(owner_of(page_)));
          change.mutable_remove_parameter()->set_name(one_of(drawing_.parameters()).name());
          return;
        }
        change.mutable_set_help()->set_page(page_);
        change.mutable_set_help()->set_node(node());
        change.mutable_set_help()->set_text(word({"", "what it is for", "two\nlines"}));
        return;
      case 23:
        if (below(2) == 0) {
          change.mutable_add_state()->set_page(page_);
          change.mutable_add_state()->set_component(component());
        } else {
          SetState& one = *change.mutable_set_state();
          one.set_page(page_);
          one.set_state(state());
          if (below(2) == 0) one.set_is_start(below(2) == 0);
          if (below(2) == 0) one.set_is_final(below(2) == 0);
          if (below(2) == 0) one.set_member(value());
        }
        return;
      case 24:
        if (below(2) == 0) {
          change.mutable_add_transition()->set_page(page_);
          change.mutable_add_transition()->set_from(state());
          change.mutable_add_transition()->set_to(state());
        } else {
          SetTransition& one = *change.mutable_set_transition();
          one.set_page(page_);
          one.set_from(state());
          one.set_index(static_cast<std::uint32_t>(below(3)));
          if (below(2) == 0) one.set_to(state());
          if (below(2) == 0) one.set_trigger("Detect(Mine)");
          if (below(2) == 0) one.set_restarts(below(2) == 0);
          if (below(2) == 0) one.set_new_index(static_cast<std::uint32_t>(below(3)));
        }
        return;
      case 25:
        change_trigger(*change.mutable_change_trigger());
        return;
      case 26:
        set_device(*change.mutable_set_device());
        return;
      case 27:
      case 28:
        change_equipment(change);
        return;
      case 29:
      case 30:
        change_society(change);
        return;
      case 31:
        if (below(2) == 0) {
          declare(*change.mutable_add_declaration());
          return;
        }
        change.mutable_set_binding()->set_binding(declared<cdl::Binding>());
        change.mutable_set_binding()->set_type(word({"", "Obstacles", "Vector", "no type"}));
        return;
      default:
        change.mutable_remove_transition()->set_page(page_);
        change.mutable_remove_transition()->set_from(state());
        change.mutable_remove_transition()->set_index(static_cast<std::uint32_t>(below(3)));
    }
  }

  const Model& model_;
  base::Random& random_;
  std::string page_;
  Drawing drawing_;
};

}  // namespace mlab::designer::testing
