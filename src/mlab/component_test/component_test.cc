#include "mlab/component_test/component_test.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/base/counted.h"
#include "mlab/component_test/situation.h"
#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/robot/program/brought_code.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/program_runners.h"
#include "mlab/text/shown.h"

namespace mlab::component_test {
namespace {

using cdl::TestStep;

constexpr std::uint64_t kMostWork = 500'000'000;  // operations of all cycles, and things sensed in them

// Where `given place("Gate", ...)` says that places are, before the first cycle.
void set_places(const cdl::LoweredTest& lowered, robot::RobotProgram& program) {
  std::map<std::string_view, std::string_view> places;
  for (const cdl::LoweredStep& step : lowered.steps) {
    const bool is_place = step.percept != nullptr && step.percept->percept == cdl::TestPercept::kPlace;
    if (is_place && step.values.size() == 2 && step.values[0] && step.values[1])
      places[*step.values[0]] = *step.values[1];
  }
  for (const flow::Parameter& parameter : lowered.network.parameters) {
    const flow::Port* port = program.program->find(parameter.name);
    const auto place = places.find(parameter.place_name.text);
    if (parameter.place_name.text.empty() || port == nullptr || place == places.end()) continue;
    program.program->set(program.initial.data(), *port, place->second);
  }
}

/// One test while it runs.
class Run {
 public:
  Run(const Test& test, const RunOptions& options)
      : test_(test), options_(options), runners_(options.seed, 1), situation_(test.lowered.steps) {
    outcome_.name = test.lowered.test->name.text;
    work_of_cycle_ = 1 + test.program.program->instruction_count() + 4 * test.lowered.steps.size();
    most_cycles_ = kMostWork / work_of_cycle_;
  }

  Outcome run() {
    runner_ = runners_.runner_of(test_.program);
    member_ = runner_->add({1}, test_.program);
    if (auto problem = runner_->start(member_)) fail_anywhere(*problem);
    for (const cdl::LoweredStep& step : test_.lowered.steps) {
      if (is_over()) break;
      step_ = &step;
      take(step);
    }
    if (outcome_.cycles > 0) outcome_.last = {runner_->save(member_), before_};
    runner_->remove(member_);
    return std::move(outcome_);
  }

 private:
  const flow::Program& program() const { return *test_.program.program; }
  const std::byte* frame() const { return runner_->workings(member_).frame; }

  bool is_over() const { return outcome_.failure.has_value() || outcome_.was_stopped; }

  void take(const cdl::LoweredStep& step) {
    switch (step.written->kind) {
      case TestStep::Kind::kGiven:
      case TestStep::Kind::kGivenNo:
        situation_.take(step);
        is_looked_at_ = false;
        break;
      case TestStep::Kind::kAfter:
        for (std::uint32_t i = 0; i < step.cycles && !is_over(); ++i) cycle();
        is_looked_at_ = true;
        break;
      case TestStep::Kind::kExpect:
        expect(step);
        break;
    }
  }

  // What is expected is so in the present cycle: the first one in which all is sensed that was given.
  void expect(const cdl::LoweredStep& step) {
    if (!std::exchange(is_looked_at_, true)) cycle();
    const bool is_within = step.written->when == TestStep::When::kWithin;
    const std::vector<const flow::Port*> operands = operands_of(step);
    for (std::uint32_t i = 1; !is_over(); ++i) {
      check_numbers(step, operands);
      const bool is_so = !outcome_.failure && holds(step);
      if (outcome_.failure || (is_within && is_so)) return;
      const bool is_last = i >= step.cycles;
      const bool is_lasting = step.written->when == TestStep::When::kFor;
      if (!is_within && !is_so)
        return fail(step, "is false",
                    is_lasting ? fmt::format("cycle {} of {} in which it has to be so", i, step.cycles) : "");
      if (is_last && is_within)
        return fail(step, "is false",
                    fmt::format("as in all {} up to here", base::counted(step.cycles, "cycle")));
      if (is_last) return;
      cycle();
    }
  }

  bool holds(const cdl::LoweredStep& step) {
    const TestStep& written = *step.written;
    if (written.about == TestStep::About::kAction)
      return cdl::is_done(*step.action, action_) != written.is_negated;
    if (written.about == TestStep::About::kState) {
      const bool is_in = std::ranges::any_of(
          states(), [&](const std::string& path) { return cdl::is_named_so(path, written.fact.text); });
      return is_in != written.is_negated;
    }
    const flow::Source& condition = step.condition;
    if (condition.kind == flow::Source::Kind::kConstant) return condition.text == "true";
    const flow::Port* port = program().find(condition.text);
    return port != nullptr && frame()[port->offset] != std::byte{0};
  }

  std::vector<const flow::Port*> operands_of(const cdl::LoweredStep& step) const {
    if (step.written->about != TestStep::About::kCondition) return {};
    std::vector<const flow::Port*> out =
        written_below(test_.lowered.network, program(), step.condition.text, whole_test());
    out.push_back(program().find(test_.lowered.subject));
    std::erase_if(out,
                  [](const flow::Port* port) { return port == nullptr || port->type->is_finite == nullptr; });
    return out;
  }

  // What is no number compares as it likes.
  void check_numbers(const cdl::LoweredStep& step, const std::vector<const flow::Port*>& operands) {
    for (const flow::Port* port : operands) {
      if (!port->type->is_finite(frame() + port->offset))
        return fail(step, fmt::format("can't be told: `{}` is no number", port->path));
    }
  }

  void cycle() {
    const bool was_last = options_.last_cycle != 0 && outcome_.cycles == options_.last_cycle;
    if (was_last || (options_.is_stopped && options_.is_stopped())) {
      outcome_.was_stopped = true;
      return;
    }
    if (outcome_.cycles == most_cycles_) return fail_by_work();
    ++outcome_.cycles;
    program().sequence_states(frame(), before_);
    fault_.clear();
    failure_.clear();
    action_ = {};
    runner_->join(member_);
    runner_->open();
    const robot::ProgramRunner::Member members[] = {member_};
    percept::Needs needs[1];
    runner_->needs(members, needs);
    const robot::ProgramRunner::Turn turns[] = {
        {member_, &situation_.in_cycle(outcome_.cycles), &action_, &fault_, &failure_}};
    runner_->act(turns);
    runner_->ask();
    runner_->wait([this] { return options_.is_stopped && options_.is_stopped(); });
    if (!failure_.empty()) fail_anywhere(failure_);
    if (!fault_.empty()) fail_anywhere(fmt::format("drives by what is no number: `{}`", fault_));
  }

  std::vector<std::string> states() const {
    std::vector<flow::Program::SequenceState> all;
    program().sequence_states(frame(), all);
    std::vector<std::string> out;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      const bool runs = all[i].cycle != 0 && all[i].cycle == flow::Program::cycle(frame());
      const std::vector<std::string>& names = program().state_names(i);
      if (runs && all[i].active < names.size())
        out.push_back(program().sequence_name(i) + "." + names[all[i].active]);
    }
    return out;
  }

  void fail(const cdl::LoweredStep& step, std::string reason, std::string label = "") {
    const TestStep& written = *step.written;
    Failure& out = outcome_.failure.emplace();
    out.label = std::move(label);
    out.place = written.condition ? written.condition->place : written.fact.place;
    out.expected = out.place.source ? in_short(out.place.source->text(out.place.span)) : "";
    if (written.about != TestStep::About::kCondition)
      out.expected = fmt::format("{}{} {}", written.is_negated ? "no " : "",
                                 written.about == TestStep::About::kState ? "state" : "action",
                                 text::shown(written.fact.text));
    note(out, std::move(reason));
    const std::vector<std::uint32_t> ran = program().ran(frame(), before_);
    const bool has_node = step.condition.kind == flow::Source::Kind::kName && !step.condition.text.empty();
    const std::string& from = has_node ? step.condition.text : test_.lowered.subject;
    out.said = feeding(test_.lowered.network, program(), frame(), ran, from, whole_test());
    for (NodeValue& one : out.said) {
      if (one.path == test_.lowered.subject) one.what = cdl::subject_name(*test_.lowered.test).text;
    }
  }

  // What is no matter of one expectation.
  void fail_anywhere(std::string reason) {
    if (outcome_.failure) return;
    Failure& out = outcome_.failure.emplace();
    out.place = test_.lowered.test->name.place;
    out.expected = test_.lowered.test->name.text;
    note(out, std::move(reason));
  }

  // Told where it was when it had done enough: that is the step that lasts too long, or the component is too
  // large.
  void fail_by_work() {
    fail_anywhere(fmt::format("is not done after {} operations, and a test may do no more", kMostWork));
    Failure& out = *outcome_.failure;
    out.label = fmt::format("each of its cycles does {} operations", work_of_cycle_);
    if (step_ == nullptr) return;
    const text::Place& place = step_->written->place;
    out.place = place;
    if (place.source) out.expected = in_short(place.source->text(place.span));
  }

  void note(Failure& out, std::string reason) {
    out.reason = std::move(reason);
    out.cycle = outcome_.cycles;
    out.states = states();
    for (const cdl::TestAction& one : cdl::test_actions()) {
      if (cdl::is_done(one, action_)) out.actions.emplace_back(one.name);
    }
  }

  text::Place whole_test() const {
    return {test_.lowered.test->name.place.source, test_.lowered.test->whole};
  }

  const Test& test_;
  const RunOptions& options_;
  robot::ProgramRunners runners_;
  robot::ProgramRunner* runner_ = nullptr;
  robot::ProgramRunner::Member member_ = 0;
  std::uint64_t work_of_cycle_ = 0;  // operations, and things sensed
  std::uint64_t most_cycles_ = 0;
  const cdl::LoweredStep* step_ = nullptr;  // that is taken
  Situation situation_;
  percept::Action action_;
  std::string fault_;
  std::string failure_;
  std::vector<flow::Program::SequenceState> before_;  // of sequences, before the cycle
  bool is_looked_at_ = false;                         // a cycle ran since something was given
  Outcome outcome_;
};

}  // namespace

Tests load(const text::SourcePtr& source, const robot::ProgramSources& sources, text::Diagnostics& sink,
           const IsWanted& is_wanted) {
  const std::size_t errors_before = sink.error_count();
  Tests out;
  const text::Files files = robot::files_of(sources);
  cdl::Environment environment = robot::library_environment();
  environment.files = &files;
  out.configuration = cdl::load(source, environment, sink);
  if (sink.error_count() > errors_before) return {};
  const auto library = robot::describe_library(out.configuration.procedures);
  cdl::EarlierFindings said;
  cdl::check_declarations(out.configuration, library->library, sink, said);
  cdl::check_tests(out.configuration, library->library, sink, said);
  if (sink.error_count() > errors_before) return {};
  for (const cdl::Test* test : cdl::tests_of(*out.configuration.trees.front())) {
    out.names.push_back(test->name.text);
    if (!is_wanted(test->name.text)) continue;
    Test& one = out.tests.emplace_back();
    one.lowered = cdl::lower(out.configuration, *test, library->library, sink, said);
    auto program = cdl::build({one.lowered.network, {}}, library->library, sink, said);
    if (!program) return {};
    auto built = robot::make_runnable(std::move(program), one.lowered.network, out.configuration.procedures,
                                      robot::describe_library(out.configuration.procedures), test->name.place,
                                      sources, sink);
    if (!built) return {};
    one.program.name = test->name.text;
    one.program.program = std::move(built->program);
    one.program.hosted = std::move(built->hosted);
    one.program.is_described_only = built->is_described_only;
    one.program.initial = one.program.program->make_frame();
    set_places(one.lowered, one.program);
  }
  return out;
}

Outcome run(const Test& test, const RunOptions& options) {
  return Run(test, options).run();
}

text::Diagnostic told(const Failure& failure) {
  text::Diagnostic out;
  out.kind = "failed-expectation";
  out.place = failure.place;
  out.message = fmt::format("`{}` {} in cycle {}", failure.expected, failure.reason, failure.cycle);
  out.label = failure.label;
  return out;
}

std::vector<std::string> findings(const Failure& failure) {
  std::vector<std::string> out;
  for (const NodeValue& one : failure.said) out.push_back(fmt::format("{} is {}", one.what, one.value));
  if (!failure.states.empty()) out.push_back(fmt::format("in state {}", fmt::join(failure.states, ", ")));
  if (!failure.actions.empty()) out.push_back(fmt::format("did {}", fmt::join(failure.actions, ", ")));
  return out;
}

}  // namespace mlab::component_test
