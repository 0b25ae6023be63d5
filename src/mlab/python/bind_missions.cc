#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>

#include "mlab/cli/clock.h"
#include "mlab/cli/places.h"
#include "mlab/cli/version.h"
#include "mlab/python/bindings.h"
#include "mlab/python/values.h"
#include "mlab/python/watched_run.h"
#include "mlab/run/report.h"
#include "mlab/study/dimension.h"
#include "mlab/text/wildcard.h"
#include "mlab/training/seen_columns.h"

namespace mlab::python {
namespace {

using namespace pybind11::literals;
using MissionPtr = std::shared_ptr<const MissionFile>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A mission, and what was said when it was read.
struct PyMission {
  MissionPtr file;
  py::list warnings;
};

/// A run that Python has.
struct PyRun {
  std::unique_ptr<WatchedRun> watched;
  OneUser user;
  double wall_began = cli::steady_seconds();
  double cpu_began = cli::cpu_seconds();

  ~PyRun() { leave_where_forked(user, watched); }
};

PyMission load(const std::string& path, const std::vector<std::pair<std::string, std::string>>& set,
               const std::string& environment, bool allows_native, bool has_cell) {
  MissionFile::Request request{path, {}, environment, permission_for(path, allows_native, has_cell)};
  for (const auto& [name, value] : set) {
    auto setting = study::setting_of(name + "=" + value);
    if (!setting) raise(setting.error());
    request.settings.push_back(std::move(*setting));
  }
  text::Diagnostics sink;
  PyMission out;
  out.file = beside([&](std::stop_token ends) { return MissionFile::load(request, std::move(ends), sink); });
  if (!out.file) raise(sink);
  out.warnings = said_of(sink);
  return out;
}

run::RunSettings settings_of(std::uint64_t seed, int threads, bool proceeds, double patience,
                             const std::string& start_time) {
  const auto clock = start_time.empty() ? cli::wall_clock() : cli::parse_start_time(start_time);
  if (!clock) raise("start_time " + start_time + ": expected YYYY-MM-DD HH:MM or YYYY-MM-DD HH:MM:SS");
  run::RunSettings out;
  out.seed = seed;
  out.threads = threads;
  out.executive.proceed_all = proceeds;
  out.executive.patience = patience;
  out.executive.epoch_seconds = clock->epoch_seconds;
  out.executive.zone_offset = clock->zone_offset;
  return out;
}

std::unique_ptr<PyRun> make_run(const PyMission& mission, std::uint64_t seed, int threads, bool proceeds,
                                double patience, const std::string& start_time, const std::string& record) {
  const run::RunSettings settings = settings_of(seed, threads, proceeds, patience, start_time);
  text::Diagnostics sink;
  auto run = without_lock([&](Signals&) { return mission.file->make_run(settings, sink); });
  if (!run) raise(sink);
  auto out = std::make_unique<PyRun>();
  out->watched = std::make_unique<WatchedRun>(mission.file, std::move(run), record);
  out->watched->execute();
  out->watched->run().look();  // robots that start at once are there
  if (const std::string problem = out->watched->recording_problem(); !problem.empty())
    raise("record " + record + ": " + problem);
  return out;
}

// The run, for as long as nobody else uses it.
struct Use {
  explicit Use(PyRun& held) : lock(held.user.take("this run")), watched(*held.watched), run(watched.run()) {}
  std::unique_lock<std::mutex> lock;
  WatchedRun& watched;
  run::MissionRun& run;

  const fleet::FleetRobot& robot(std::uint32_t id) const {
    const fleet::FleetRobot* const found = run.fleet().find({id});
    if (found == nullptr) raise("there is no robot " + std::to_string(id));
    return *found;
  }
  robot::Workings workings(std::uint32_t id) const {
    const robot::Workings at = robot(id).workings();
    if (!at) raise("robot " + std::to_string(id) + ": its program keeps its values elsewhere");
    return at;
  }
};

void raise_if(const std::optional<std::string>& problem) {
  if (problem) raise(*problem);
}

std::array<double, 3> pose_of(const run::MissionRun& run, const fleet::FleetRobot& robot) {
  if (robot.life == fleet::RobotLife::kNotStarted) return {kNone, kNone, kNone};
  const geom::Pose pose = run.fleet().pose(robot);
  return {pose.position.x, pose.position.y, pose.heading};
}

py::array_t<double> poses(PyRun& held) {
  const Use use(held);
  const auto& robots = use.run.fleet().robots();
  py::array_t<double> out({robots.size(), std::size_t{3}});
  auto rows = out.mutable_unchecked<2>();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const auto pose = pose_of(use.run, robots[i]);
    for (std::size_t k = 0; k < 3; ++k)
      rows(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) = pose[k];
  }
  return out;
}

py::dict robot_of(PyRun& held, std::uint32_t id) {
  const Use use(held);
  const fleet::FleetRobot& robot = use.robot(id);
  const bool is_there = robot.life != fleet::RobotLife::kNotStarted;
  const binding::BodyState body = is_there ? use.run.world().body(robot.body) : binding::BodyState{};
  const auto pose = pose_of(use.run, robot);
  return py::dict("type"_a = robot.type, "life"_a = std::string(fleet::name(robot.life)),
                  "fault"_a = failure_of(robot), "pose"_a = array_of({pose.begin(), pose.end()}),
                  "velocity"_a = array_of({body.velocity.x, body.velocity.y}),
                  "distance"_a = body.distance_driven, "contacts"_a = body.contacts,
                  "in_contact"_a = body.in_contact, "carries"_a = body.carried.value);
}

py::object python_of(const Value& value) {
  if (const auto* parts = std::get_if<std::vector<double>>(&value)) return array_of(*parts);
  return py::cast(value);
}

py::dict ports_of(PyRun& held, std::uint32_t id, const std::string& pattern) {
  const Use use(held);
  const robot::Workings at = use.workings(id);
  py::dict out;
  if (const flow::Port* const port = at.program->find(pattern)) {
    out[py::str(pattern)] = python_of(value_of(at.frame, *port));
    return out;
  }
  for (const flow::Port& port : at.program->ports()) {
    if (text::matches(port.path, pattern)) out[py::str(port.path)] = python_of(value_of(at.frame, port));
  }
  if (out.empty() && pattern != "*") raise(training::no_such_port(*at.program, pattern));
  return out;
}

py::list described(const flow::Program& program) {
  py::list out;
  for (const flow::Port& port : program.ports()) {
    const bool has_limits =
        port.type->kind == flow::TypeKind::kReal || port.type->kind == flow::TypeKind::kInteger;
    out.append(py::dict("path"_a = port.path, "role"_a = name_of(port.role),
                        "type"_a = std::string(port.type->name), "unit"_a = port.unit,
                        "written_in"_a = port.edge_unit.empty() ? port.unit : port.edge_unit,
                        "help"_a = port.help,
                        "low"_a = has_limits && flow::is_limit(port.min) ? py::cast(port.min) : py::none(),
                        "high"_a = has_limits && flow::is_limit(port.max) ? py::cast(port.max) : py::none()));
  }
  return out;
}

/// Rows of numbers over a run, filled as it goes on.
class Trace {
 public:
  Trace(const run::MissionRun& run, const std::vector<std::uint32_t>& robots, std::vector<std::string> ports)
      : run_(run), ports_(std::move(ports)) {
    for (const std::uint32_t id : robots) robots_.push_back({id});
    if (!robots.empty()) return;
    for (const fleet::FleetRobot& robot : run.fleet().robots()) robots_.push_back(robot.id);
  }

  /// @errors  a sentence: a robot has no such port
  std::optional<std::string> prepare() {
    for (const base::RobotId id : robots_) {
      const fleet::FleetRobot* const robot = run_.fleet().find(id);
      if (robot == nullptr) return "there is no robot " + std::to_string(id.value);
      const robot::Workings at = robot->workings();
      if (!at && ports_.empty()) continue;
      if (!at) return "robot " + std::to_string(id.value) + ": its program keeps its values elsewhere";
      auto columns = training::SeenColumns::of(*at.program, ports_, {});
      if (!columns) return "robot " + std::to_string(id.value) + ": " + columns.error();
      for (const training::Column& one : columns->columns()) {
        if (std::ranges::find(names_, one.name) == names_.end()) names_.push_back(one.name);
      }
      columns_.emplace(at.program, std::move(*columns));
    }
    return std::nullopt;
  }

  void note() {
    for (const base::RobotId id : robots_) {
      const fleet::FleetRobot& robot = *run_.fleet().find(id);
      if (robot.life == fleet::RobotLife::kNotStarted) continue;
      const auto pose = pose_of(run_, robot);
      rows_.insert(rows_.end(), {static_cast<double>(run_.cycle()), run_.time(),
                                 static_cast<double>(id.value), pose[0], pose[1], pose[2]});
      const std::size_t first = rows_.size();
      rows_.resize(first + names_.size(), kNone);
      const robot::Workings at = robot.workings();
      const auto found = columns_.find(at.program);
      if (!at || found == columns_.end()) continue;
      row_.resize(found->second.count());
      found->second.read(at.frame, {}, row_.data());
      for (std::size_t i = 0; i < row_.size(); ++i) {
        const auto name = std::ranges::find(names_, found->second.columns()[i].name);
        rows_[first + static_cast<std::size_t>(name - names_.begin())] = row_[i];
      }
    }
  }

  py::tuple result() const {
    std::vector<std::string> names = {"cycle", "time", "robot", "x", "y", "heading"};
    names.insert(names.end(), names_.begin(), names_.end());
    py::array_t<double> out({rows_.size() / names.size(), names.size()});
    std::ranges::copy(rows_, out.mutable_data());
    return py::make_tuple(names, out);
  }

 private:
  const run::MissionRun& run_;
  std::vector<std::string> ports_;
  std::vector<base::RobotId> robots_;
  std::vector<std::string> names_;
  std::map<const flow::Program*, training::SeenColumns> columns_;
  std::vector<double> rows_;
  std::vector<double> row_;
};

py::tuple trace(PyRun& held, std::uint64_t cycles, std::vector<std::string> ports,
                const std::vector<std::uint32_t>& robots, std::uint64_t every) {
  const Use use(held);
  Trace out(use.run, robots, std::move(ports));
  if (auto problem = out.prepare()) raise(*problem);
  without_lock([&](Signals& signals) {
    return use.watched.step(
        cycles, [&] { return signals.wants_end(); },
        [&] {
          if (use.run.cycle() % every == 0) out.note();
        });
  });
  return out.result();
}

std::uint64_t step_run(PyRun& held, std::uint64_t cycles) {
  const Use use(held);
  return without_lock(
      [&](Signals& signals) { return use.watched.step(cycles, [&] { return signals.wants_end(); }); });
}

std::string outcome(PyRun& held) {
  const Use use(held);
  return run::outcome_name(use.run, use.run.is_over() ? run::RunEnd::kByItself : run::RunEnd::kInterrupted);
}

std::string report(PyRun& held) {
  const Use use(held);
  run::Performance cost;
  cost.wall_seconds = cli::steady_seconds() - held.wall_began;
  cost.cpu_seconds = cli::cpu_seconds() - held.cpu_began;
  cost.program_version = cli::kVersion;
  const mission::State& state = use.run.state();
  cost.mission_clock = cli::print({state.options.epoch_seconds, state.options.zone_offset});
  return run::report_json(use.run, cost,
                          use.run.is_over() ? run::RunEnd::kByItself : run::RunEnd::kInterrupted);
}

py::list said(PyRun& held) {
  const Use use(held);
  py::list out;
  for (const WatchedRun::Said& one : use.watched.said())
    out.append(py::make_tuple(one.time, one.kind, one.text));
  return out;
}

void answer(PyRun& held, std::uint32_t question, bool proceed) {
  const Use use(held);
  if (!use.watched.questions().contains(question))
    raise("there is no open question " + std::to_string(question));
  use.watched.answer(question, proceed);
}

// What is read of a run, and time.
void bind_looks(py::class_<PyRun>& run) {
  run.def("step", &step_run)
      .def("trace", &trace)
      .def("poses", &poses)
      .def("robot", &robot_of)
      .def("ports", &ports_of)
      .def("outcome", &outcome)
      .def("report", &report)
      .def("said", &said)
      .def("answer", &answer)
      .def("describe",
           [](PyRun& held, std::uint32_t id) { return described(*Use(held).workings(id).program); })
      .def("time", [](PyRun& held) { return Use(held).run.time(); })
      .def("cycle", [](PyRun& held) { return Use(held).run.cycle(); })
      .def("cycle_duration", [](PyRun& held) { return Use(held).run.cycle_duration(); })
      .def("seed", [](PyRun& held) { return Use(held).run.seed(); })
      .def("is_over", [](PyRun& held) { return Use(held).run.is_over(); })
      .def("is_waiting", [](PyRun& held) { return Use(held).watched.is_waiting(); })
      .def("steps_done", [](PyRun& held) { return Use(held).run.steps_done(); })
      .def("questions", [](PyRun& held) { return Use(held).watched.questions(); })
      .def("robots",
           [](PyRun& held) {
             const Use use(held);
             std::vector<std::uint32_t> out;
             for (const fleet::FleetRobot& robot : use.run.fleet().robots()) out.push_back(robot.id.value);
             return out;
           })
      .def("explain", [](PyRun& held, std::uint32_t id) {
        const Use use(held);
        return use.run.explain(use.robot(id));
      });
}

// What people make robots do.
void bind_interventions(py::class_<PyRun>& run) {
  run.def("set",
          [](PyRun& held, std::uint32_t id, const std::string& port, const std::string& value) {
            const Use use(held);
            use.watched.note_input();
            raise_if(use.run.set_parameter({id}, port, value));
          })
      .def("hold", [](PyRun& held, std::uint32_t id, const std::string& port,
                      const std::string& value) { raise_if(Use(held).run.hold_value({id}, port, value)); })
      .def("release", [](PyRun& held, std::uint32_t id,
                         const std::string& port) { raise_if(Use(held).run.release_value({id}, port)); })
      .def("force", [](PyRun& held, std::uint32_t id, const std::string& sequence, const std::string& state) {
        raise_if(Use(held).run.force_state({id}, sequence, state));
      });
}

// What an operator does, and going back and forth.
void bind_operation(py::class_<PyRun>& run) {
  run.def("order",
          [](PyRun& held, const std::string& line) {
            const Use use(held);
            text::Diagnostics sink;
            if (!without_lock([&](Signals&) { return use.watched.order(line, sink); })) raise(sink);
          })
      .def("abort",
           [](PyRun& held) {
             const Use use(held);
             use.watched.note_input();
             use.run.post(mission::event::Abort{});
           })
      .def("save",
           [](PyRun& held) {
             auto out = Use(held).run.save();
             if (!out) raise(out.error());
             return std::move(*out);
           })
      .def("restore",
           [](PyRun& held, const run::Checkpoint& checkpoint) {
             const Use use(held);
             if (use.watched.is_recorded()) raise("a run that is recorded goes no way but on");
             raise_if(use.run.restore(checkpoint));
             use.watched.note_input();
           })
      .def("end_recording", [](PyRun& held) {
        const std::string problem = Use(held).watched.end_recording();
        if (!problem.empty()) raise("the recording is not whole: " + problem);
      });
}

void bind_run(py::module_& module) {
  py::class_<run::Checkpoint>(module, "Checkpoint")
      .def_property_readonly("time", &run::Checkpoint::time)
      .def_property_readonly("cycle", &run::Checkpoint::cycle)
      .def_property_readonly("bytes", &run::Checkpoint::bytes);
  py::class_<PyRun> run(module, "Run");
  bind_looks(run);
  bind_interventions(run);
  bind_operation(run);
}

}  // namespace

const MissionFile& file_of(const py::object& mission) {
  return *mission.cast<const PyMission&>().file;
}

void bind_missions(py::module_& module) {
  py::class_<PyMission>(module, "Mission")
      .def_property_readonly("path", [](const PyMission& self) { return self.file->path(); })
      .def_property_readonly("name", [](const PyMission& self) { return self.file->crew().mission->name; })
      .def_property_readonly("warnings", [](const PyMission& self) { return self.warnings; })
      .def_property_readonly("robots",
                             [](const PyMission& self) {
                               const mission::Mission& mission = *self.file->crew().mission;
                               py::list out;
                               for (const mission::Robot& robot : mission.robots)
                                 out.append(py::make_tuple(robot.id.value, mission.types[robot.type].name));
                               return out;
                             })
      .def("describe",
           [](const PyMission& self, const std::string& type) -> py::object {
             const run::Crew& crew = self.file->crew();
             for (std::size_t i = 0; i < crew.programs.size(); ++i) {
               if (crew.mission->types[i].name != type) continue;
               if (!crew.programs[i].program) return py::list();
               return described(*crew.programs[i].program);
             }
             raise("the mission has no robots of type `" + type + "`");
           })
      .def("make_run", &make_run);
  module.def("load", &load);
  bind_run(module);
}

}  // namespace mlab::python
