#include "mlab/lang/cnl/elaborate.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cnl/generate.h"
#include "mlab/text/shown.h"

namespace mlab::cnl {
namespace {

// The type of the parameter that a historic node of this procedure stands for; empty: it is another
// procedure.
std::string_view database_type(std::string_view procedure) {
  if (procedure == "DATABASE_DOUBLE") return "double";
  if (procedure == "DATABASE_INT") return "int";
  if (procedure == "DATABASE_BOOLEAN") return "bool";
  return {};
}

class Elaborator {
 public:
  explicit Elaborator(text::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  flow::Network run(const Tree& tree) {
    network_.name = tree.source ? stem_of(tree.source->name()) : "";
    for (const ModuleDecl* module : items_of<ModuleDecl>(tree)) {
      if (module->is_own) network_.name = module->name.text;
    }
    for (const Procedure* procedure : items_of<Procedure>(tree)) {
      procedures_.emplace(procedure->name.text, procedure->name.place);
    }
    visit_items(tree, [&](const Item& item) {
      if (const auto* parameter = std::get_if<ParameterDecl>(&item))
        network_.parameters.push_back(parameter->parameter);
      if (const auto* node = std::get_if<NodeDecl>(&item)) add(*node);
    });
    return std::move(network_);
  }

 private:
  void add(const NodeDecl& decl) {
    if (!decl.remote_module.text.empty()) return;  // was refused where it was read
    check_name(decl.node);
    const bool is_behavior = decl.node.kind == flow::Node::Kind::kBehavior;
    if (const std::string_view type = is_behavior ? database_type(decl.node.behavior) : ""; !type.empty()) {
      add_database(decl.node, type);
      return;
    }
    network_.nodes.push_back(decl.node);
    network_.nodes.back().is_public = decl.is_public;
  }

  void check_name(const flow::Node& node) {
    const auto procedure = procedures_.find(node.name);
    if (procedure == procedures_.end()) return;
    diagnostics_
        .error("node-named-like-procedure", node.place,
               fmt::format("`{}` is the name of a procedure", node.name))
        .notes.push_back({"declared here", procedure->second});
  }

  void add_database(const flow::Node& node, std::string_view type) {
    const std::optional<flow::Source> key = constant(node, "key");
    const std::optional<flow::Source> initial = constant(node, "initial");
    for (const flow::Link& link : node.links) {
      if (link.input == "key" || link.input == "initial") continue;
      diagnostics_.error("bad-database-node", link.place,
                         fmt::format("`{}` has no input `{}`", node.behavior, link.input));
    }
    if (!key || !initial) return;
    const auto [same_key, is_new] = keys_.emplace(key->text, network_.parameters.size());
    if (!is_new) {
      share(network_.parameters[same_key->second], node, type, *initial);
      return;
    }
    flow::Parameter parameter;
    parameter.name = key->text;
    parameter.type = type;
    parameter.initial = *initial;
    parameter.place = key->place;
    if (node.name != parameter.name) parameter.other_names.push_back(node.name);
    network_.parameters.push_back(std::move(parameter));
  }

  // Two nodes that read the same key are one parameter.
  void share(flow::Parameter& parameter, const flow::Node& node, std::string_view type,
             const flow::Source& initial) {
    if (parameter.type != type) {
      diagnostics_
          .error("bad-database-node", node.place,
                 fmt::format("`{}` is `{}` here and `{}` elsewhere", text::shown(parameter.name), type,
                             parameter.type))
          .notes.push_back({"first used here", parameter.place});
      return;
    }
    if (parameter.initial.text != initial.text) {
      diagnostics_
          .warning("different-initial", initial.place,
                   fmt::format("`{}` starts with {}, as the first node that reads it says",
                               text::shown(parameter.name), text::shown(parameter.initial.text)))
          .notes.push_back({"said here", parameter.initial.place});
    }
    if (node.name != parameter.name) parameter.other_names.push_back(node.name);
  }

  std::optional<flow::Source> constant(const flow::Node& node, std::string_view input) {
    const auto link = std::ranges::find_if(node.links, [&](const flow::Link& l) { return l.input == input; });
    if (link == node.links.end()) {
      diagnostics_.error("bad-database-node", node.place,
                         fmt::format("`{}` has no `{} = ...;`", node.name, input));
      return std::nullopt;
    }
    // Generated networks write keys as bare words, too.
    if (input == "key" || link->source.kind == flow::Source::Kind::kConstant) return link->source;
    diagnostics_.error("bad-database-node", link->source.place,
                       fmt::format("the `{}` of a parameter is a constant", input));
    return std::nullopt;
  }

  text::Diagnostics& diagnostics_;
  flow::Network network_;
  std::map<std::string, text::Place, std::less<>> procedures_;
  std::map<std::string, std::size_t, std::less<>> keys_;  ///< of historic parameters: index in the network
};

}  // namespace

flow::Network elaborate(const Tree& tree, text::Diagnostics& diagnostics) {
  return Elaborator(diagnostics).run(tree);
}

}  // namespace mlab::cnl
