// `mlab trace`: values of ports over a recorded run. Nothing of them was recorded; they are computed again.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mlab/base/counted.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/recorded_run.h"
#include "mlab/flow/program.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/escape.h"
#include "mlab/text/shown.h"
#include "mlab/text/wildcard.h"

namespace mlab::cli {
namespace {

// Of a value that has several numbers, each is a column.
std::span<const std::string_view> parts_of(const flow::Port& port) {
  static constexpr std::array<std::string_view, 3> kXyz = {".x", ".y", ".z"};
  static constexpr std::array<std::string_view, 1> kWhole = {""};
  if (port.type->kind == flow::TypeKind::kVector) return kXyz;
  if (port.type->kind == flow::TypeKind::kPoint) return std::span(kXyz).first(2);
  return kWhole;
}

std::string value_of(const std::byte* frame, const flow::Port& port, std::size_t part) {
  if (port.type->kind != flow::TypeKind::kVector && port.type->kind != flow::TypeKind::kPoint)
    return text::csv_field(flow::Program::print(frame, port));
  std::array<double, 3> numbers{};
  std::memcpy(numbers.data(), frame + port.offset, std::min<std::size_t>(port.type->size, sizeof numbers));
  return fmt::format("{}", numbers[part]);
}
static_assert(sizeof(geom::Vector) == 3 * sizeof(double) && sizeof(geom::Point) == 2 * sizeof(double));

/// The columns of the table, and what fills them, by program.
class Columns {
 public:
  explicit Columns(const TraceOptions& options) : options_(options) {}

  /// @param is_first  its ports become columns; later ones only fill those that there are
  void add(const flow::Program& program, bool is_first) {
    if (sources_.contains(&program)) return;
    std::map<std::string, Source>& sources = sources_[&program];
    for (const flow::Port& port : program.ports()) {
      if (is_first) known_.insert(port.path);
      const auto parts = parts_of(port);
      for (std::size_t i = 0; i < parts.size(); ++i) {
        std::string name = port.path + std::string(parts[i]);
        if (!is_wanted(port, name)) continue;
        if (is_first && std::ranges::find(names_, name) == names_.end()) names_.push_back(name);
        sources[std::move(name)] = {&port, i};
      }
    }
  }
  /// Programs of a run that goes now; their columns stay.
  void forget_programs() { sources_.clear(); }
  const std::vector<std::string>& names() const { return names_; }
  /// Of the options' patterns, in their order.
  std::vector<std::string> patterns_of_nothing() const {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < options_.ports.size(); ++i) {
      if (!matched_.contains(i)) out.push_back(options_.ports[i]);
    }
    return out;
  }
  /// Paths of ports that were looked at, whether wanted or not.
  std::vector<std::string> known() const { return {known_.begin(), known_.end()}; }

  std::string row(const robot::Workings& at) const {
    std::string out;
    const auto& sources = sources_.at(at.program);
    for (const std::string& name : names_) {
      const auto source = sources.find(name);
      out += ",";
      if (source != sources.end()) out += value_of(at.frame, *source->second.port, source->second.part);
    }
    return out;
  }

 private:
  struct Source {
    const flow::Port* port = nullptr;
    std::size_t part = 0;
  };
  bool is_wanted(const flow::Port& port, const std::string& name) {
    if (options_.ports.empty()) return port.role == flow::Port::Role::kOutput;
    bool out = false;
    for (std::size_t i = 0; i < options_.ports.size(); ++i) {
      const std::string& pattern = options_.ports[i];
      if (!text::matches(port.path, pattern) && !text::matches(name, pattern)) continue;
      matched_.insert(i);
      out = true;
    }
    return out;
  }

  const TraceOptions& options_;
  std::set<std::size_t> matched_;  // patterns, by their number
  std::set<std::string> known_;
  std::vector<std::string> names_;
  std::map<const flow::Program*, std::map<std::string, Source>> sources_;
};

bool is_wanted(const fleet::FleetRobot& robot, const TraceOptions& options) {
  return (options.robots.empty() ||
          std::ranges::find(options.robots, robot.id.value) != options.robots.end()) &&
         robot.workings();
}

// @return  whether there were any
bool print_rows(const run::MissionRun& run, const Columns& columns, const TraceOptions& options) {
  bool has_any = false;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (robot.life == fleet::RobotLife::kNotStarted || !is_wanted(robot, options)) continue;
    const geom::Pose& pose = run.fleet().pose(robot);
    fmt::print("{},{},{},{},{},{}{}\n", run.cycle(), run.time(), robot.id.value, pose.position.x,
               pose.position.y, pose.heading, columns.row(robot.workings()));
    has_any = true;
  }
  return has_any;
}

// Of programs that the recording knows by their answers alone no port can be told.
// @return  whether there are any
bool tell_of_closed(const run::MissionRun& run, const TraceOptions& options) {
  std::vector<std::string> closed;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    const bool is_named =
        options.robots.empty() || std::ranges::find(options.robots, robot.id.value) != options.robots.end();
    if (is_named && robot.runner != nullptr && !robot.workings())
      closed.push_back(fmt::format("{}", robot.id.value));
  }
  if (closed.empty()) return false;
  fmt::print(
      stderr,
      "mlab trace: of {} {} only what their programs answered is recorded, since these are in executables "
      "or were elsewhere in real time; none of their ports can be told\n",
      closed.size() == 1 ? "robot" : "robots", fmt::join(closed, ", "));
  return true;
}

// Robots that the options name, and that are not there now.
std::vector<std::uint32_t> missing_robots(const run::MissionRun& run, const TraceOptions& options) {
  std::vector<std::uint32_t> out;
  std::ranges::copy_if(options.robots, std::back_inserter(out),
                       [&](std::uint32_t id) { return run.fleet().find({id}) == nullptr; });
  return out;
}

void add_all(const run::MissionRun& run, const TraceOptions& options, Columns& columns) {
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    const robot::Workings workings = robot.workings();
    if (workings.program != nullptr && is_wanted(robot, options)) columns.add(*workings.program, true);
  }
}

// Robots may come when a run goes on, with programs that no other has: it is computed once more, up to there.
// @return  false: what the options name is not there, which is told
bool find_later_robots(const RecordedRun& recorded, const TraceOptions& options,
                       std::vector<std::uint32_t> missing, Columns& columns, bool& has_closed) {
  const std::unique_ptr<history::Replay> replay = replay_of(recorded.history, options.replay);
  if (replay == nullptr) return false;
  replay->run().set_meanwhile(was_interrupted);
  note_interrupts();
  while (!missing.empty() && !was_interrupted() && replay->step())
    missing = missing_robots(replay->run(), options);
  add_all(replay->run(), options, columns);
  columns.forget_programs();
  has_closed = tell_of_closed(replay->run(), options);
  if (missing.empty()) return true;
  if (!was_interrupted())
    fmt::print(stderr, "mlab trace: --robot {}: there is no such robot in the whole run\n", missing.front());
  return false;
}

// @return  false: what the options name is not there, which is told
bool find_columns(const RecordedRun& recorded, const TraceOptions& options, Columns& columns) {
  const run::MissionRun& run = recorded.replay->run();
  add_all(run, options, columns);
  bool has_closed = false;
  std::vector<std::uint32_t> missing = missing_robots(run, options);
  if (missing.empty())
    has_closed = tell_of_closed(run, options);
  else if (!find_later_robots(recorded, options, std::move(missing), columns, has_closed))
    return false;
  const std::vector<std::string> known = columns.known();
  if (known.empty() && has_closed) return false;
  if (known.empty() && options.robots.empty() && run.fleet().robots().empty()) {
    fmt::print(stderr,
               "mlab trace: there are no robots where this run begins, and so no ports; --robot N shows one "
               "that comes later\n");
    return false;
  }
  for (const std::string& pattern : columns.patterns_of_nothing()) {
    const std::string nearest = text::nearest_name(pattern, known);
    fmt::print(stderr, "mlab trace: --ports '{}': no port of these robots matches{}\n",
               text::shown(pattern, 200),
               nearest.empty() ? std::string() : fmt::format("; did you mean `{}`?", nearest));
  }
  if (!columns.names().empty()) return true;
  fmt::print(
      stderr,
      "mlab trace: no port of these robots matches; --ports '*' shows all, and what they are called\n");
  return false;
}

// Of a run that can't be computed again: where robots were, as it was recorded.
void print_recorded(const history::History& history, const TraceOptions& options) {
  fmt::print(stderr, "mlab trace: only where robots were is recorded, once a second; no port can be told\n");
  fmt::print("cycle,time,robot,x,y,heading\n");
  for (const history::PosesEntry& entry : history.poses()) {
    if (entry.time < options.from || (options.to && entry.time > *options.to)) continue;
    for (int i = 0; i < entry.poses.robots_size(); ++i) {
      const std::uint32_t robot = entry.poses.robots(i);
      if (!options.robots.empty() && std::ranges::find(options.robots, robot) == options.robots.end())
        continue;
      fmt::print("{},{},{},{},{},{}\n", entry.cycle, entry.time, robot, entry.poses.x(i), entry.poses.y(i),
                 entry.poses.heading(i));
    }
  }
}

// @param time  how far it was computed [s]
// @param end   of the run [s]
void tell_interrupted(double time, double end, bool has_rows) {
  std::fflush(stdout);
  fmt::print(stderr, "mlab trace: interrupted after {:.1f} of {:.1f} s; {}\n", time, end,
             has_rows ? "rows are written up to there" : "no row is written");
}

}  // namespace

int trace(const TraceOptions& options) {
  if (options.to && options.from > *options.to) {
    fmt::print(stderr, "mlab trace: --from {} --to {}: nothing lies between them\n", options.from,
               *options.to);
    return kBadInput;
  }
  const RecordedRun recorded = open_recording(options.replay);
  if (!recorded.history) return kBadInput;
  if (!recorded.replay) {
    print_recorded(*recorded.history, options);
    return kFailed;
  }
  run::MissionRun& run = recorded.replay->run();
  Columns columns(options);
  if (!find_columns(recorded, options, columns)) {
    if (!was_interrupted()) return kBadInput;
    fmt::print(stderr,
               "mlab trace: interrupted while looking for robots that come later; no row is written\n");
    return kFailed;
  }
  fmt::print("cycle,time,robot,x,y,heading");
  for (const std::string& name : columns.names()) fmt::print(",{}", text::csv_field(name));
  fmt::print("\n");
  run.set_meanwhile(was_interrupted);
  note_interrupts();
  bool has_rows = false;
  while (!was_interrupted() && recorded.replay->step()) {
    if (options.to && run.time() > *options.to) break;
    if (run.time() < options.from || run.cycle() % options.every != 0) continue;
    for (const fleet::FleetRobot& robot : run.fleet().robots()) {
      if (robot.workings()) columns.add(*robot.workings().program, false);
    }
    has_rows = print_rows(run, columns, options) || has_rows;
  }
  if (!has_rows && !was_interrupted())
    fmt::print(
        stderr,
        "mlab trace: no row: none of these robots has started in a cycle that is asked for, from {} s on; "
        "the run "
        "has {}, up to {:.1f} s\n",
        options.from, base::counted(recorded.history->last_cycle(), "cycle"), recorded.history->last_time());
  if (was_interrupted())
    tell_interrupted(run.time(), recorded.history->last_time(), has_rows);
  else if (recorded.replay->divergence())
    fmt::print(stderr, "{}\n", outcome_of(*recorded.replay));
  return recorded.replay->divergence() || recorded.is_damaged || was_interrupted() ? kFailed : kDone;
}

}  // namespace mlab::cli
