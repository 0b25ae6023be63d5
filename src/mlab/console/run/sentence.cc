#include "mlab/console/run/sentence.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/console/published/overview.h"
#include "mlab/console/run/measure_series.h"
#include "mlab/text/shown.h"

namespace mlab::console {
namespace {

using fleet::FleetRobot;
using fleet::RobotLife;

constexpr std::size_t kMostText = 1000;

constexpr std::array<std::pair<std::string_view, Series::Quantity>, 7> kQuantities = {{
    {"distance-to-goal", Series::DISTANCE_TO_GOAL},
    {"formation-error", Series::FORMATION_ERROR},
    {"speed", Series::SPEED},
    {"distance-driven", Series::DISTANCE_DRIVEN},
    {"contacts", Series::CONTACTS},
    {"nearest-obstacle", Series::NEAREST_OBSTACLE},
    {"heading", Series::HEADING},
}};

using Comparison = Breakpoint::Condition::Comparison;

constexpr std::array<std::pair<std::string_view, Comparison>, 7> kComparisons = {{
    {"<", Breakpoint::Condition::LESS},
    {"<=", Breakpoint::Condition::LESS_OR_EQUAL},
    {">", Breakpoint::Condition::GREATER},
    {">=", Breakpoint::Condition::GREATER_OR_EQUAL},
    {"=", Breakpoint::Condition::EQUAL},
    {"==", Breakpoint::Condition::EQUAL},
    {"!=", Breakpoint::Condition::NOT_EQUAL},
}};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> out;
  constexpr std::string_view kSpaces = " \t";
  for (std::size_t begin = text.find_first_not_of(kSpaces); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpaces, begin), text.size());
    out.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(kSpaces, end);
  }
  return out;
}

std::optional<double> number_of(std::string_view word) {
  double out = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), out);
  if (word.empty() || error != std::errc{} || end != word.data() + word.size() || !std::isfinite(out))
    return std::nullopt;
  return out;
}

std::optional<std::uint32_t> robot_of(std::string_view word) {
  std::uint32_t out = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), out);
  if (word.empty() || error != std::errc{} || end != word.data() + word.size() || out == 0)
    return std::nullopt;
  return out;
}

std::optional<double> measured(const run::MissionRun& run, const FleetRobot& robot,
                               Series::Quantity quantity) {
  Series series;
  series.set_quantity(quantity);
  series.set_robot(robot.id.value);
  return measure(run, series);
}

bool is_in_world(const FleetRobot& robot) {
  return robot.life != RobotLife::kNotStarted;
}

// To the middle of the other one, or of the nearest [m].
std::optional<double> to_robot(const run::MissionRun& run, const FleetRobot& robot, std::uint32_t other) {
  double nearest = std::numeric_limits<double>::infinity();
  const geom::Point at = run.fleet().pose(robot).position;
  for (const FleetRobot& one : run.fleet().robots()) {
    if (one.id == robot.id || !is_in_world(one) || (other != 0 && one.id.value != other)) continue;
    nearest = std::min(nearest, geom::distance(run.fleet().pose(one).position, at));
  }
  return std::isfinite(nearest) ? std::optional(nearest) : std::nullopt;
}

// By `Charlie` or `PP-Charlie`. Each cycle asks, of each robot.
const overlay::ControlMeasure* find_place(const run::MissionRun& run, std::string_view name) {
  const auto& measures = run.mission().overlay.measures;
  const auto found = std::ranges::find_if(measures, [&](const overlay::ControlMeasure& one) {
    if (!name.ends_with(one.name)) return false;
    const std::string_view before = name.substr(0, name.size() - one.name.size());
    return before.empty() ||
           (before.back() == '-' && before.substr(0, before.size() - 1) == keyword(one.kind));
  });
  return found == measures.end() ? nullptr : &*found;
}

bool is_in_state(const FleetRobot& robot, const std::string& state) {
  if (robot.life != RobotLife::kRunning || !robot.workings().program) return false;
  const flow::Program& program = *robot.workings().program;
  const std::byte* const frame = robot.workings().frame;
  std::vector<flow::Program::SequenceState> states;
  program.sequence_states(frame, states);
  const auto now = static_cast<std::uint32_t>(flow::Program::cycle(frame));
  for (std::uint32_t i = 0; i < states.size(); ++i) {
    if (states[i].cycle == now && program.state_names(i)[states[i].active] == state) return true;
  }
  return false;
}

bool has_state(const flow::Program& program, const std::string& state) {
  for (std::uint32_t i = 0; i < program.sequence_count(); ++i) {
    const std::vector<std::string>& names = program.state_names(i);
    if (std::ranges::find(names, state) != names.end()) return true;
  }
  return false;
}

// Why none of these (0: any) can be in it. A program that is not known here may have whatever state.
std::optional<std::string> why_no_state(const run::MissionRun& run, std::uint32_t robot_id,
                                        const std::string& state) {
  bool is_known = false;
  for (const FleetRobot& robot : run.fleet().robots()) {
    const flow::Program* const program = robot.workings().program;
    if ((robot_id != 0 && robot.id.value != robot_id) || program == nullptr) continue;
    if (has_state(*program, state)) return std::nullopt;
    is_known = true;
  }
  if (!is_known) return std::nullopt;
  return robot_id == 0 ? fmt::format("no program of this run has a state `{}`", clean(state))
                       : fmt::format("the program of robot {} has no state `{}`", robot_id, clean(state));
}

// As the console shows a heading: 0 to 360.
double degrees_shown(double heading) {
  const double degrees = base::degrees(heading);
  return degrees < 0.0 ? degrees + 360.0 : degrees;
}

auto compared(const Series& series, const std::string& name, Comparison comparison, double bound) {
  return [=](const run::MissionRun& run, const FleetRobot& robot) -> std::optional<std::string> {
    Series of_robot = series;
    of_robot.set_robot(robot.id.value);
    auto value = measure(run, of_robot);
    if (value && series.quantity() == Series::HEADING) value = degrees_shown(*value);
    if (!value || !compares(*value, comparison, bound)) return std::nullopt;
    return fmt::format("{} of robot {} was {:.4g}", clean(name), robot.id.value, *value);
  };
}

// Why no robot of these (0: any) has a number there.
std::optional<std::string> why_no_number(const run::MissionRun& run, std::uint32_t robot_id,
                                         const std::string& port) {
  Series series;
  series.set_quantity(Series::PORT);
  series.set_port(port);
  std::string why;
  for (const FleetRobot& robot : run.fleet().robots()) {
    if (robot_id != 0 && robot.id.value != robot_id) continue;
    series.set_robot(robot.id.value);
    why = problem_of(run, series);
    if (why.empty()) return std::nullopt;
  }
  return why.empty() ? "there is no robot" : why;
}

}  // namespace

bool compares(double a, Breakpoint::Condition::Comparison how, double b) {
  switch (how) {
    case Breakpoint::Condition::EQUAL:
      return a == b;
    case Breakpoint::Condition::NOT_EQUAL:
      return a != b;
    case Breakpoint::Condition::LESS:
      return a < b;
    case Breakpoint::Condition::LESS_OR_EQUAL:
      return a <= b;
    case Breakpoint::Condition::GREATER:
      return a > b;
    case Breakpoint::Condition::GREATER_OR_EQUAL:
      return a >= b;
    default:
      return false;
  }
}

// Takes words off the front.
struct Sentence::Reader {
  std::vector<std::string_view> words;
  std::size_t next = 0;

  std::string_view peek() const { return next < words.size() ? words[next] : std::string_view(); }
  std::string_view take() { return next < words.size() ? words[next++] : std::string_view(); }
  bool skip(std::string_view word) {
    if (peek() != word) return false;
    ++next;
    return true;
  }
  std::string seen() const {
    return next < words.size() ? fmt::format("`{}`", text::shown(std::string(peek()), 60))
                               : "the end of the condition";
  }
  std::unexpected<std::string> expected(std::string_view what) const {
    return std::unexpected(fmt::format("expected {}, but saw {}: for example {}", what, seen(), kExamples));
  }

  std::expected<void, std::string> subject(Sentence& out) {
    if (skip("any")) {
      if (!skip("robot")) return expected("`robot`");
      return {};
    }
    if (!skip("robot")) return expected("`robot N` or `any robot`");
    // `robot 2: movement goes from ...`, as a halt is told
    const auto number = robot_of(peek().ends_with(':') ? peek().substr(0, peek().size() - 1) : peek());
    if (!number) return expected("a robot's number");
    take();
    out.robot_ = *number;
    return {};
  }

  std::expected<void, std::string> distance(Sentence& out, bool is_near) {
    if (!skip("than")) return expected("`than`");
    const auto bound = number_of(peek());
    if (!bound || *bound < 0.0) return expected("a distance in metres");
    take();
    skip("m");
    if (!skip(is_near ? "to" : "from")) return expected(is_near ? "`to`" : "`from`");
    std::function<std::optional<double>(const run::MissionRun&, const FleetRobot&)> measure_it;
    std::string what;
    if (skip("an") || peek() == "obstacle") {
      if (!skip("obstacle")) return expected("`obstacle`");
      what = "an obstacle";
      measure_it = [](const auto& run, const auto& robot) {
        return measured(run, robot, Series::NEAREST_OBSTACLE);
      };
    } else if (skip("its")) {
      if (!skip("goal")) return expected("`goal`");
      what = "its goal";
      measure_it = [](const auto& run, const auto& robot) {
        return measured(run, robot, Series::DISTANCE_TO_GOAL);
      };
    } else if (skip("a") || skip("any") || peek() == "robot") {
      if (!skip("robot")) return expected("`robot`");
      const std::uint32_t other = robot_of(peek()).value_or(0);
      if (other != 0) take();
      what = other != 0 ? fmt::format("robot {}", other) : "another robot";
      measure_it = [other](const auto& run, const auto& robot) { return to_robot(run, robot, other); };
    } else if (!peek().empty()) {
      out.place_ = std::string(take());
      what = clean(out.place_);
      measure_it = [place = out.place_](const run::MissionRun& run,
                                        const FleetRobot& robot) -> std::optional<double> {
        const overlay::ControlMeasure* const found = find_place(run, place);
        if (found == nullptr) return std::nullopt;
        return geom::distance(found->center(), run.fleet().pose(robot).position);
      };
    } else {
      return expected("`an obstacle`, `a robot`, `robot N`, `its goal` or a place of the map");
    }
    out.test_ = [measure_it, what, bound = *bound, is_near](
                    const run::MissionRun& run, const FleetRobot& robot) -> std::optional<std::string> {
      const auto value = measure_it(run, robot);
      if (!value || (is_near ? *value >= bound : *value <= bound)) return std::nullopt;
      return fmt::format("robot {} was {:.2f} m from {}", robot.id.value, *value, what);
    };
    return {};
  }

  std::expected<void, std::string> being(Sentence& out) {
    if (skip("contact")) {
      out.is_contact_ = true;
      return {};
    }
    if (!skip("state")) return expected("`contact` or `state`");
    if (peek().empty()) return expected("the name of a state");
    out.state_ = std::string(take());
    out.test_ = [state = out.state_](const run::MissionRun&,
                                     const FleetRobot& robot) -> std::optional<std::string> {
      if (!is_in_state(robot, state)) return std::nullopt;
      return fmt::format("robot {} came into state {}", robot.id.value, clean(state));
    };
    return {};
  }

  // Empty: any.
  std::string state() {
    const std::string_view name = take();
    return name == "any" ? "" : std::string(name);
  }

  std::expected<void, std::string> transition(Sentence& out, const std::string& sequence) {
    Breakpoint::Transition& wanted = *out.breakpoint_.emplace().mutable_transition();
    wanted.set_sequence(sequence);
    if (peek() != "from" && peek() != "to") return expected("`from STATE` or `to STATE`");
    for (const std::string_view word : {"from", "to"}) {
      if (!skip(word)) continue;
      if (peek().empty()) return expected("the name of a state, or `any`");
      word == "from" ? wanted.set_from(state()) : wanted.set_to(state());
    }
    return {};
  }

  // A quantity is a number; a port may hold a word.
  std::expected<void, std::string> comparison(Sentence& out) {
    if (peek().empty())
      return expected("`nearer than`, `farther than`, `in contact`, `in state`, a quantity or a port");
    const std::string name(take());
    if (skip("goes")) return transition(out, name);
    const auto* const quantity =
        std::ranges::find(kQuantities, name, &std::pair<std::string_view, Series::Quantity>::first);
    const auto* const how =
        std::ranges::find(kComparisons, peek(), &std::pair<std::string_view, Comparison>::first);
    if (how == kComparisons.end()) return expected("`<`, `<=`, `>`, `>=`, `=` or `!=`");
    take();
    const auto bound = number_of(peek());
    if (quantity != kQuantities.end()) {
      if (!bound) return expected("a number");
      Series series;
      series.set_quantity(quantity->second);
      out.test_ = compared(series, name, how->second, *bound);
    } else {
      const bool may_be_word =
          how->second == Breakpoint::Condition::EQUAL || how->second == Breakpoint::Condition::NOT_EQUAL;
      if (peek().empty() || (!bound && !may_be_word))
        return expected(may_be_word ? "a number or a word" : "a number");
      Breakpoint::Condition& wanted = *out.breakpoint_.emplace().mutable_condition();
      wanted.set_port(name);
      wanted.set_comparison(how->second);
      wanted.set_value(std::string(peek()));
    }
    take();
    return {};
  }

  std::expected<void, std::string> predicate(Sentence& out) {
    if (skip("nearer")) return distance(out, true);
    if (skip("farther")) return distance(out, false);
    if (skip("in")) return being(out);
    return comparison(out);
  }
};

std::expected<Sentence, std::string> Sentence::parse(std::string_view text) {
  if (text.size() > kMostText) return std::unexpected("a condition is a line of at most 1000 bytes");
  Reader reader{words_of(text)};
  Sentence out;
  if (auto read = reader.subject(out); !read) return std::unexpected(std::move(read.error()));
  if (auto read = reader.predicate(out); !read) return std::unexpected(std::move(read.error()));
  if (reader.next < reader.words.size()) return reader.expected("nothing more");
  if (out.breakpoint_ && out.robot_ != 0) out.breakpoint_->add_robots(out.robot_);
  return out;
}

std::optional<std::string> Sentence::why_never(const run::MissionRun& run) const {
  if (robot_ != 0 && run.fleet().find({robot_}) == nullptr)
    return fmt::format("there is no robot {}", robot_);
  if (!place_.empty() && find_place(run, place_) == nullptr)
    return fmt::format("the map has no place `{}`", clean(place_));
  if (!state_.empty()) return why_no_state(run, robot_, state_);
  if (!breakpoint_ || !breakpoint_->has_condition()) return std::nullopt;
  const Breakpoint::Condition& asked = breakpoint_->condition();
  return number_of(asked.value()) ? why_no_number(run, robot_, asked.port()) : std::nullopt;
}

std::vector<Sentence::Met> Sentence::look(const run::MissionRun& run) {
  std::vector<Met> out;
  if (breakpoint_) return out;
  for (const FleetRobot& robot : run.fleet().robots()) {
    if ((robot_ != 0 && robot.id.value != robot_) || !is_in_world(robot)) continue;
    Standing& standing = standing_[robot.id.value];
    std::optional<std::string> now;
    if (is_contact_) {
      const std::uint32_t contacts = run.world().body(robot.body).contacts;
      if (contacts > standing.contacts) now = fmt::format("robot {} touched something", robot.id.value);
      standing.contacts = contacts;
    } else {
      now = test_(run, robot);
    }
    const bool was_true = std::exchange(standing.was_true, !is_contact_ && now.has_value());
    if (now && !was_true) out.push_back({robot.id.value, std::move(*now)});
  }
  return out;
}

}  // namespace mlab::console
