#include "mlab/lang/cdl/lower/test_lowering.h"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <string_view>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/flow/port_types.h"
#include "mlab/lang/cdl/syntax/walk.h"
#include "mlab/lang/cdl/types/units.h"
#include "mlab/text/shown.h"

namespace mlab::cdl {
namespace {

constexpr std::string_view kUsualClass = "Scout";

// No name that anybody can write, so that it is in nobody's way.
std::string name_of_condition(std::size_t step) {
  return fmt::format("expect {}", step + 1);
}

// That a test may run: what is expected is looked at in the first cycle since something was given.
std::uint64_t most_cycles(const std::vector<LoweredStep>& steps) {
  std::uint64_t out = 0;
  bool is_looked_at = false;
  for (const LoweredStep& step : steps) {
    switch (step.written->kind) {
      case TestStep::Kind::kGiven:
      case TestStep::Kind::kGivenNo:
        is_looked_at = false;
        break;
      case TestStep::Kind::kAfter:
        out += step.cycles;
        is_looked_at = true;
        break;
      case TestStep::Kind::kExpect:
        out += step.cycles - (is_looked_at ? 1 : 0);
        is_looked_at = true;
        break;
    }
  }
  return out;
}

std::vector<std::string> percept_names() {
  std::vector<std::string> out;
  for (const TestPerceptInfo& one : kTestPercepts) out.emplace_back(one.name);
  return out;
}

}  // namespace

bool is_named_so(std::string_view path, std::string_view wanted) {
  if (path.size() == wanted.size()) return path == wanted;
  return path.size() > wanted.size() && path.ends_with(wanted) &&
         path[path.size() - wanted.size() - 1] == '.';
}

Word subject_name(const Test& test) {
  if (test.subject && !test.subject->as.text.empty()) return test.subject->as;
  return {"it", test.subject ? test.subject->place : test.name.place};
}

std::vector<const Test*> tests_of(const Tree& tree) {
  std::vector<const Test*> out;
  for (const Item& item : tree.items) {
    if (const auto* test = std::get_if<Test>(&item)) out.push_back(test);
  }
  return out;
}

Robot robot_of(const Test& test, const Configuration& configuration) {
  Robot out;
  out.name = test.name;
  out.class_name = test.class_name;
  if (out.class_name.text.empty() && configuration.classes.contains(kUsualClass))
    out.class_name = {std::string(kUsualClass), test.name.place};
  out.lets.push_back({subject_name(test), test.subject, "", {}});
  out.lets.insert(out.lets.end(), test.lets.begin(), test.lets.end());
  for (std::size_t i = 0; i < test.steps.size(); ++i) {
    const TestStep& step = test.steps[i];
    if (step.condition) out.lets.push_back({{name_of_condition(i), step.place}, step.condition, "", {}});
  }
  return out;
}

LoweredTest TestLowering::test(const Test& test, Scope& scope) {
  LoweredTest out;
  out.test = &test;
  const Value subject = parts_.values.value_of(scope.names[subject_name(test).text], scope);
  if (subject.kind == Value::Kind::kWire) out.subject = subject.text;
  if (subject.kind == Value::Kind::kWord || subject.kind == Value::Kind::kText)
    parts_.binder.bind(subject, parts_.types.named("Vector"), nullptr, "test", test.subject->place);
  std::set<std::string> awake = {subject.text};
  for (const TestStep& written : test.steps) {
    LoweredStep& step = out.steps.emplace_back();
    step.written = &written;
    step.number = out.steps.size() - 1;
    this->step(written, scope, step);
    if (step.condition.kind == flow::Source::Kind::kName) awake.insert(step.condition.text);
  }
  check_extent(test, out);
  for (const Let& let : test.lets) {
    const Value value = parts_.values.value_of(scope.names[let.name.text], scope);
    if (value.kind == Value::Kind::kWire) awake.insert(value.text);
  }
  keep_awake(awake);
  for (LoweredStep& step : out.steps) {
    if (!step.written->fact.text.empty()) fact(*step.written, step);
  }
  check_places(out);
  return out;
}

void TestLowering::step(const TestStep& step, Scope& scope, LoweredStep& out) {
  if (step.kind == TestStep::Kind::kGiven || step.kind == TestStep::Kind::kGivenNo) percept(step, scope, out);
  if (step.condition) condition(step, scope, out);
  const bool waits = step.kind == TestStep::Kind::kAfter || step.when != TestStep::When::kNow;
  if (waits) out.cycles = cycles_of(step);
}

void TestLowering::check_extent(const Test& test, const LoweredTest& lowered) {
  if (most_cycles(lowered.steps) > kMostTestCycles)
    parts_.findings.error("out-of-range", test.name.place,
                          fmt::format("a test runs at most {} cycles in all", kMostTestCycles));
  const bool expects = std::ranges::any_of(
      test.steps, [](const TestStep& step) { return step.kind == TestStep::Kind::kExpect; });
  if (!expects)
    parts_.findings.warning("expects-nothing", test.name.place, "this test expects nothing").label =
        "so it can't fail";
}

void TestLowering::percept(const TestStep& step, const Scope& around, LoweredStep& out) {
  const Word& name = step.percept.callee;
  out.percept = test_percept_named(name.text);
  if (out.percept == nullptr) {
    text::Diagnostic& d = parts_.findings.error(
        "unknown-percept", name.place, fmt::format("nothing is sensed as `{}`", text::shown(name.text)));
    Findings::hint_nearest(d, name.text, percept_names());
    if (d.hints.empty()) d.hints.push_back(fmt::format("there are {}", fmt::join(percept_names(), ", ")));
    return;
  }
  if (step.kind == TestStep::Kind::kGivenNo) return;
  Scope& scope = parts_.scopes.add();
  scope.nodes = &kUnnamed;
  const std::span<const TestInput> inputs = out.percept->inputs;
  out.values.resize(inputs.size());
  std::vector<std::string> names;
  for (const TestInput& input : inputs) names.emplace_back(input.name);
  const std::vector<GivenArgument> given = given_by(step.percept, scope);
  const std::vector<int> matched = parts_.arguments.match(name, given, names);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (matched[i] < 0) continue;
    const TestInput& input = inputs[static_cast<std::size_t>(matched[i])];
    if (may_be_sensed(given[i], input, around, out)) percept_value(given[i], input, out);
  }
  static const std::set<std::string_view> kMayLack = {"heading", "center", "leader", "neighbor"};
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const bool is_asked = std::ranges::find(matched, static_cast<int>(i)) != matched.end();
    if (is_asked || !inputs[i].initial.empty()) continue;
    if (std::ranges::find(matched, -1) != matched.end() || kMayLack.contains(inputs[i].name)) continue;
    parts_.arguments.say_missing(name, names[i], parts_.types.named(inputs[i].type),
                                 std::string(inputs[i].help));
  }
}

bool TestLowering::may_be_sensed(const GivenArgument& given, const TestInput& input, const Scope& around,
                                 const LoweredStep& step) {
  const Expression& value = *given.expression;
  const Name* computed = nullptr;
  for_each_expression(value, [&](const Expression& part) {
    const auto* name = std::get_if<Name>(&part.what);
    if (name != nullptr && computed == nullptr && around.names.contains(name->name.text)) computed = name;
  });
  if (computed != nullptr) {
    parts_.findings
        .error("wrong-type", computed->name.place,
               fmt::format("`{}` is computed by the test, and what is sensed is a constant",
                           text::shown(computed->name.text)))
        .hints = {fmt::format("write the value itself: `{} = ...`", input.name)};
    return false;
  }
  const auto* list = std::get_if<List>(&value.what);
  const bool is_of_lists = list != nullptr && std::ranges::any_of(list->items, [](const ExpressionPtr& item) {
                             return item && std::holds_alternative<List>(item->what);
                           });
  if (list != nullptr && (is_of_lists || input.type != "Point")) {
    parts_.findings
        .error("wrong-type", value.place, fmt::format("`{}` is one {}, not a list", input.name, input.type))
        .hints = {step.percept->is_many
                      ? fmt::format("write `given {}(...);` once for each", step.percept->name)
                      : fmt::format("there is one `{}` at a time", step.percept->name)};
    return false;
  }
  if (input.type != "object_class" || !std::holds_alternative<Number>(value.what)) return true;
  parts_.findings.error("wrong-type", value.place, "a number is no class of objects").hints = {
      "classes have names: `Mine`, `Basket`, `Flag`"};
  return false;
}

void TestLowering::percept_value(const GivenArgument& given, const TestInput& input, LoweredStep& out) {
  const auto at = static_cast<std::size_t>(&input - out.percept->inputs.data());
  flow::Input range;
  range.min = input.min;
  range.max = input.max;
  const text::Place& place = given.expression->place;
  const auto bound =
      parts_.binder.bind(parts_.values.value_of(*given.expression, *given.scope),
                         parts_.types.named(input.type), &range, std::string(input.name), place);
  if (!bound) return;
  if (bound->kind == flow::Source::Kind::kName) {
    parts_.findings.error("wrong-type", place, "what is sensed is a constant");
    return;
  }
  const bool is_style = out.percept->percept == TestPercept::kObject && input.name == "style";
  if (is_style && test_object_style_named(bound->text) == nullptr) {
    const auto names = test_object_styles() | std::views::transform(&TestObjectStyle::name);
    parts_.findings
        .error("unknown-name", place, fmt::format("an object has no style `{}`", text::shown(bound->text)))
        .hints = {fmt::format("there are {}", fmt::join(names, ", "))};
    return;
  }
  out.values[at] = bound->text;
}

// `10 cycles`, `2 s`
std::uint32_t TestLowering::cycles_of(const TestStep& step) {
  const Number& span = step.span;
  const text::Place place = {step.place.source, span.whole};
  const std::string& unit = span.unit.text;
  double cycles = span.value;
  if (unit != "cycle" && unit != "cycles") {
    const std::optional<Unit> time = unit_named(unit);
    if (unit.empty() || !time || !time->same_dimension(*unit_named("s"))) {
      parts_.findings
          .error("wrong-unit", place,
                 unit.empty() ? "how long is a number of cycles, or a time"
                              : fmt::format("`{}` is no time", text::shown(unit)))
          .hints = {"`10 cycles`, `2 s`"};
      return 1;
    }
    cycles = std::ceil(time->in_si(span.value) / kTestCycle - 1e-9);
  }
  if (cycles < 1.0 || cycles > kMostTestCycles || cycles != std::floor(cycles)) {
    parts_.findings.error("out-of-range", place,
                          fmt::format("a test runs a whole number of cycles, 1 .. {}", kMostTestCycles));
    return 1;
  }
  return static_cast<std::uint32_t>(cycles);
}

void TestLowering::fact(const TestStep& step, LoweredStep& out) {
  if (step.about == TestStep::About::kAction) {
    out.action = test_action_named(step.fact.text);
    if (out.action != nullptr) return;
    std::vector<std::string> names;
    for (const TestAction& one : test_actions()) names.emplace_back(one.name);
    text::Diagnostic& d =
        parts_.findings.error("unknown-action", step.fact.place,
                              fmt::format("a robot has no action `{}`", text::shown(step.fact.text)));
    Findings::hint_nearest(d, step.fact.text, names);
    if (d.hints.empty()) d.hints.push_back(fmt::format("there are {}", fmt::join(names, ", ")));
    return;
  }
  const std::string_view name = std::string_view(step.fact.text).substr(step.fact.text.rfind('.') + 1);
  const auto paths = states_.find(name);
  const bool is_there =
      paths != states_.end() && std::ranges::any_of(paths->second, [&](const std::string& path) {
        return is_named_so(path, step.fact.text);
      });
  if (is_there) return;
  text::Diagnostic& d =
      parts_.findings.error("unknown-state", step.fact.place,
                            fmt::format("what is tested has no state `{}`", text::shown(step.fact.text)));
  if (states_.empty()) d.hints = {"it has no states at all"};
  if (parts_.findings.error_count() > text::Diagnostics::kMaxErrors) return;
  std::vector<std::string> names;
  for (const auto& [known, where] : states_) names.push_back(known);
  Findings::hint_nearest(d, name, names);
}

// They are evaluated though nobody reads them.
void TestLowering::keep_awake(const std::set<std::string>& nodes) {
  for (flow::Node& node : parts_.network.nodes) {
    node.is_public = node.is_public || nodes.contains(node.name);
    for (const flow::State& state : node.states)
      states_[state.name].push_back(joined_path(node.name, state.name));
  }
}

void TestLowering::condition(const TestStep& step, Scope& scope, LoweredStep& out) {
  const auto named = scope.names.find(name_of_condition(out.number));
  if (named == scope.names.end()) return;
  const PortType truth{&flow::type_info<bool>(), ""};
  const Value value = parts_.values.value_of(named->second, scope);
  const auto bound = parts_.binder.bind(value, truth, nullptr, "expect", step.condition->place);
  if (!bound) return;
  out.condition = *bound;
}

void TestLowering::check_places(const LoweredTest& test) {
  std::set<std::string, std::less<>> given;
  for (const LoweredStep& step : test.steps) {
    if (step.percept != nullptr && step.percept->percept == TestPercept::kPlace && !step.values.empty())
      given.insert(step.values[0].value_or(""));
  }
  for (const flow::Parameter& parameter : parts_.network.parameters) {
    const std::string& name = parameter.place_name.text;
    if (name.empty() || given.contains(name)) continue;
    parts_.findings
        .error("unknown-place", parameter.place_name.place,
               fmt::format("the test doesn't say where the place `{}` is", text::shown(name)))
        .hints = {fmt::format("`given place(\"{}\", at = [0 m, 0 m]);`", text::shown(name))};
  }
}

}  // namespace mlab::cdl
