#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/designer/drawing/graph.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/designer/edit/edit.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::designer::testing {

/// A text that is changed as a drawing of it is.
class DrawnText {
 public:
  explicit DrawnText(std::string text) { set(std::move(text)); }

  const std::string& text() const { return text_; }
  const Model& model() const { return *model_; }
  /// What is wrong with it, as a person reads it.
  std::string errors() const {
    Model checked(model_->source(), robot::library_environment());
    checked.check();
    std::string out;
    for (const text::Diagnostic& d : checked.problems().items()) {
      if (d.severity == text::Severity::kError) out += text::render(d);
    }
    return out;
  }

  text::Result<Edited> try_edit(const Edit& edit) const {
    return edited(model_, robot::library_environment(), edit);
  }
  void apply(const Edit& edit) {
    const text::Result<Edited> done = try_edit(edit);
    ASSERT_TRUE(done.has_value()) << done.error().message << "\n" << edit.DebugString() << text_;
    set(done->text);
  }
  void change(const std::function<void(Change&)>& fill) {
    Edit edit;
    fill(*edit.add_changes());
    apply(edit);
  }
  std::string refused(const std::function<void(Edit&)>& fill) const {
    Edit edit;
    fill(edit);
    const text::Result<Edited> done = try_edit(edit);
    return done ? "" : done.error().message;
  }
  void set(std::string text) {
    text_ = std::move(text);
    model_ = std::make_shared<Model>(std::make_shared<const text::Source>("test.cdl", text_),
                                     robot::library_environment());
  }

  void declare(const std::string& kind, const std::string& name) {
    change([&](Change& change) {
      change.mutable_add_declaration()->set_kind(kind);
      change.mutable_add_declaration()->set_name(name);
    });
  }
  void parameter(const std::string& owner, const std::string& name, const std::string& type,
                 const std::string& initial) {
    change([&](Change& change) {
      SetParameter& one = *change.mutable_set_parameter();
      one.set_owner(owner);
      one.set_name(name);
      one.set_type(type);
      one.set_initial(initial);
    });
  }
  void place(const std::string& page, const std::string& component, double x = 0, double y = 0) {
    change([&](Change& change) {
      Place& one = *change.mutable_place();
      one.set_page(page);
      one.set_component(component);
      one.set_x(x);
      one.set_y(y);
    });
  }
  void connect(const std::string& page, const std::string& from, const std::string& to,
               const std::string& port, std::optional<std::uint32_t> index = std::nullopt) {
    change([&](Change& change) {
      Connect& one = *change.mutable_connect();
      one.set_page(page);
      one.set_from_node(from);
      one.set_to_node(to);
      one.set_to_port(port);
      if (index) one.set_index(*index);
    });
  }
  void disconnect(const std::string& page, const std::string& to, const std::string& port,
                  std::optional<std::uint32_t> index = std::nullopt) {
    change([&](Change& change) {
      Disconnect& one = *change.mutable_disconnect();
      one.set_page(page);
      one.set_to_node(to);
      one.set_to_port(port);
      if (index) one.set_index(*index);
    });
  }
  void set(const std::string& page, const std::string& node, const std::string& port,
           const std::string& value, std::optional<std::uint32_t> index = std::nullopt) {
    change([&](Change& change) {
      SetValue& one = *change.mutable_set_value();
      one.set_page(page);
      one.set_node(node);
      one.set_port(port);
      one.set_value(value);
      if (index) one.set_index(*index);
    });
  }
  void remove(const std::string& page, const std::vector<std::string>& nodes) {
    change([&](Change& change) {
      change.mutable_remove()->set_page(page);
      for (const std::string& node : nodes) change.mutable_remove()->add_nodes(node);
    });
  }
  void rename(const std::string& page, const std::string& node, const std::string& name) {
    change([&](Change& change) {
      change.mutable_rename()->set_page(page);
      change.mutable_rename()->set_node(node);
      change.mutable_rename()->set_name(name);
    });
  }
  void expose(const std::string& page, const std::string& node, const std::string& port,
              std::optional<std::uint32_t> index = std::nullopt, const std::string& parameter = "") {
    change([&](Change& change) {
      Expose& one = *change.mutable_expose();
      one.set_page(page);
      one.set_node(node);
      one.set_port(port);
      one.set_parameter(parameter);
      if (index) one.set_index(*index);
    });
  }
  /// The name of a node's first input.
  std::string first_input(const std::string& page, const std::string& node) const {
    const Model::FoundPage found = model_->page(page);
    if (found.graph == nullptr) return "";
    const GraphPage& there = found.graph->pages[static_cast<std::size_t>(found.page)];
    const int at = there.find(node);
    return at < 0 ? "" : there.nodes[static_cast<std::size_t>(at)].inputs.front().port;
  }

 private:
  std::string text_;
  std::shared_ptr<const Model> model_;
};

}  // namespace mlab::designer::testing
