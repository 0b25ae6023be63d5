#include "mlab/designer/graph.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/walk.h"

namespace mlab::designer {
namespace {

using cdl::Expression;
using Kind = GraphNode::Kind;

// Where a node goes, as in cdl::Lowering.
struct Slot {
  std::string prefix;
  std::string name;
  bool is_claimed = false;
};

// What drives an input.
struct Driver {
  int node = -1;
  bool is_inline = false;
};

constexpr int kHidden = -1;  // the page of what is not drawn: triggers

/// Walks an owner in the order in which lowering does, so that its nodes get the same names.
class Builder {
 public:
  Builder(OwnerGraph& graph, const Components& components,
          const std::multimap<std::string, std::string>& shown)
      : graph_(graph), components_(components), shown_(shown) {}

  void run() {
    new_page("", -1);
    for (const cdl::Parameter& parameter : graph_.parameters()) {
      if (is_wired(components_.types().of(parameter))) parameter_node(parameter, 0);
    }
    if (graph_.robot != nullptr) {
      for (const cdl::Parameter& parameter : graph_.parameters()) claim_path(parameter.name.text);
      for (const cdl::Drive& drive : graph_.robot->drives) walk_drive(drive);
    } else if (graph_.assemblage->body) {
      walk_page(*graph_.assemblage->body, 0);
    }
    for (const cdl::Let& let : graph_.lets()) walk_let(let);
    show_outer();
    for (GraphPage& page : graph_.pages) name_result(page);
  }

 private:
  GraphPage& page(int at) { return graph_.pages[static_cast<std::size_t>(at)]; }
  GraphNode& node(int on, int at) { return page(on).nodes[static_cast<std::size_t>(at)]; }

  int new_page(const std::string& base, int parent) {
    GraphPage out;
    out.base = base;
    out.path = base.empty() ? graph_.name : graph_.name + "." + base;
    out.parent = parent;
    graph_.pages.push_back(std::move(out));
    return static_cast<int>(graph_.pages.size()) - 1;
  }

  // ---- names, as cdl::Lowering::claim

  std::string claim_path(std::string path) {
    const int before = claimed_[path]++;
    if (before == 0) return path;
    for (int number = before + 1;; ++number) {
      std::string numbered = fmt::format("{}_{}", path, number);
      if (claimed_.try_emplace(numbered, 1).second) {
        claimed_[path] = number;
        return numbered;
      }
    }
  }
  std::string claim(const Slot& slot, const std::string& fallback) {
    if (slot.is_claimed) return slot.prefix;
    const std::string& name = slot.name.empty() ? fallback : slot.name;
    return claim_path(slot.prefix.empty() ? name : slot.prefix + "." + name);
  }
  std::string name_on(int on, const std::string& path) {
    const std::string& base = page(on).base;
    if (base.empty()) return path;
    return path.size() > base.size() + 1 && path.starts_with(base + ".") ? path.substr(base.size() + 1)
                                                                         : std::string();
  }

  // ---- nodes

  int add(Kind kind, const Expression& expression, const std::string& path, int on) {
    if (on == kHidden) return -1;
    GraphNode out;
    out.kind = kind;
    out.expression = &expression;
    out.path = path;
    out.name = name_on(on, path);
    const int at = static_cast<int>(page(on).nodes.size());
    if (const cdl::Let* let = std::exchange(pending_, nullptr)) {
      out.let = let;
      let_nodes_[let] = at;
    }
    page(on).nodes.push_back(std::move(out));
    return at;
  }

  int parameter_node(const cdl::Parameter& parameter, int on) {
    if (on == kHidden) return -1;
    const auto [found, is_new] = parameter_nodes_.try_emplace({on, &parameter}, 0);
    if (is_new) {
      GraphNode out;
      out.kind = Kind::kParameter;
      out.parameter = &parameter;
      out.name = parameter.name.text;
      found->second = static_cast<int>(page(on).nodes.size());
      page(on).nodes.push_back(std::move(out));
    }
    return found->second;
  }

  int outer_node(const cdl::Let& let, int on) {
    if (on == kHidden) return -1;
    const auto [found, is_new] = outer_nodes_.try_emplace({on, &let}, 0);
    if (is_new) {
      GraphNode out;
      out.kind = Kind::kOuter;
      out.let = &let;
      out.name = let.name.text;
      found->second = static_cast<int>(page(on).nodes.size());
      page(on).nodes.push_back(std::move(out));
    }
    return found->second;
  }

  void add_input(int on, int to, GraphInput input, const Driver& driver) {
    if (on == kHidden || to < 0) return;
    input.from = driver.node;
    input.is_inline = driver.is_inline && driver.node >= 0;
    if (input.is_inline) {
      node(on, driver.node).reader = to;
      node(on, driver.node).reader_input = static_cast<int>(node(on, to).inputs.size());
    }
    node(on, to).inputs.push_back(std::move(input));
  }

  // ---- expressions

  Driver walk(const Expression& expression, const Slot& slot, int on) {
    Slot own = slot;
    if (!expression.as.text.empty()) {
      const bool has_name = slot.is_claimed || !slot.name.empty();
      own = {has_name ? claim(slot, "") : slot.prefix, expression.as.text, false};
    }
    if (!expression.active) return walk_what(expression, own, on, nullptr);
    const auto* call = std::get_if<cdl::Call>(&expression.what);
    const std::string path = claim(own, call == nullptr ? "active" : call->callee.text);
    return walk_what(expression, {path, "value", false}, on, &path);
  }

  Driver walk_what(const Expression& expression, const Slot& slot, int on, const std::string* active_path) {
    const auto& what = expression.what;
    if (const auto* name = std::get_if<cdl::Name>(&what)) return walk_name(*name, on);
    if (const auto* list = std::get_if<cdl::List>(&what)) {
      for (const cdl::ExpressionPtr& item : list->items) walk(*item, {slot.prefix, "", false}, kHidden);
      return {};
    }
    const std::string fallback = default_name(expression);
    if (fallback.empty()) return {};
    const std::string path = claim(slot, fallback);
    if (on == kHidden) graph_.hidden.emplace(&expression, active_path == nullptr ? path : *active_path);
    const int at = add(kind_of(expression), expression, active_path == nullptr ? path : *active_path, on);
    walk_inputs(expression, path, on, at);
    if (active_path != nullptr) {
      const Driver active = walk(*expression.active, {*active_path, "active", false}, on);
      GraphInput input;
      input.port = "active";
      input.role = Role::kActive;
      input.written = expression.active;
      add_input(on, at, std::move(input), active);
    }
    return {at, true};
  }

  static Kind kind_of(const Expression& expression) {
    const auto& what = expression.what;
    if (std::holds_alternative<cdl::Cooperate>(what)) return Kind::kCooperate;
    if (std::holds_alternative<cdl::Compete>(what)) return Kind::kCompete;
    if (std::holds_alternative<cdl::Coordinate>(what)) return Kind::kCoordinate;
    if (std::holds_alternative<cdl::Fuse>(what)) return Kind::kFuse;
    if (std::holds_alternative<cdl::Sequence>(what)) return Kind::kSequence;
    if (std::holds_alternative<cdl::Select>(what)) return Kind::kSelect;
    if (std::holds_alternative<cdl::Logic>(what)) return Kind::kLogic;
    if (std::holds_alternative<cdl::Delay>(what)) return Kind::kDelay;
    return Kind::kCall;
  }

  void walk_inputs(const Expression& expression, const std::string& path, int on, int at) {
    const auto& what = expression.what;
    if (const auto* call = std::get_if<cdl::Call>(&what)) {
      walk_arguments(*call, path, on, at, false);
    } else if (const auto* cooperate = std::get_if<cdl::Cooperate>(&what)) {
      walk_members(cooperate->members, "gain", path, on, at);
    } else if (const auto* compete = std::get_if<cdl::Compete>(&what)) {
      walk_members(compete->members, "activation", path, on, at);
    } else if (const auto* coordinate = std::get_if<cdl::Coordinate>(&what)) {
      walk_members(coordinate->members, "weight", path, on, at);
      walk_arguments(coordinate->by, path, on, at, true);
    } else if (const auto* fuse = std::get_if<cdl::Fuse>(&what)) {
      walk_members(fuse->members, "weight", path, on, at);
      walk_arguments(fuse->by, path, on, at, true);
    } else if (const auto* sequence = std::get_if<cdl::Sequence>(&what)) {
      const int inner = new_page(path, std::max(on, 0));
      if (on != kHidden && at >= 0) node(on, at).inner = inner;
      walk_states(*sequence, path, inner);
    } else if (const auto* select = std::get_if<cdl::Select>(&what)) {
      walk_select(*select, path, on, at);
    } else if (const auto* logic = std::get_if<cdl::Logic>(&what)) {
      walk_logic(*logic, path, on, at);
    } else if (const auto* delay = std::get_if<cdl::Delay>(&what)) {
      put(on, at, {"value", {}, Role::kDelayed, delay->value}, {path, "value", false});
      put(on, at, {"initial", {}, Role::kInitial, delay->initial}, {path, "initial", false});
    }
  }

  void put(int on, int at, GraphInput input, const Slot& slot) {
    const Driver driver = input.written ? walk(*input.written, slot, on) : Driver{};
    add_input(on, at, std::move(input), driver);
  }

  void put_open(int on, int at, const std::string& port, Role role) {
    GraphInput open;
    open.port = port;
    open.role = role;
    open.is_open = true;
    add_input(on, at, std::move(open), {});
  }

  void walk_members(const std::vector<cdl::Member>& members, const char* weight, const std::string& path,
                    int on, int at) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      const auto index = static_cast<std::uint32_t>(i);
      const int where = static_cast<int>(i);
      put(on, at, {"members", index, Role::kMember, members[i].value, -1, false, where}, {path, "", false});
      put(on, at, {"weight", index, Role::kWeight, members[i].weight, -1, false, where},
          {path, weight, false});
    }
    put_open(on, at, "members", Role::kMember);
  }

  void walk_logic(const cdl::Logic& logic, const std::string& path, int on, int at) {
    const bool is_not = logic.connective == cdl::Connective::kNot;
    for (std::size_t i = 0; i < logic.operands.size(); ++i) {
      GraphInput input{"in", {}, Role::kOperand, logic.operands[i], -1, false, static_cast<int>(i)};
      if (!is_not) input.index = static_cast<std::uint32_t>(i);
      put(on, at, std::move(input), {path, "", false});
    }
    if (is_not) return;
    for (std::size_t i = 2; i < logic.operands.size(); ++i)
      claim_path(path + (logic.connective == cdl::Connective::kAnd ? ".And" : ".Or"));
    put_open(on, at, "in", Role::kOperand);
  }

  void walk_select(const cdl::Select& select, const std::string& path, int on, int at) {
    put(on, at, {"by", {}, Role::kSelector, select.by}, {path, "by", false});
    for (std::size_t i = 0; i < select.cases.size(); ++i) {
      std::string name =
          select.cases[i].values.empty() ? "otherwise" : "case_" + select.cases[i].values.front().text;
      std::ranges::replace(name, '-', '_');
      put(on, at,
          {"case", static_cast<std::uint32_t>(i), Role::kCase, select.cases[i].member, -1, false,
           static_cast<int>(i)},
          {path, name, false});
    }
  }

  // A list written as an argument whose items are not all constants: each is an input.
  bool is_spread(const cdl::Argument& argument, const Socket* socket) const {
    const auto* list = std::get_if<cdl::List>(&argument.value->what);
    if (list == nullptr) return false;
    if (socket != nullptr && socket->is_list) return true;
    return std::ranges::any_of(list->items, [&](const cdl::ExpressionPtr& item) {
      return !default_name(*item).empty() || is_known(*item);
    });
  }

  bool is_known(const Expression& expression) const {
    const auto* name = std::get_if<cdl::Name>(&expression.what);
    if (name == nullptr) return false;
    const auto is_it = [&](const auto& one) { return one.name.text == name->name.text; };
    return std::ranges::any_of(graph_.lets(), is_it) || std::ranges::any_of(graph_.parameters(), is_it);
  }

  void walk_arguments(const cdl::Call& call, const std::string& path, int on, int at, bool is_operator) {
    const std::optional<Callable>& component = components_.find(call.callee.text);
    std::vector<Socket> sockets;
    int lists = 0;
    static const std::vector<Socket> kNone;
    for (const Socket& socket : component ? component->inputs : kNone) {
      const bool is_members = is_operator && socket.is_list && lists++ < 2;
      if (!is_members) sockets.push_back(socket);
    }
    // Inputs in the order of the declaration, names in the order of the text.
    std::vector<std::vector<std::pair<GraphInput, Driver>>> inputs(sockets.size());
    std::vector<std::pair<GraphInput, Driver>> others;
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
      const cdl::Argument& argument = call.arguments[i];
      std::size_t which = std::min(i, sockets.size());
      if (!argument.name.text.empty()) {
        const auto found = std::ranges::find(sockets, argument.name.text, &Socket::name);
        which = static_cast<std::size_t>(found - sockets.begin());
      }
      const bool is_other = which >= sockets.size() || !inputs[which].empty();
      const Socket* socket = is_other ? nullptr : &sockets[which];
      auto& into = is_other ? others : inputs[which];
      GraphInput input;
      input.port = socket != nullptr            ? socket->name
                   : argument.name.text.empty() ? fmt::format("argument {}", i + 1)
                                                : argument.name.text;
      input.at = static_cast<int>(i);
      if (is_spread(argument, socket)) {
        const auto& items = std::get<cdl::List>(argument.value->what).items;
        for (std::size_t k = 0; k < items.size(); ++k) {
          input.index = static_cast<std::uint32_t>(k);
          input.item = static_cast<int>(k);
          input.written = items[k];
          into.emplace_back(input, walk(*items[k], {path, "", false}, on));
        }
      } else {
        if (socket != nullptr && socket->is_list) input.index = 0;
        input.written = argument.value;
        into.emplace_back(input, walk(*argument.value, {path, "", false}, on));
      }
    }
    for (std::size_t i = 0; i < sockets.size(); ++i) {
      for (auto& [input, driver] : inputs[i]) add_input(on, at, std::move(input), driver);
      if (sockets[i].is_list)
        put_open(on, at, sockets[i].name, Role::kArgument);
      else if (inputs[i].empty())
        add_input(on, at, {sockets[i].name, {}, Role::kArgument, nullptr}, {});
    }
    for (auto& [input, driver] : others) add_input(on, at, std::move(input), driver);
  }

  Driver walk_name(const cdl::Name& name, int on) {
    for (const cdl::Let& let : graph_.lets()) {
      if (let.name.text != name.name.text) continue;
      walk_let(let);
      if (on == kHidden) return {};
      if (on != 0) return {outer_node(let, on), false};
      const auto found = let_nodes_.find(&let);
      return {found == let_nodes_.end() ? -1 : found->second, false};
    }
    for (const cdl::Parameter& parameter : graph_.parameters()) {
      if (parameter.name.text == name.name.text && is_wired(components_.types().of(parameter)))
        return {parameter_node(parameter, on), false};
    }
    return {};
  }

  void walk_let(const cdl::Let& let) {
    if (!walked_.insert(&let).second) return;
    const std::string path = claim({"", let.name.text, false}, "");
    const cdl::Let* outer = std::exchange(pending_, &let);
    if (default_name(*let.value).empty()) {  // a constant, or another name for something
      const int at = add(Kind::kValue, *let.value, path, 0);
      pending_ = nullptr;
      put(0, at, {"value", {}, Role::kValue, let.value}, {path, "", true});
    } else {
      walk(*let.value, {path, "", true}, 0);
    }
    pending_ = outer;
  }

  // ---- pages

  // What a page gives: the states of a sequence, or a dataflow.
  void walk_page(const Expression& root, int on) {
    page(on).root = &root;
    const std::string base = page(on).base;
    const auto* sequence = std::get_if<cdl::Sequence>(&root.what);
    if (sequence != nullptr && root.as.text.empty() && !root.active) {
      walk_states(*sequence, base, on);
      return;
    }
    page(on).result = walk(root, {base, "", true}, on).node;
  }

  void walk_states(const cdl::Sequence& sequence, const std::string& path, int on) {
    page(on).sequence = &sequence;
    for (const cdl::State& state : sequence.states) {
      const std::string name = path.empty() ? state.name.text : path + "." + state.name.text;
      const std::string own = claim_path(name);
      const int inner = new_page(own, on);
      page(inner).state = &state;
      page(on).states.push_back(inner);
      if (state.member) walk_page(*state.member, inner);
      for (const cdl::Transition& transition : state.transitions) {
        if (transition.trigger) walk(condition_of(*transition.trigger), {own, "", false}, kHidden);
      }
    }
  }

  void walk_drive(const cdl::Drive& drive) {
    GraphNode actuator;
    actuator.kind = Kind::kActuator;
    actuator.name = "$" + drive.binding.text;
    actuator.drive = &drive;
    const int at = static_cast<int>(page(0).nodes.size());
    page(0).nodes.push_back(std::move(actuator));
    put(0, at, {"v", {}, Role::kDrive, drive.value}, {"", drive.binding.text, false});
  }

  // `let`s that stand on an inner page because somebody put them there.
  void show_outer() {
    for (const auto& [path, name] : shown_) {
      const int on = graph_.find_page(path);
      if (on <= 0) continue;
      for (const cdl::Let& let : graph_.lets()) {
        if (let.name.text == name && page(on).find(name) < 0) outer_node(let, on);
      }
    }
  }

  // The node that gives the page's value has the page's own path: it is called as what it is.
  static void name_result(GraphPage& page) {
    for (GraphNode& one : page.nodes) {
      if (!one.name.empty()) continue;
      const std::string wanted = default_name(*one.expression);
      one.name = wanted;
      const auto is_other = [&](const GraphNode& other) { return &other != &one && other.name == one.name; };
      for (int number = 0; std::ranges::any_of(page.nodes, is_other); ++number)
        one.name = fmt::format("{}_{}", wanted, number);
    }
  }

  OwnerGraph& graph_;
  const Components& components_;
  const std::multimap<std::string, std::string>& shown_;
  std::map<std::string, int, std::less<>> claimed_;
  std::set<const cdl::Let*> walked_;
  std::map<const cdl::Let*, int> let_nodes_;
  std::map<std::pair<int, const cdl::Let*>, int> outer_nodes_;
  std::map<std::pair<int, const cdl::Parameter*>, int> parameter_nodes_;
  const cdl::Let* pending_ = nullptr;  // whose node comes next
};

}  // namespace

int GraphPage::find(std::string_view name) const {
  const auto found = std::ranges::find(nodes, name, &GraphNode::name);
  return found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
}

int OwnerGraph::find_page(std::string_view path) const {
  const auto found = std::ranges::find(pages, path, &GraphPage::path);
  return found == pages.end() ? -1 : static_cast<int>(found - pages.begin());
}

OwnerGraph graph_of(const cdl::Assemblage& assemblage, const Components& components,
                    const std::multimap<std::string, std::string>& shown) {
  OwnerGraph out;
  out.name = assemblage.name.text;
  out.assemblage = &assemblage;
  out.scope = Components::scope_of(assemblage);
  Builder(out, components, shown).run();
  return out;
}

OwnerGraph graph_of(const cdl::Robot& robot, const Components& components,
                    const std::multimap<std::string, std::string>& shown) {
  OwnerGraph out;
  out.name = robot.name.text;
  out.robot = &robot;
  out.scope = Components::scope_of(robot);
  Builder(out, components, shown).run();
  return out;
}

const cdl::Expression& condition_of(const cdl::Expression& trigger) {
  const auto* logic = std::get_if<cdl::Logic>(&trigger.what);
  const bool is_negated = logic != nullptr && logic->connective == cdl::Connective::kNot &&
                          trigger.as.text.empty() && !trigger.active;
  return is_negated ? *logic->operands.front() : trigger;
}

std::string default_name(const cdl::Expression& expression) {
  const auto& what = expression.what;
  if (const auto* call = std::get_if<cdl::Call>(&what)) return call->callee.text;
  if (std::holds_alternative<cdl::Cooperate>(what)) return "cooperate";
  if (std::holds_alternative<cdl::Compete>(what)) return "compete";
  if (const auto* coordinate = std::get_if<cdl::Coordinate>(&what)) return coordinate->by.callee.text;
  if (const auto* fuse = std::get_if<cdl::Fuse>(&what)) return fuse->by.callee.text;
  if (std::holds_alternative<cdl::Sequence>(what)) return "sequence";
  if (std::holds_alternative<cdl::Select>(what)) return "select";
  if (std::holds_alternative<cdl::Delay>(what)) return "delay";
  const auto* logic = std::get_if<cdl::Logic>(&what);
  if (logic == nullptr) return "";
  return logic->connective == cdl::Connective::kNot   ? "Not"
         : logic->connective == cdl::Connective::kAnd ? "And"
                                                      : "Or";
}

namespace {

// Calls `visit` with every name in an expression of the owner.
void for_each_use(const OwnerGraph& graph, const auto& visit) {
  const auto look = [&](const cdl::ExpressionPtr& expression) {
    if (!expression) return;
    cdl::for_each_expression(*expression, [&](const Expression& one) {
      if (const auto* name = std::get_if<cdl::Name>(&one.what)) visit(name->name.text);
    });
  };
  for (const cdl::Let& let : graph.lets()) look(let.value);
  for (const cdl::Parameter& parameter : graph.parameters()) look(parameter.initial);
  if (graph.assemblage != nullptr) look(graph.assemblage->body);
  if (graph.robot != nullptr) {
    for (const cdl::Drive& drive : graph.robot->drives) look(drive.value);
  }
}

}  // namespace

int count_uses(const OwnerGraph& graph, std::string_view name) {
  int out = 0;
  for_each_use(graph, [&](const std::string& used) { out += used == name ? 1 : 0; });
  return out;
}

std::set<std::string, std::less<>> names_used(const OwnerGraph& graph) {
  std::set<std::string, std::less<>> out;
  for_each_use(graph, [&](const std::string& used) { out.insert(used); });
  return out;
}

}  // namespace mlab::designer
