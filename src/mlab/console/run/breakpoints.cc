#include "mlab/console/run/breakpoints.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/console/published/overview.h"

namespace mlab::console {
namespace {

using Condition = Breakpoint::Condition;
using flow::Program;

std::optional<double> number_of(const std::string& text) {
  double out = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size() || !std::isfinite(out))
    return std::nullopt;
  return out;
}

const char* sign_of(Condition::Comparison how) {
  constexpr const char* kSigns[] = {"=", "!=", "<", "<=", ">", ">="};
  return how >= Condition::EQUAL && how <= Condition::GREATER_OR_EQUAL ? kSigns[how] : "?";
}

// The number in the unit in which people see the port.
std::optional<double> number_as_shown(const std::byte* frame, const flow::Port& port) {
  const std::optional<double> number = Program::number(frame, port);
  const bool in_degrees =
      port.type->kind == flow::TypeKind::kReal && port.edge_unit == "deg" && port.unit != "deg";
  return number && in_degrees ? base::degrees(*number) : number;
}

bool is_true_now(const Condition& condition, const std::optional<double>& wanted, const std::byte* frame,
                 const flow::Port& port) {
  if (wanted) {
    const std::optional<double> number = number_as_shown(frame, port);
    return number && compares(*number, condition.comparison(), *wanted);
  }
  const bool is_equal = Program::print(frame, port) == condition.value();
  return condition.comparison() == Condition::NOT_EQUAL ? !is_equal : is_equal;
}

bool names_robot(const Breakpoint& breakpoint, std::uint32_t robot) {
  return breakpoint.robots().empty() ||
         std::ranges::find(breakpoint.robots(), robot) != breakpoint.robots().end();
}

// What can't be meant at all; empty: it may be.
std::string problem_with(const Breakpoint& wanted, const std::optional<double>& number) {
  constexpr std::size_t kLongest = 1000;
  if (wanted.has_transition()) {
    const Breakpoint::Transition& transition = wanted.transition();
    if (transition.sequence().empty()) return "a transition belongs to a sequence, and none is named";
    const bool is_short = transition.sequence().size() <= kLongest && transition.from().size() <= kLongest &&
                          transition.to().size() <= kLongest;
    return is_short ? "" : "its names are too long";
  }
  if (!wanted.has_condition()) return "a breakpoint is a transition, a condition or a sentence";
  const Condition& condition = wanted.condition();
  if (condition.port().empty()) return "a condition compares a value, and none is named";
  if (condition.port().size() > kLongest || condition.value().size() > kLongest)
    return "its names are too long";
  if (!Condition::Comparison_IsValid(condition.comparison())) return "this comparison is not known here";
  if (!number && condition.comparison() > Condition::NOT_EQUAL)
    return fmt::format("`{}` is no number: a word is only equal or not", clean(condition.value()));
  return "";
}

}  // namespace

std::expected<BreakpointTable::Entry, std::string> BreakpointTable::Entry::read(const Breakpoint& wanted) {
  constexpr int kMostRobots = 10'000;
  if (wanted.robots_size() > kMostRobots) return std::unexpected("it names too many robots");
  Entry out{wanted, std::nullopt, std::nullopt};
  if (wanted.has_sentence()) {
    if (!wanted.robots().empty()) return std::unexpected("a sentence names its robots itself");
    auto sentence = Sentence::parse(wanted.sentence());
    if (!sentence) return std::unexpected(std::move(sentence.error()));
    out.sentence = std::move(*sentence);
    if (!out.sentence->breakpoint()) return out;
  }
  if (out.what().has_condition()) out.number = number_of(out.what().condition().value());
  if (std::string problem = problem_with(out.what(), out.number); !problem.empty())
    return std::unexpected(std::move(problem));
  return out;
}

void BreakpointTable::Entry::note(const run::MissionRun* run) {
  if (!sentence) return;
  sentence->forget();
  if (run != nullptr) sentence->look(*run);
}

std::uint32_t BreakpointTable::set(const Breakpoint& wanted, std::string& error) {
  auto one = Entry::read(wanted);
  error = one ? "" : one.error();
  if (error.empty() && wanted.id() != 0 && !all_.contains(wanted.id()))
    error = fmt::format("there is no breakpoint {}", wanted.id());
  if (error.empty() && wanted.id() == 0 && all_.size() >= kMost)
    error = fmt::format("there are {} breakpoints, and more are not kept", kMost);
  if (!error.empty()) return 0;
  const std::uint32_t id = wanted.id() != 0 ? wanted.id() : ++last_id_;
  one->told.set_id(id);
  one->told.clear_error();
  one->told.set_hits(wanted.id() != 0 ? all_.at(id).told.hits() : 0);
  one->note(run_);
  all_[id] = std::move(*one);
  for (auto& [program, meanings] : meanings_) meanings.erase(id);
  for (auto& [robot, known] : robots_) known.was_true.erase(id);
  recount();
  return id;
}

void BreakpointTable::recall(const std::vector<Breakpoint>& earlier) {
  for (const Breakpoint& told : earlier) {
    auto one = Entry::read(told);
    if (told.id() == 0 || !one || all_.size() >= kMost) continue;
    one->note(run_);
    last_id_ = std::max(last_id_, told.id());
    all_[told.id()] = std::move(*one);
  }
  recount();
}

bool BreakpointTable::remove(std::uint32_t id) {
  if (id != 0 && all_.erase(id) == 0) return false;
  if (id == 0) all_.clear();
  recount();
  return true;
}

void BreakpointTable::recount() {
  count_on_ = static_cast<std::size_t>(
      std::ranges::count_if(all_, [](const auto& entry) { return !entry.second.told.is_off(); }));
  if (count_on_ == 0) robots_.clear();  // what was noted grows old while nobody looks
  has_news_ = true;
  say_problems(run_);
}

void BreakpointTable::begin(const run::MissionRun* run) {
  for (auto& [id, one] : all_) one.told.set_hits(0);
  change(run);
}

void BreakpointTable::change(const run::MissionRun* run) {
  run_ = run;
  meanings_.clear();
  robots_.clear();
  for (auto& [id, one] : all_) one.note(run);
  has_news_ = true;
  say_problems(run);
}

// Once for all programs, so that a typing error shows at once.
void BreakpointTable::say_problems(const run::MissionRun* run) {
  for (auto& [id, one] : all_) {
    one.told.clear_error();
    if (run == nullptr) continue;
    if (auto why = one.why_never(*run)) {
      one.told.set_error(std::move(*why));
      continue;
    }
    if (!one.what().has_transition() && !one.what().has_condition()) continue;
    const bool is_somewhere = std::ranges::any_of(run->fleet().robots(), [&](const auto& robot) {
      const Program* const program = robot.workings().program;
      return program != nullptr && names_robot(one.what(), robot.id.value) && meaning(one, *program).is_there;
    });
    if (is_somewhere) continue;
    one.told.set_error(
        one.what().has_transition()
            ? fmt::format("no program of this run has such a transition of `{}`",
                          clean(one.what().transition().sequence()))
            : fmt::format("no program of this run has `{}`", clean(one.what().condition().port())));
  }
}

const BreakpointTable::Meaning& BreakpointTable::meaning(const Entry& one, const Program& program) {
  const auto [at, is_new] = meanings_[&program].try_emplace(one.told.id());
  Meaning& out = at->second;
  if (!is_new) return out;
  if (one.what().has_condition()) {
    out.port = program.find(one.what().condition().port());
    out.is_there = out.port != nullptr;
    return out;
  }
  const Breakpoint::Transition& wanted = one.what().transition();
  for (std::uint32_t s = 0; s < program.sequence_count(); ++s) {
    if (program.sequence_name(s) != wanted.sequence()) continue;
    const std::vector<std::string>& names = program.state_names(s);
    const auto index = [&](const std::string& name) -> std::optional<std::uint32_t> {
      const auto found = std::ranges::find(names, name);
      if (found == names.end()) return std::nullopt;
      return static_cast<std::uint32_t>(found - names.begin());
    };
    out.sequence = s;
    out.from = index(wanted.from());
    out.to = index(wanted.to());
    out.is_there = (wanted.from().empty() || out.from) && (wanted.to().empty() || out.to);
  }
  return out;
}

void BreakpointTable::look(const run::MissionRun& run, Halted& out) {
  if (count_on_ == 0) return;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (robot.life == fleet::RobotLife::kRunning && robot.workings().program) look_at(robot, out);
  }
  look_at_sentences(run, out);
  if (out.hits().empty()) return;
  has_news_ = true;
  out.set_time(run.time());
  out.set_cycle(run.cycle());
  for (const Halted::Hit& told : out.hits()) {
    const auto found = all_.find(told.breakpoint());
    if (found != all_.end() && found->second.told.is_once()) all_.erase(found);
  }
  recount();
}

// The first look at a robot only notes how it stands: what is true from the start did not become so.
void BreakpointTable::look_at(const fleet::FleetRobot& robot, Halted& out) {
  const Program& program = *robot.workings().program;
  const std::byte* const frame = robot.workings().frame;
  Robot& known = robots_[robot.id.value];
  const bool is_new = std::exchange(known.program, &program) != &program;
  // It may lie where another one lay.
  if (is_new) meanings_.erase(&program);
  const std::vector<Program::SequenceState> before = std::exchange(known.states, {});
  program.sequence_states(frame, known.states);
  const bool is_first_cycle = Program::cycle(frame) <= 1;
  if (is_new && !is_first_cycle) known.was_true.clear();
  std::optional<std::vector<Program::Transit>> transits;
  std::optional<std::vector<std::uint32_t>> ran;
  for (auto& [id, one] : all_) {
    const Breakpoint& what = one.what();
    if (one.told.is_off() || (!what.has_transition() && !what.has_condition())) continue;
    if (!names_robot(what, robot.id.value) || !meaning(one, program).is_there) continue;
    if (what.has_transition()) {
      if (is_new && !is_first_cycle) continue;
      if (!transits) transits = program.transits(frame, before, robot.workings().interventions);
      look_for_transit(one, robot, *transits, out);
    } else {
      if (!ran) ran = program.ran(frame, before, robot.workings().interventions);
      look_for_condition(one, robot, known, *ran, out);
    }
  }
}

void BreakpointTable::look_for_transit(Entry& one, const fleet::FleetRobot& robot,
                                       const std::vector<Program::Transit>& transits, Halted& out) {
  const Program& program = *robot.workings().program;
  const Meaning& meant = meaning(one, program);
  for (const Program::Transit& transit : transits) {
    const bool is_it = transit.sequence == meant.sequence && (!meant.from || *meant.from == transit.from) &&
                       (!meant.to || *meant.to == transit.to);
    if (!is_it) continue;
    const std::vector<std::string>& names = program.state_names(transit.sequence);
    Halted::Hit told;
    told.set_robot(robot.id.value);
    told.set_sequence(clean(program.sequence_name(transit.sequence)));
    told.set_from(clean(names[transit.from]));
    told.set_to(clean(names[transit.to]));
    told.set_text(fmt::format("robot {}: {} goes from {} to {}", robot.id.value, told.sequence(), told.from(),
                              told.to()));
    hit(one, std::move(told), out);
  }
}

void BreakpointTable::look_for_condition(Entry& one, const fleet::FleetRobot& robot, Robot& known,
                                         const std::vector<std::uint32_t>& ran, Halted& out) {
  const flow::Port& port = *meaning(one, *robot.workings().program).port;
  const std::byte* const frame = robot.workings().frame;
  const bool is_computed =
      port.role != flow::Port::Role::kOutput || std::ranges::binary_search(ran, port.offset);
  const bool is_true = is_computed && is_true_now(one.what().condition(), one.number, frame, port);
  const auto [was, is_new] = known.was_true.try_emplace(one.told.id(), false);
  const bool is_first_look = is_new && Program::cycle(frame) > 1;
  const bool became = is_true && !was->second && !is_first_look;
  was->second = is_true;
  if (!became) return;
  Halted::Hit told;
  told.set_robot(robot.id.value);
  told.set_port(clean(port.path));
  told.set_value(clean(Program::print(frame, port)));
  const Condition& condition = one.what().condition();
  std::string text = fmt::format("robot {}: {} is {}", robot.id.value, told.port(), told.value());
  if (condition.comparison() != Condition::EQUAL)
    text += fmt::format(" ({} {})", sign_of(condition.comparison()), clean(condition.value()));
  told.set_text(std::move(text));
  hit(one, std::move(told), out);
}

void BreakpointTable::look_at_sentences(const run::MissionRun& run, Halted& out) {
  for (auto& [id, one] : all_) {
    if (one.told.is_off() || !one.sentence) continue;
    for (Sentence::Met& met : one.sentence->look(run)) {
      Halted::Hit told;
      told.set_robot(met.robot);
      told.set_text(std::move(met.text));
      hit(one, std::move(told), out);
    }
  }
}

void BreakpointTable::hit(Entry& one, Halted::Hit told, Halted& out) {
  one.told.set_hits(one.told.hits() + 1);
  told.set_breakpoint(one.told.id());
  if (out.hits_size() < kMostHits) *out.add_hits() = std::move(told);
}

void BreakpointTable::encode(Breakpoints& out) const {
  for (const auto& [id, one] : all_) *out.add_breakpoints() = one.told;
}

}  // namespace mlab::console
