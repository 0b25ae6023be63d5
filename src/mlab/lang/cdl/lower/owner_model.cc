#include "mlab/lang/cdl/lower/owner_model.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/lower/naming.h"
#include "mlab/lang/cdl/syntax/walk.h"

namespace mlab::cdl {
namespace {

using Kind = ModelNode::Kind;
using Role = InputRole;

// What drives an input.
struct Driver {
  int node = -1;
  bool is_inline = false;
};

constexpr int kHidden = -1;  // the page of what is not drawn: triggers

class Builder {
 public:
  Builder(OwnerModel& model, const NodeNames& names, const std::multimap<std::string, std::string>& shown)
      : model_(model), types_(model.elaboration->types()), names_(names), shown_(shown) {
    for (const Let& let : model.lets()) let_named_.emplace(let.name.text, &let);
  }

  void run() {
    new_page("", -1);
    for (const Parameter& parameter : model_.parameters()) {
      if (is_wired(types_.of(parameter))) parameter_node(parameter, 0);
    }
    if (model_.robot != nullptr) {
      for (const Drive& drive : model_.robot->drives) walk_drive(drive);
    } else if (model_.assemblage->body) {
      walk_page(model_.assemblage->body, 0);
    }
    for (const Let& let : model_.lets()) walk_let(let);
    show_outer();
    for (ModelPage& page : model_.pages) name_result(page);
  }

  void run_trigger(const ModelPage& states, const Transition& transition, const std::string& path) {
    new_page("", -1);
    const int on = new_page(states.base, 0);
    page(on).path = path;
    page(on).asks = &transition;
    page(on).root = page_root_ = transition.trigger.get();
    page(on).result = walk(transition.trigger, on).node;
    std::swap(page(on), model_.pages.back());  // `let`s may have made pages behind it
    name_result(model_.pages.back());
  }

 private:
  ModelPage& page(int at) { return model_.pages[static_cast<std::size_t>(at)]; }
  ModelNode& node(int on, int at) { return page(on).nodes[static_cast<std::size_t>(at)]; }

  int new_page(const std::string& base, int parent) {
    ModelPage out;
    out.base = base;
    out.path = base.empty() ? model_.name : model_.name + "." + base;
    out.parent = parent;
    model_.pages.push_back(std::move(out));
    return static_cast<int>(model_.pages.size()) - 1;
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
    ModelNode out;
    out.kind = kind;
    out.expression = &expression;
    out.path = path;
    out.name = name_on(on, path);
    const int at = static_cast<int>(page(on).nodes.size());
    if (const Let* let = std::exchange(pending_, nullptr)) {
      out.let = let;
      let_nodes_[let] = at;
    }
    page(on).nodes.push_back(std::move(out));
    return at;
  }

  int parameter_node(const Parameter& parameter, int on) {
    if (on == kHidden) return -1;
    const auto [found, is_new] = parameter_nodes_.try_emplace({on, &parameter}, 0);
    if (is_new) {
      ModelNode out;
      out.kind = Kind::kParameter;
      out.parameter = &parameter;
      out.name = parameter.name.text;
      found->second = static_cast<int>(page(on).nodes.size());
      page(on).nodes.push_back(std::move(out));
    }
    return found->second;
  }

  int outer_node(const Let& let, int on) {
    if (on == kHidden) return -1;
    const auto [found, is_new] = outer_nodes_.try_emplace({on, &let}, 0);
    if (is_new) {
      ModelNode out;
      out.kind = Kind::kOuter;
      out.let = &let;
      out.name = let.name.text;
      found->second = static_cast<int>(page(on).nodes.size());
      page(on).nodes.push_back(std::move(out));
    }
    return found->second;
  }

  void add_input(int on, int to, ModelInput input, const Driver& driver) {
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

  Driver walk(const ExpressionPtr& expression, int on) {
    if (!expression || depth_ > kDeepestExpression) return {};
    ++depth_;
    const ExpressionPtr outer = std::exchange(formula_, expression);
    const Driver out = walk_what(*expression, on);
    formula_ = outer;
    --depth_;
    return out;
  }

  Driver walk_what(const Expression& expression, int on) {
    const auto& what = expression.what;
    if (const auto* name = std::get_if<Name>(&what)) return walk_name(*name, on);
    if (const auto* list = std::get_if<List>(&what)) {
      for (const ExpressionPtr& item : list->items) walk(item, kHidden);
      return {};
    }
    if (default_name(expression).empty() || is_field(expression, on)) return {};
    const NodeNames::Paths& paths = names_.of(expression);
    if (on == kHidden) model_.hidden.emplace(&expression, paths.path);
    const bool is_formula = std::holds_alternative<Arithmetic>(expression.what) || is_whole_call(expression);
    const int at = add(is_formula ? Kind::kFormula : kind_of(expression), expression, paths.path, on);
    if (is_formula) {
      walk_formula(expression, on, at);
    } else {
      walk_inputs(expression, paths.inside, on, at);
    }
    if (expression.active) put(on, at, {"active", {}, Role::kActive, expression.active});
    return {at, true};
  }

  static Kind kind_of(const Expression& expression) {
    const auto& what = expression.what;
    if (std::holds_alternative<Cooperate>(what)) return Kind::kCooperate;
    if (std::holds_alternative<Compete>(what)) return Kind::kCompete;
    if (std::holds_alternative<Coordinate>(what)) return Kind::kCoordinate;
    if (std::holds_alternative<Fuse>(what)) return Kind::kFuse;
    if (std::holds_alternative<Sequence>(what)) return Kind::kSequence;
    if (std::holds_alternative<Select>(what)) return Kind::kSelect;
    if (std::holds_alternative<Logic>(what)) return Kind::kLogic;
    if (std::holds_alternative<Delay>(what)) return Kind::kDelay;
    return Kind::kCall;
  }

  void walk_inputs(const Expression& expression, const std::string& path, int on, int at) {
    const auto& what = expression.what;
    if (const auto* call = std::get_if<Call>(&what)) {
      walk_arguments(*call, on, at, false);
    } else if (const auto* cooperate = std::get_if<Cooperate>(&what)) {
      walk_members(cooperate->members, on, at);
    } else if (const auto* compete = std::get_if<Compete>(&what)) {
      walk_members(compete->members, on, at);
    } else if (const auto* coordinate = std::get_if<Coordinate>(&what)) {
      walk_members(coordinate->members, on, at);
      walk_arguments(coordinate->by, on, at, true);
    } else if (const auto* fuse = std::get_if<Fuse>(&what)) {
      walk_members(fuse->members, on, at);
      walk_arguments(fuse->by, on, at, true);
    } else if (const auto* sequence = std::get_if<Sequence>(&what)) {
      const int inner = new_page(path, std::max(on, 0));
      if (on != kHidden && at >= 0) node(on, at).inner = inner;
      walk_states(*sequence, inner);
    } else if (const auto* select = std::get_if<Select>(&what)) {
      walk_select(*select, on, at);
    } else if (const auto* logic = std::get_if<Logic>(&what)) {
      walk_logic(*logic, on, at);
    } else if (const auto* delay = std::get_if<Delay>(&what)) {
      put(on, at, {"value", {}, Role::kDelayed, delay->value});
      put(on, at, {"initial", {}, Role::kInitial, delay->initial});
    }
  }

  void put(int on, int at, ModelInput input) {
    const Driver driver = walk(input.written, on);
    add_input(on, at, std::move(input), driver);
  }

  void put_open(int on, int at, const std::string& port, Role role) {
    ModelInput open;
    open.port = port;
    open.role = role;
    open.is_open = true;
    add_input(on, at, std::move(open), {});
  }

  void walk_members(const std::vector<Member>& members, int on, int at) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      const auto index = static_cast<std::uint32_t>(i);
      const int where = static_cast<int>(i);
      put(on, at, {"members", index, Role::kMember, members[i].value, -1, false, where});
      put(on, at, {"weight", index, Role::kWeight, members[i].weight, -1, false, where});
    }
    put_open(on, at, "members", Role::kMember);
  }

  void walk_logic(const Logic& logic, int on, int at) {
    const bool is_not = logic.connective == Connective::kNot;
    for (std::size_t i = 0; i < logic.operands.size(); ++i) {
      ModelInput input{"in", {}, Role::kOperand, logic.operands[i], -1, false, static_cast<int>(i)};
      if (!is_not) input.index = static_cast<std::uint32_t>(i);
      put(on, at, std::move(input));
    }
    if (!is_not) put_open(on, at, "in", Role::kOperand);
  }

  const Function* function_of(const Expression& expression) const {
    const auto* call = std::get_if<Call>(&expression.what);
    return call == nullptr ? nullptr : types_.function(call->callee);
  }

  // A call of a function that has all that it takes; while something is missing, its inputs are drawn.
  bool is_whole_call(const Expression& expression) const {
    const Function* function = function_of(expression);
    return function != nullptr && std::get<Call>(expression.what).arguments.size() == function->inputs.size();
  }

  // What is computed of numbers, words and parameters that are no wires is written into a field.
  bool is_field(const Expression& expression, int on) const {
    const bool is_computed =
        std::holds_alternative<Arithmetic>(expression.what) || function_of(expression) != nullptr;
    return is_computed && on != kHidden && page_root_ != &expression && reads_nothing(expression);
  }

  bool reads_nothing(const Expression& expression) const {
    if (const auto* name = std::get_if<Name>(&expression.what)) {
      const bool is_wire = let_named_.contains(name->name.text) ||
                           std::ranges::any_of(model_.parameters(), [&](const Parameter& parameter) {
                             return parameter.name.text == name->name.text && is_wired(types_.of(parameter));
                           });
      return !is_wire;
    }
    if (expression.active || !expression.as.text.empty()) return false;
    const bool is_transparent = default_name(expression).empty() ||
                                std::holds_alternative<Arithmetic>(expression.what) ||
                                function_of(expression) != nullptr;
    bool out = is_transparent;
    for_each_part(expression, [&](const Expression& part) { out = out && reads_nothing(part); });
    return out;
  }

  // Its words are one field; what it reads comes on wires.
  void walk_formula(const Expression& expression, int on, int at) {
    ModelInput words;
    words.port = "formula";
    words.role = Role::kFormula;
    words.written = formula_;
    add_input(on, at, std::move(words), {});
    std::map<std::string, int> times;
    int number = 0;
    for (const ExpressionPtr& term : terms_of(expression)) {
      ModelInput input;
      const auto* name = std::get_if<Name>(&term->what);
      input.port = name != nullptr         ? name->name.text
                   : term->as.text.empty() ? default_name(*term)
                                           : term->as.text;
      if (const int time = ++times[input.port]; time > 1) input.port += fmt::format("_{}", time);
      input.role = Role::kTerm;
      input.written = term;
      input.at = number++;
      put(on, at, std::move(input));
    }
  }

  std::vector<ExpressionPtr> terms_of(const Expression& formula) const {
    std::vector<ExpressionPtr> out;
    const auto add = [&](const ExpressionPtr& part) {
      if (!part || reads_nothing(*part)) return;
      const bool is_inside = part->as.text.empty() && !part->active &&
                             (std::holds_alternative<Arithmetic>(part->what) ||
                              std::holds_alternative<List>(part->what) || function_of(*part) != nullptr);
      if (!is_inside) {
        out.push_back(part);
        return;
      }
      for (ExpressionPtr& inner : terms_of(*part)) out.push_back(std::move(inner));
    };
    if (const auto* arithmetic = std::get_if<Arithmetic>(&formula.what)) {
      for (const ExpressionPtr& operand : arithmetic->operands) add(operand);
    } else if (const auto* list = std::get_if<List>(&formula.what)) {
      for (const ExpressionPtr& item : list->items) add(item);
    } else if (const auto* call = std::get_if<Call>(&formula.what)) {
      for (const Argument& argument : call->arguments) add(argument.value);
    }
    return out;
  }

  void walk_select(const Select& select, int on, int at) {
    put(on, at, {"by", {}, Role::kSelector, select.by});
    for (std::size_t i = 0; i < select.cases.size(); ++i) {
      const auto index = static_cast<std::uint32_t>(i);
      put(on, at, {"case", index, Role::kCase, select.cases[i].member, -1, false, static_cast<int>(i)});
    }
  }

  // A list written as an argument whose items are not all constants: each is an input.
  bool is_spread(const Argument& argument, const InputView* view) const {
    const auto* list = std::get_if<List>(&argument.value->what);
    if (list == nullptr) return false;
    if (view != nullptr && view->is_list()) return true;
    return std::ranges::any_of(list->items, [&](const ExpressionPtr& item) {
      return !default_name(*item).empty() || is_known(*item);
    });
  }

  bool is_known(const Expression& expression) const {
    const auto* name = std::get_if<Name>(&expression.what);
    if (name == nullptr) return false;
    const auto is_it = [&](const auto& one) { return one.name.text == name->name.text; };
    return std::ranges::any_of(model_.lets(), is_it) || std::ranges::any_of(model_.parameters(), is_it);
  }

  // The inputs that arguments are for: of an operator not its members and their weights.
  std::vector<InputView> views_of(const Call& call, bool is_operator) const {
    std::vector<InputView> out = types_.inputs_of(call.callee);
    int lists = 0;
    if (is_operator) std::erase_if(out, [&](const InputView& view) { return view.is_list() && lists++ < 2; });
    return out;
  }

  // Inputs in the order of the declaration, and behind them what fits none.
  void walk_arguments(const Call& call, int on, int at, bool is_operator) {
    const std::vector<InputView> views = views_of(call, is_operator);
    std::vector<std::vector<std::pair<ModelInput, Driver>>> inputs(views.size());
    std::vector<std::pair<ModelInput, Driver>> others;
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
      const std::string& name = call.arguments[i].name.text;
      std::size_t which = std::min(i, views.size());
      if (!name.empty())
        which = static_cast<std::size_t>(std::ranges::find(views, name, &InputView::name) - views.begin());
      const bool is_other = which >= views.size() || !inputs[which].empty();
      walk_argument(call, i, is_other ? nullptr : &views[which], on, is_other ? others : inputs[which]);
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
      for (auto& [input, driver] : inputs[i]) add_input(on, at, std::move(input), driver);
      if (views[i].is_list())
        put_open(on, at, views[i].name, Role::kArgument);
      else if (inputs[i].empty())
        add_input(on, at, {views[i].name, {}, Role::kArgument, nullptr}, {});
    }
    for (auto& [input, driver] : others) add_input(on, at, std::move(input), driver);
  }

  // @param view  null: the callee has no such input, or it has been given
  void walk_argument(const Call& call, std::size_t i, const InputView* view, int on,
                     std::vector<std::pair<ModelInput, Driver>>& into) {
    const Argument& argument = call.arguments[i];
    ModelInput input;
    input.port = view != nullptr              ? view->name
                 : argument.name.text.empty() ? fmt::format("argument {}", i + 1)
                                              : argument.name.text;
    input.at = static_cast<int>(i);
    if (!is_spread(argument, view)) {
      if (view != nullptr && view->is_list()) input.index = 0;
      input.written = argument.value;
      into.emplace_back(input, walk(argument.value, on));
      return;
    }
    const auto& items = std::get<List>(argument.value->what).items;
    for (std::size_t k = 0; k < items.size(); ++k) {
      input.index = static_cast<std::uint32_t>(k);
      input.item = static_cast<int>(k);
      input.written = items[k];
      into.emplace_back(input, walk(items[k], on));
    }
  }

  Driver walk_name(const Name& name, int on) {
    if (const auto named = let_named_.find(name.name.text); named != let_named_.end()) {
      const Let& let = *named->second;
      walk_let(let);
      if (on == kHidden) return {};
      if (on != 0) return {outer_node(let, on), false};
      const auto found = let_nodes_.find(&let);
      return {found == let_nodes_.end() ? -1 : found->second, false};
    }
    for (const Parameter& parameter : model_.parameters()) {
      if (parameter.name.text == name.name.text && is_wired(types_.of(parameter)))
        return {parameter_node(parameter, on), false};
    }
    return {};
  }

  void walk_let(const Let& let) {
    if (depth_ > kDeepestExpression || !walked_.insert(&let).second) return;
    const Let* outer = std::exchange(pending_, &let);
    if (default_name(*let.value).empty() ||
        is_field(*let.value, 0)) {  // a constant, or another name for something
      const int at = add(Kind::kValue, *let.value, names_.of(let), 0);
      pending_ = nullptr;
      put(0, at, {"value", {}, Role::kValue, let.value});
    } else {
      walk(let.value, 0);
    }
    pending_ = outer;
  }

  // ---- pages

  // What a page gives: the states of a sequence, or a dataflow.
  void walk_page(const ExpressionPtr& root, int on) {
    page(on).root = page_root_ = root.get();
    const auto* sequence = std::get_if<Sequence>(&root->what);
    if (sequence != nullptr && root->as.text.empty() && !root->active)
      walk_states(*sequence, on);
    else
      page(on).result = walk(root, on).node;
  }

  void walk_states(const Sequence& sequence, int on) {
    page(on).sequence = &sequence;
    for (const State& state : sequence.states) {
      const int inner = new_page(names_.of(state), on);
      page(inner).state = &state;
      page(on).states.push_back(inner);
      if (state.member) walk_page(state.member, inner);
      for (const Transition& transition : state.transitions) {
        if (transition.trigger) walk_what(condition_of(*transition.trigger), kHidden);
      }
    }
  }

  void walk_drive(const Drive& drive) {
    ModelNode actuator;
    actuator.kind = Kind::kActuator;
    actuator.name = "$" + drive.binding.text;
    actuator.drive = &drive;
    const int at = static_cast<int>(page(0).nodes.size());
    page(0).nodes.push_back(std::move(actuator));
    put(0, at, {"v", {}, Role::kDrive, drive.value});
  }

  // `let`s that stand on an inner page because somebody put them there.
  void show_outer() {
    for (const auto& [path, name] : shown_) {
      const int on = model_.find_page(path);
      if (on <= 0) continue;
      for (const Let& let : model_.lets()) {
        if (let.name.text == name && page(on).find(name) < 0) outer_node(let, on);
      }
    }
  }

  // The node that gives the page's value has the page's own path: it is called as what it is.
  static void name_result(ModelPage& page) {
    for (ModelNode& one : page.nodes) {
      if (!one.name.empty()) continue;
      const std::string wanted = default_name(*one.expression);
      one.name = wanted;
      const auto is_other = [&](const ModelNode& other) { return &other != &one && other.name == one.name; };
      for (int number = 0; std::ranges::any_of(page.nodes, is_other); ++number)
        one.name = fmt::format("{}_{}", wanted, number);
    }
  }

  OwnerModel& model_;
  const Types& types_;
  const NodeNames& names_;
  const std::multimap<std::string, std::string>& shown_;
  std::unordered_map<std::string_view, const Let*> let_named_;
  std::set<const Let*> walked_;
  std::map<const Let*, int> let_nodes_;
  std::map<std::pair<int, const Let*>, int> outer_nodes_;
  std::map<std::pair<int, const Parameter*>, int> parameter_nodes_;
  const Expression* page_root_ = nullptr;  // has a node whatever it is
  ExpressionPtr formula_;                  // that is being walked
  const Let* pending_ = nullptr;           // whose node comes next
  int depth_ = 0;
};

}  // namespace

int ModelPage::find(std::string_view name) const {
  const auto found = std::ranges::find(nodes, name, &ModelNode::name);
  return found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
}

const std::vector<Let>& OwnerModel::lets() const {
  return assemblage != nullptr ? assemblage->lets : robot->lets;
}

const std::vector<Parameter>& OwnerModel::parameters() const {
  return assemblage != nullptr ? assemblage->parameters : robot->parameters;
}

int OwnerModel::find_page(std::string_view path) const {
  const auto found = std::ranges::find(pages, path, &ModelPage::path);
  return found == pages.end() ? -1 : static_cast<int>(found - pages.begin());
}

PortType OwnerModel::type_of(const Expression& expression) const {
  if (std::holds_alternative<Number>(expression.what)) return {};
  const Types& types = elaboration->types();
  return types.of(expression, types.names_of(parameters(), lets()));
}

PortType OwnerModel::type_of(const ModelNode& node) const {
  if (node.parameter != nullptr) return elaboration->types().of(*node.parameter);
  if (node.kind == Kind::kOuter) return type_of(*node.let->value);
  return node.expression == nullptr ? PortType{} : type_of(*node.expression);
}

OwnerModel model_of(const Assemblage& assemblage, const Elaboration& elaboration,
                    const std::multimap<std::string, std::string>& shown) {
  OwnerModel out{assemblage.name.text, &assemblage, nullptr, &elaboration, {}, {}};
  Builder(out, elaboration.names(assemblage), shown).run();
  return out;
}

OwnerModel model_of(const Robot& robot, const Elaboration& elaboration,
                    const std::multimap<std::string, std::string>& shown) {
  OwnerModel out{robot.name.text, nullptr, &robot, &elaboration, {}, {}};
  Builder(out, elaboration.names(robot), shown).run();
  return out;
}

OwnerModel trigger_model(const OwnerModel& owner, const ModelPage& states, const Transition& transition,
                         const std::string& path) {
  OwnerModel out{owner.name, owner.assemblage, owner.robot, owner.elaboration, {}, {}};
  const NodeNames& names = owner.assemblage != nullptr ? owner.elaboration->names(*owner.assemblage)
                                                       : owner.elaboration->names(*owner.robot);
  const std::multimap<std::string, std::string> nothing_more;
  Builder(out, names, nothing_more).run_trigger(states, transition, path);
  return out;
}

namespace {

// Calls `visit` with every name in an expression of the owner.
void for_each_use(const OwnerModel& model, const auto& visit) {
  const auto look = [&](const ExpressionPtr& expression) {
    if (!expression) return;
    for_each_expression(*expression, [&](const Expression& one) {
      if (const auto* name = std::get_if<Name>(&one.what)) visit(name->name.text);
    });
  };
  for (const Let& let : model.lets()) look(let.value);
  for (const Parameter& parameter : model.parameters()) look(parameter.initial);
  if (model.assemblage != nullptr) look(model.assemblage->body);
  if (model.robot != nullptr) {
    for (const Drive& drive : model.robot->drives) look(drive.value);
  }
}

}  // namespace

int count_uses(const OwnerModel& model, std::string_view name) {
  int out = 0;
  for_each_use(model, [&](const std::string& used) { out += used == name ? 1 : 0; });
  return out;
}

std::set<std::string, std::less<>> names_used(const OwnerModel& model) {
  std::set<std::string, std::less<>> out;
  for_each_use(model, [&](const std::string& used) { out.insert(used); });
  return out;
}

}  // namespace mlab::cdl
