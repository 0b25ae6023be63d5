#include "mlab/designer/edit/change/groups.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/designer/edit/change/layout.h"
#include "mlab/designer/edit/find/declared.h"
#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/page_writer.h"
#include "mlab/designer/edit/values.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl/syntax/walk.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

/// @param visit  a Name and the expression that it is
void for_each_name(const cdl::Expression& expression, const auto& visit) {
  cdl::for_each_expression(expression, [&](const cdl::Expression& one) {
    if (const auto* name = std::get_if<cdl::Name>(&one.what)) visit(*name, one);
  });
}

bool has_block(const cdl::Expression& expression) {
  bool out = false;
  cdl::for_each_expression(expression, [&](const cdl::Expression& one) { out |= is_block(one); });
  return out;
}

bool is_inside(text::Span inner, text::Span outer) {
  return outer.begin <= inner.begin && inner.end <= outer.end;
}

// Whether something outside of the chosen nodes reads one of them, or nothing at all.
bool is_output(const PageView& view, const std::set<int>& chosen, int at) {
  bool is_read_inside = false;
  bool is_read_outside = view.page->result == at;
  const cdl::Let* let = view.node(at).let;
  int inside = 0;
  for (std::size_t k = 0; k < view.page->nodes.size(); ++k) {
    const bool is_chosen = chosen.contains(static_cast<int>(k));
    for (const GraphInput& input : view.page->nodes[k].inputs) {
      if (input.from == at) (is_chosen ? is_read_inside : is_read_outside) = true;
      const auto* reads = input.written ? std::get_if<cdl::Name>(&input.written->what) : nullptr;
      if (is_chosen && let != nullptr && reads != nullptr && reads->name.text == let->name.text) ++inside;
    }
  }
  if (let != nullptr && count_uses(*view.graph, let->name.text) > inside) is_read_outside = true;
  return is_read_outside || !is_read_inside;
}

/// The assemblage that nodes of a page become: what drives them from outside becomes its parameters.
class GroupDraft {
 public:
  GroupDraft(const Model& model, const PageView& view, const std::set<int>& chosen)
      : model_(model), view_(view), chosen_(chosen), inside_(model.tree()) {
    for (const int at : chosen) {
      if (view.node(at).let != nullptr) lets_.insert(view.node(at).let->name.text);
    }
    taken_ = lets_;
  }

  /// @errors  where a type is not known
  Done gather(int top) {
    for (const int at : chosen_) {
      for (const GraphInput& input : view_.node(at).inputs) {
        const bool stays_outside = input.written && input.is_inline && !chosen_.contains(input.from);
        if (!stays_outside) continue;
        if (const Done done = hoist(input); !done) return done;
      }
    }
    if (const Done done = look(*view_.node(top).expression); !done) return done;
    for (const int at : chosen_) {
      const cdl::Let* let = view_.node(at).let;
      if (let == nullptr || at == top) continue;
      if (const Done done = look(*let->value); !done) return done;
    }
    // Parameters with a default come behind those without.
    std::ranges::stable_partition(given_, [](const NewParameter& one) { return !one.parameter.initial; });
    return true;
  }

  cdl::Assemblage assemblage(const std::string& name, int top) const {
    cdl::Assemblage out;
    out.name.text = name;
    for (const NewParameter& one : given_) out.parameters.push_back(one.parameter);
    for (const cdl::Let& let : view_.lets()) {
      const bool comes =
          std::ranges::any_of(chosen_, [&](int at) { return at != top && view_.node(at).let == &let; });
      if (!comes) continue;
      cdl::Let& copy = out.lets.emplace_back(let);
      copy.value = inside_.of(let.value);
      if (copy.value != let.value) copy.whole = {};
    }
    const cdl::ExpressionPtr body = inside_.of(*view_.node(top).expression);
    out.body = body->active ? body : bare(*body);
    return out;
  }

  cdl::ExpressionPtr call(const std::string& name, const cdl::Expression& body) const {
    auto out = std::make_shared<cdl::Expression>();
    cdl::Call& call = out->what.emplace<cdl::Call>();
    call.callee.text = name;
    for (const NewParameter& one : given_)
      call.arguments.push_back({{one.parameter.name.text, {}}, one.outside});
    if (!body.active) out->as = body.as;
    return out;
  }

 private:
  struct NewParameter {
    cdl::Parameter parameter;
    cdl::ExpressionPtr outside;  // what the caller gives
  };

  // The name of the parameter that stands for it inside.
  const std::string& add(const std::string& wanted, cdl::Parameter parameter,
                         const cdl::ExpressionPtr& outside) {
    parameter.name = {unique(wanted, taken_), {}};
    taken_.insert(parameter.name.text);
    return given_.emplace_back(std::move(parameter), outside).parameter.name.text;
  }

  // Written here, and stays outside.
  Done hoist(const GraphInput& input) {
    const GraphNode& node = view_.node(input.from);
    const cdl::PortType type = view_.graph->type_of(*node.expression);
    if (type.type == nullptr) return refusal(fmt::format("what type `{}` has can't be told", node.name));
    cdl::Parameter parameter;
    set_type(parameter, type);
    const text::Span span = input.written->place.span;
    const std::string wanted = input.port == "members" ? default_name(*input.written) : input.port;
    inside_.replace(*input.written, named(add(wanted, parameter, input.written)));
    hoisted_.push_back(span);
    return true;
  }

  Done look(const cdl::Expression& expression) {
    Done out = true;
    for_each_name(expression, [&](const cdl::Name& one, const cdl::Expression& whole) {
      const bool is_known =
          lets_.contains(one.name.text) ||
          std::ranges::any_of(hoisted_, [&](text::Span span) { return is_inside(whole.place.span, span); });
      if (!is_known && out) out = give(one.name);
    });
    return out;
  }

  // A name that the owner has.
  Done give(const cdl::Word& word) {
    if (names_.contains(word.text)) return call_so(word);
    const auto is_it = [&](const auto& one) { return one.name.text == word.text; };
    const auto parameter = std::ranges::find_if(view_.graph->parameters(), is_it);
    const auto let = std::ranges::find_if(view_.lets(), is_it);
    cdl::Parameter made;
    if (parameter != view_.graph->parameters().end()) {
      made = copy_of(*parameter);
    } else if (let != view_.lets().end()) {
      const cdl::PortType type = view_.graph->type_of(*let->value);
      if (type.type == nullptr) return refusal(fmt::format("what type `{}` has can't be told", word.text));
      set_type(made, type);
    } else {
      return true;
    }
    names_[word.text] = add(word.text, made, named(word.text));
    return call_so(word);
  }

  Done call_so(const cdl::Word& word) {
    const std::string& name = names_.at(word.text);
    if (name != word.text) inside_.rename(word, name);
    return true;
  }

  // A text of its own: the parameter stays where it is, too.
  cdl::Parameter copy_of(const cdl::Parameter& parameter) const {
    const std::string words = fmt::format("assemblage A({});", model_.source()->text(parameter.whole));
    cdl::Parameter out = std::get<cdl::Assemblage>(items_of(words).front()).parameters.front();
    out.whole = {};
    return out;
  }

  const Model& model_;
  const PageView& view_;
  const std::set<int>& chosen_;
  cdl::Changes inside_;
  std::vector<NewParameter> given_;
  std::map<std::string, std::string> names_;  // of the owner, and what they are called inside
  std::vector<text::Span> hoisted_;
  std::set<std::string> lets_;
  std::set<std::string> taken_;
};

// What stands for the names of an assemblage put into it.
cdl::Changes put_in(const cdl::Assemblage& assemblage,
                    const std::map<std::string, cdl::ExpressionPtr>& names) {
  static const cdl::Tree kNoTree;
  cdl::Changes out(kNoTree);
  cdl::for_each_construct(assemblage, [&]<class X>(const X& one) {
    if constexpr (std::same_as<X, cdl::Expression>) {
      const auto* name = std::get_if<cdl::Name>(&one.what);
      const auto known = name == nullptr ? names.end() : names.find(name->name.text);
      if (known == names.end()) return;
      if (one.as.text.empty() && !one.active) {
        out.replace(one, known->second);
      } else {
        out.change<X>(one, [value = known->second](X& now) { now.what = value->what; });
      }
    }
  });
  return out;
}

// The same by a name that somebody gave, where it may have one and has none of its own.
cdl::ExpressionPtr called_as(const cdl::ExpressionPtr& what, const cdl::Word& name) {
  if (name.text.empty() || !what->as.text.empty() || what->active || default_name(*what).empty()) return what;
  auto out = std::make_shared<cdl::Expression>(*what);
  out->as = name;
  out->whole = {};
  return out;
}

// Which of them others read: inline elsewhere, by name elsewhere, as the page's result.
text::Result<int> output_of(const PageView& view, const std::set<int>& chosen) {
  std::vector<int> outputs;
  std::vector<std::string> names;
  for (const int at : chosen) {
    if (!is_output(view, chosen, at)) continue;
    outputs.push_back(at);
    names.push_back(fmt::format("`{}`", view.node(at).name));
  }
  if (outputs.size() == 1) return outputs.front();
  return refusal(
      fmt::format("an assemblage gives one value, and these give several: {}; choose what they lead to "
                  "as well, so that one is left",
                  fmt::join(names, ", ")));
}

/// A node that is followed, and where it stood [px].
struct NodePosition {
  int handle = -1;
  double x = 0.0;
  double y = 0.0;
};

// Where the layout has these nodes, and by what they are found again.
std::vector<NodePosition> node_positions(Workspace& work, const PageView& view, const std::string& page,
                                         const std::set<int>& nodes) {
  std::vector<NodePosition> out;
  const cdl::Layout* layout = work.model().layout(page);
  if (layout == nullptr) return out;
  for (const int at : nodes) {
    const GraphNode& one = view.node(at);
    const auto entry = std::ranges::find_if(
        layout->entries, [&](const cdl::LayoutEntry& e) { return e.node.text == one.name; });
    const std::optional<Anchor> anchor = anchor_of(one, work.tokens());
    if (entry != layout->entries.end() && anchor) out.push_back({work.follow(*anchor), entry->x, entry->y});
  }
  return out;
}

// The nodes stand in the new assemblage as they stood, and its own node where the change says.
Done arrange_group(Workspace& work, const Group& change, const std::vector<NodePosition>& stood) {
  Arrange inside;
  inside.set_page(change.name());
  const auto add = [](Arrange& where, const std::string& node, double x, double y) {
    Arrange::At& at = *where.add_nodes();
    at.set_node(node);
    at.set_x(x);
    at.set_y(y);
  };
  for (const auto& [name, anchor] : anchors_of(work.model(), change.name(), work.tokens())) {
    for (const NodePosition& one : stood) {
      if (work.where(one.handle) == anchor) add(inside, name, one.x, one.y);
    }
  }
  if (inside.nodes_size() > 0) {
    if (const Done done = arrange(work, inside); !done) return done;
  }
  if (!change.has_x() || !change.has_y()) return true;
  const text::Result<PageView> found = find_page(work.model(), change.page());
  if (!found) return std::unexpected(found.error());
  Arrange outside;
  outside.set_page(change.page());
  for (const GraphNode& one : found->page->nodes) {
    const auto* call = one.expression == nullptr ? nullptr : std::get_if<cdl::Call>(&one.expression->what);
    if (call != nullptr && call->callee.text == change.name()) add(outside, one.name, change.x(), change.y());
  }
  return outside.nodes_size() == 0 ? Done(true) : arrange(work, outside);
}

// What a call gives each parameter.
text::Result<std::map<std::string, cdl::ExpressionPtr>> values_of(const cdl::Call& call,
                                                                  const cdl::Assemblage& assemblage) {
  std::map<std::string, cdl::ExpressionPtr> out;
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const cdl::Argument& argument = call.arguments[i];
    const bool is_placed = argument.name.text.empty() && i < assemblage.parameters.size();
    out[is_placed ? assemblage.parameters[i].name.text : argument.name.text] = argument.value;
  }
  for (const cdl::Parameter& parameter : assemblage.parameters) {
    const auto [value, is_new] = out.try_emplace(parameter.name.text, parameter.initial);
    if (!value->second) return refusal(fmt::format("`{}` has no value here", parameter.name.text));
  }
  return out;
}

}  // namespace

Done group_nodes(Workspace& work, const Group& change) {
  const text::Result<PageView> found = find_page(work.model(), change.page());
  if (!found) return std::unexpected(found.error());
  const PageView view = *found;
  const std::string& name = change.name();
  if (!is_cdl_name(name)) return refusal(fmt::format("`{}` is no name", text::shown(name)));
  if (is_declared(work, name) || work.model().components().find(name))
    return refusal(fmt::format("there is a `{}` already", name));
  std::set<int> chosen;
  for (const std::string& one : change.nodes()) {
    const text::Result<int> at = find_node(view, one);
    if (!at) return std::unexpected(at.error());
    if (view.node(*at).expression != nullptr) chosen.insert(*at);
  }
  if (chosen.empty()) return refusal("no node is chosen that could be a part of an assemblage");
  const text::Result<int> top = output_of(view, chosen);
  if (!top) return std::unexpected(top.error());
  GroupDraft draft(work.model(), view, chosen);
  if (const Done done = draft.gather(*top); !done) return done;
  // Before the declaration that they come from.
  const cdl::Expression& body = *view.node(*top).expression;
  for (const cdl::Item& item : work.model().tree().items) {
    const void* const one = std::visit([](const auto& what) -> const void* { return &what; }, item);
    if (one == view.graph->assemblage || one == view.graph->robot)
      work.changes().add(draft.assemblage(name, *top), &item);
  }
  work.changes().replace(body, draft.call(name, body));
  for (const int at : chosen) {
    if (view.node(at).let != nullptr && at != *top) work.changes().remove(*view.node(at).let);
  }
  const std::vector<NodePosition> stood = node_positions(work, view, change.page(), chosen);
  if (const Done done = work.commit(); !done) return done;
  return arrange_group(work, change, stood);
}

Done ungroup_node(Workspace& work, const Ungroup& change) {
  const text::Result<PageView> found = find_page(work.model(), change.page());
  if (!found) return std::unexpected(found.error());
  const PageView view = *found;
  const text::Result<int> at = find_node(view, change.node());
  if (!at) return std::unexpected(at.error());
  const GraphNode& there = view.node(*at);
  const auto* call = there.expression == nullptr ? nullptr : std::get_if<cdl::Call>(&there.expression->what);
  const auto& assemblages = work.model().configuration().assemblages;
  if (call == nullptr || !assemblages.contains(call->callee.text))
    return refusal("only an assemblage is made of something");
  const cdl::Assemblage& declared = *assemblages.find(call->callee.text)->second;
  if (!declared.body) return refusal("the assemblage is empty");
  // A text of its own: the assemblage stays where it is, too.
  const std::vector<cdl::Item> copy = items_of(std::string(declared.name.place.source->text(declared.whole)));
  const auto& assemblage = std::get<cdl::Assemblage>(copy.front());

  std::set<std::string> taken;
  for (const cdl::Let& let : view.lets()) taken.insert(let.name.text);
  for (const cdl::Parameter& parameter : view.graph->parameters()) taken.insert(parameter.name.text);
  std::vector<cdl::Let> lets;
  const auto add = [&](const std::string& wanted, const cdl::ExpressionPtr& value) {
    const std::string own = unique(wanted, taken);
    taken.insert(own);
    lets.push_back({{own, {}}, value, ""});
    return named(own);
  };
  const text::Result<std::map<std::string, cdl::ExpressionPtr>> values = values_of(*call, assemblage);
  if (!values) return std::unexpected(values.error());
  std::map<std::string, cdl::ExpressionPtr> names;
  for (const cdl::Parameter& parameter : assemblage.parameters) {
    const std::string& name = parameter.name.text;
    const cdl::ExpressionPtr& value = values->at(name);
    // A node that several of its parts read stays one node.
    int uses = 0;
    cdl::for_each_construct(assemblage, [&]<class X>(const X& one) {
      if constexpr (std::same_as<X, cdl::Name>) uses += one.name.text == name ? 1 : 0;
    });
    names[name] = has_node(*value) && uses > 1 ? add(name, value) : value;
  }
  for (const cdl::Let& let : assemblage.lets) names[let.name.text] = add(let.name.text, let.value);
  const cdl::Changes inside = put_in(assemblage, names);
  for (cdl::Let& let : lets) let.value = inside.of(let.value);
  cdl::ExpressionPtr body = called_as(inside.of(assemblage.body), there.expression->as);
  const GraphInput* input =
      there.reader < 0 ? nullptr
                       : &view.node(there.reader).inputs[static_cast<std::size_t>(there.reader_input)];
  const bool takes_block = input == nullptr || there.let != nullptr || input->role == Role::kMember ||
                           input->role == Role::kCase || input->role == Role::kDrive;
  if (!takes_block && has_block(*body)) body = add(default_name(*body), body);
  add_lets(work, *view.graph, std::move(lets));
  work.changes().replace(*there.expression, body);
  return work.commit();
}

}  // namespace mlab::designer
