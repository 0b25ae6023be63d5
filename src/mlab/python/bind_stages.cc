#include <algorithm>
#include <span>

#include "mlab/cli/bench_networks.h"
#include "mlab/cli/places.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/python/bindings.h"
#include "mlab/python/mission_file.h"
#include "mlab/training/mission_stage.h"
#include "mlab/training/scenario_stage.h"

namespace mlab::python {
namespace {

using namespace pybind11::literals;
using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A stage that Python has.
struct PyStage {
  std::unique_ptr<training::Stage> stage;
  OneUser user;

  ~PyStage() { leave_where_forked(user, stage); }
};

std::unique_ptr<PyStage> held(std::expected<std::unique_ptr<training::Stage>, std::string> made) {
  if (!made) raise(made.error());
  auto out = std::make_unique<PyStage>();
  out->stage = std::move(*made);
  return out;
}

std::shared_ptr<const flow::Program> program_of(const std::string& control) {
  text::Diagnostics sink;
  text::SourcePtr source;
  if (control == "schemas" || control == "diffusion" || control == "steered") {
    const char* const text = control == "schemas"     ? cli::kSchemasNetwork
                             : control == "diffusion" ? cli::kDiffusionNetwork
                                                      : cli::kSteeredNetwork;
    source = std::make_shared<const text::Source>(control + ".cnl", text);
  } else {
    auto read = text::read_source(control);
    if (!read) raise(read.error());
    source = std::move(*read);
  }
  flow::Network network = cnl::elaborate(cnl::load(source, sink), sink);
  network.name = control;
  auto out = sink.has_errors() ? nullptr : flow::build_program(network, robot::component_library(), sink);
  if (!out) raise(sink);
  return out;
}

std::unique_ptr<PyStage> scenario_stage(const std::string& control, std::uint32_t robots,
                                        std::uint64_t places, double range, double cycle_duration,
                                        int threads, const std::vector<std::string>& seen,
                                        const std::vector<std::string>& acted) {
  const training::ScenarioSettings settings{.robots = robots,
                                            .places = places,
                                            .range = range,
                                            .cycle_duration = cycle_duration,
                                            .threads = threads};
  auto program = program_of(control);
  return held(without_lock(
      [&](Signals&) { return training::make_scenario_stage(settings, std::move(program), seen, acted); }));
}

/// @param settings  of its runs, but for the seed
training::RunMaker maker_of(std::shared_ptr<const MissionFile> file, const run::RunSettings& settings) {
  return [file = std::move(file),
          settings](std::uint64_t seed) -> std::expected<std::unique_ptr<run::MissionRun>, std::string> {
    run::RunSettings own = settings;
    own.seed = seed;
    text::Diagnostics sink;
    auto out = file->make_run(own, sink);
    if (out) return out;
    return std::unexpected(sink.items().empty() ? "the mission can't be read" : sink.items().front().message);
  };
}

std::unique_ptr<PyStage> mission_stage(const MissionFile& file, int threads, double patience,
                                       const std::vector<std::uint32_t>& robots,
                                       const std::vector<std::string>& seen,
                                       const std::vector<std::string>& acted) {
  run::RunSettings settings;
  settings.threads = threads;
  settings.executive.proceed_all = true;
  settings.executive.patience = patience;
  std::vector<base::RobotId> ids;
  for (const std::uint32_t id : robots) ids.push_back({id});
  return held(without_lock([&](Signals&) {
    return training::make_mission_stage(maker_of(file.shared_from_this(), settings), std::move(ids), seen,
                                        acted);
  }));
}

py::list columns_of(const std::vector<training::Column>& columns) {
  py::list out;
  for (const training::Column& one : columns)
    out.append(py::dict("name"_a = one.name, "unit"_a = one.unit, "help"_a = one.help, "low"_a = one.low,
                        "high"_a = one.high));
  return out;
}

// As many rows as robots, as many columns as there are to act by.
std::span<const double> rows_of(const training::Stage& stage, const Rows& actions) {
  const auto robots = static_cast<py::ssize_t>(stage.robots().size());
  const auto columns = static_cast<py::ssize_t>(stage.acted().size());
  if (actions.ndim() != 2 || actions.shape(0) != robots || actions.shape(1) != columns) {
    const std::string shape = py::str(actions.attr("shape"));
    raise("the action has the shape " + shape + "; expected (" + std::to_string(robots) + ", " +
          std::to_string(columns) +
          "): a row for each robot, a column for each number that it is steered by");
  }
  return {actions.data(), static_cast<std::size_t>(actions.size())};
}

py::array_t<double> room_for(const training::Stage& stage) {
  return py::array_t<double>({stage.robots().size(), stage.seen().size()});
}

py::array_t<double> observe(PyStage& self) {
  const auto use = self.user.take("this environment");
  py::array_t<double> out = room_for(*self.stage);
  self.stage->observe({out.mutable_data(), static_cast<std::size_t>(out.size())});
  return out;
}

void reset_stage(PyStage& self, std::uint64_t seed) {
  const auto use = self.user.take("this environment");
  const auto problem = without_lock([&](Signals&) { return self.stage->reset(seed); });
  if (problem) raise(*problem);
}

py::array_t<double> step_stage(PyStage& self, const Rows& actions) {
  const auto use = self.user.take("this environment");
  training::Stage& stage = *self.stage;
  const std::span<const double> rows = rows_of(stage, actions);
  py::array_t<double> out = room_for(stage);
  const std::span<double> seen{out.mutable_data(), static_cast<std::size_t>(out.size())};
  const auto problem = without_lock([&](Signals& signals) {
    // Only what has not answered for long is ever given up.
    const auto began = std::chrono::steady_clock::now();
    return stage.step(
        rows,
        [&] {
          return std::chrono::steady_clock::now() - began > std::chrono::milliseconds(500) &&
                 signals.wants_end();
        },
        seen);
  });
  if (problem) raise(*problem);
  return out;
}

py::array_t<bool> ended(PyStage& self) {
  const auto use = self.user.take("this environment");
  std::vector<std::uint8_t> out(self.stage->robots().size());
  self.stage->ended(out);
  py::array_t<bool> array(static_cast<py::ssize_t>(out.size()));
  std::ranges::transform(out, array.mutable_data(), [](std::uint8_t one) { return one != 0; });
  return array;
}

}  // namespace

void bind_stages(py::module_& module) {
  py::class_<PyStage>(module, "Stage")
      .def("reset", &reset_stage)
      .def("step", &step_stage)
      .def("observe", &observe)
      .def("ended", &ended)
      .def("seen", [](const PyStage& self) { return columns_of(self.stage->seen()); })
      .def("acted", [](const PyStage& self) { return columns_of(self.stage->acted()); })
      .def("robots",
           [](const PyStage& self) {
             std::vector<std::uint32_t> out;
             for (const base::RobotId id : self.stage->robots()) out.push_back(id.value);
             return out;
           })
      .def("is_over", [](PyStage& self) { return self.user.take("this environment"), self.stage->is_over(); })
      .def("time", [](PyStage& self) { return self.user.take("this environment"), self.stage->time(); })
      .def("cycle", [](PyStage& self) { return self.user.take("this environment"), self.stage->cycle(); })
      .def("cycle_duration", [](const PyStage& self) { return self.stage->cycle_duration(); });
  module.def("scenario_stage", &scenario_stage);
  module.def(
      "mission_stage",
      [](const py::object& mission, int threads, double patience, const std::vector<std::uint32_t>& robots,
         const std::vector<std::string>& seen, const std::vector<std::string>& acted) {
        return mission_stage(file_of(mission), threads, patience, robots, seen, acted);
      });
}

}  // namespace mlab::python
