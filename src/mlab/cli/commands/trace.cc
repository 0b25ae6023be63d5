// `mlab trace`: values of ports over a recorded run. Nothing of them was recorded; they are computed again.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mlab/cli/commands.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/recorded_run.h"
#include "mlab/flow/program.h"
#include "mlab/text/escape.h"
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
      const auto parts = parts_of(port);
      for (std::size_t i = 0; i < parts.size(); ++i) {
        std::string name = port.path + std::string(parts[i]);
        if (!is_wanted(port, name)) continue;
        if (is_first && std::ranges::find(names_, name) == names_.end()) names_.push_back(name);
        sources[std::move(name)] = {&port, i};
      }
    }
  }
  const std::vector<std::string>& names() const { return names_; }

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
  bool is_wanted(const flow::Port& port, const std::string& name) const {
    if (options_.ports.empty()) return port.role == flow::Port::Role::kOutput;
    return std::ranges::any_of(options_.ports, [&](const std::string& pattern) {
      return text::matches(port.path, pattern) || text::matches(name, pattern);
    });
  }

  const TraceOptions& options_;
  std::vector<std::string> names_;
  std::map<const flow::Program*, std::map<std::string, Source>> sources_;
};

bool is_wanted(const fleet::FleetRobot& robot, const TraceOptions& options) {
  return (options.robots.empty() ||
          std::ranges::find(options.robots, robot.id.value) != options.robots.end()) &&
         robot.workings();
}

void print_rows(const run::MissionRun& run, const Columns& columns, const TraceOptions& options) {
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (robot.life == fleet::RobotLife::kNotStarted || !is_wanted(robot, options)) continue;
    const geom::Pose& pose = run.fleet().pose(robot);
    fmt::print("{},{},{},{},{},{}{}\n", run.cycle(), run.time(), robot.id.value, pose.position.x,
               pose.position.y, pose.heading, columns.row(robot.workings()));
  }
}

// Of programs that the recording knows by their answers alone no port can be told.
void tell_of_closed(const run::MissionRun& run, const TraceOptions& options) {
  std::vector<std::string> closed;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    const bool is_named =
        options.robots.empty() || std::ranges::find(options.robots, robot.id.value) != options.robots.end();
    if (is_named && robot.runner != nullptr && !robot.workings())
      closed.push_back(fmt::format("{}", robot.id.value));
  }
  if (closed.empty()) return;
  fmt::print(stderr,
             "mlab trace: of robots {} only what their programs answered is recorded, since these are in "
             "executables "
             "or were elsewhere in real time; none of their ports can be told\n",
             fmt::join(closed, ", "));
}

// @return  false: what the options name is not there, which is told
bool find_columns(const run::MissionRun& run, const TraceOptions& options, Columns& columns) {
  for (const std::uint32_t id : options.robots) {
    if (run.fleet().find({id}) != nullptr) continue;
    fmt::print(stderr, "mlab trace: --robot {}: there is no such robot when the run begins\n", id);
    return false;
  }
  tell_of_closed(run, options);
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (is_wanted(robot, options)) columns.add(*robot.workings().program, true);
  }
  if (!columns.names().empty()) return true;
  fmt::print(stderr,
             "mlab trace: no port of these robots matches; `mlab describe` and `mlab build --emit cnl` "
             "say what they are called\n");
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

}  // namespace

int trace(const TraceOptions& options) {
  const RecordedRun recorded = open_recording(options.replay);
  if (!recorded.history) return kBadInput;
  if (!recorded.replay) {
    print_recorded(*recorded.history, options);
    return kFailed;
  }
  run::MissionRun& run = recorded.replay->run();
  Columns columns(options);
  if (!find_columns(run, options, columns)) return kBadInput;
  fmt::print("cycle,time,robot,x,y,heading");
  for (const std::string& name : columns.names()) fmt::print(",{}", text::csv_field(name));
  fmt::print("\n");
  run.set_meanwhile(was_interrupted);
  note_interrupts();
  while (!was_interrupted() && recorded.replay->step()) {
    if (options.to && run.time() > *options.to) break;
    if (run.time() < options.from || run.cycle() % options.every != 0) continue;
    for (const fleet::FleetRobot& robot : run.fleet().robots()) {
      if (robot.workings()) columns.add(*robot.workings().program, false);
    }
    print_rows(run, columns, options);
  }
  if (recorded.replay->divergence()) fmt::print(stderr, "{}\n", outcome_of(*recorded.replay));
  return recorded.replay->divergence() || was_interrupted() ? kFailed : kDone;
}

}  // namespace mlab::cli
