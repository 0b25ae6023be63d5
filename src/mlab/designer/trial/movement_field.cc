#include "mlab/designer/trial/movement_field.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/console/published/wire.h"
#include "mlab/flow/carry_over.h"
#include "mlab/robot/program/places.h"
#include "mlab/run/places.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

constexpr std::uint32_t kPlacesAtOnce = 8;  // between two looks at the clock

struct FieldArrow {
  float x, y, dx, dy;
};

std::unexpected<text::Diagnostic> no_field(std::string message) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, "no-field", std::move(message), {}, {}, {}, {}});
}

double between(double low, double high, std::uint32_t at, std::uint32_t count) {
  return count < 2 ? (low + high) / 2.0 : low + (high - low) * static_cast<double>(at) / (count - 1);
}

}  // namespace

geom::Pose FieldGrid::pose(std::uint32_t column, std::uint32_t row) const {
  return {{between(x_min, x_max, column, columns), between(y_min, y_max, row, rows)}, heading};
}

text::Result<FieldProgram> field_program(flow::Network network, const flow::Library& library,
                                         const std::string& node) {
  const auto found = std::ranges::find(network.nodes, node, &flow::Node::name);
  if (found == network.nodes.end())
    return no_field(fmt::format("no robot runs `{}`", text::shown(node, 200)));
  // Nothing is evaluated but what this node needs: actuators, which are evaluated for their own sake, go.
  for (flow::Node& one : network.nodes) one.is_public = one.name == node;
  std::erase_if(network.nodes, [&](const flow::Node& one) {
    const flow::Behavior* behavior =
        one.kind == flow::Node::Kind::kBehavior ? library.find(one.behavior).behavior : nullptr;
    return behavior != nullptr && behavior->output == nullptr;
  });
  text::Diagnostics sink;
  FieldProgram out{flow::build_program(network, library, sink), node};
  out.network = std::move(network);
  const flow::Port* port = out.program ? out.program->find(node) : nullptr;
  if (port == nullptr)
    return no_field(out.program ? fmt::format("`{}` gives no movement", text::shown(node, 200))
                                : sink.items().front().message);
  if (!flow::Program::vector(out.program->initial_frame().data(), *port))
    return no_field(fmt::format("`{}` gives no movement, but {}", text::shown(node, 200), port->type->name));
  return out;
}

FieldReading::FieldReading(FieldProgram part, FieldGrid grid, bool as_is)
    : program_{.name = part.port, .program = std::move(part.program), .hosted = std::move(part.hosted)},
      places_(robot::places_of(part.network)),
      port_(program_.program->find(part.port)),
      grid_(grid),
      as_is_(as_is),
      start_(program_.program->make_frame()) {
  program_.initial = start_;
}

void FieldReading::begin(const run::MissionRun& run, const fleet::FleetRobot& body) {
  const flow::Program& program = *program_.program;
  const robot::Workings robot = body.workings();
  // What a stranger's process has left may be anything, and our own code would stand on it.
  const bool is_trusted = program_.hosted || (body.program != nullptr && !body.program->hosted);
  as_is_ = as_is_ && robot && is_trusted;
  find_places(run);
  if (as_is_ && robot.program != nullptr) {
    // What the mission has set counts as set, like what somebody sets while it runs.
    start_ = flow::carry_over({*robot.program, robot.program->initial_frame()}, robot.frame,
                              {program, start_}, program_.hosted != nullptr)
                 .frame;
  }
  needs_ = program.needs(start_.data());
  runners_.emplace(run.seed(), 1);
  runner_ = runners_->runner_of(program_);
  for (std::uint32_t i = 0; i < kPlacesAtOnce; ++i) {
    robots_.push_back(runner_->add(body.id, program_));
    static_cast<void>(runner_->start(robots_.back()));  // who does not start moves nobody
  }
  arrows_.reserve(std::size_t{grid_.columns} * grid_.rows * sizeof(FieldArrow));
}

// Where they are in the mission, as for its robots.
void FieldReading::find_places(const run::MissionRun& run) {
  const run::MissionPlaces known(run.mission());
  for (const robot::PlaceParameter& one : places_) {
    const flow::Port* port = program_.program->find(one.path);
    if (port == nullptr) continue;
    if (const std::optional<geom::Point> point = known.find(one.name)) {
      program_.program->set(start_.data(), *port, robot::point_words(*point));
    } else if (!as_is_ && problem_.empty()) {
      problem_ = fmt::format("the mission has no place `{}`", text::shown(one.name, 200));
    }
  }
}

bool FieldReading::read(const run::MissionRun& run, const fleet::FleetRobot& body, double budget) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(budget);
  const std::uint32_t count = grid_.columns * grid_.rows;
  if (!runners_) begin(run, body);
  if (!problem_.empty()) return true;
  while (next_ < count) {
    read_places(run, body);
    if (Clock::now() >= end) break;
  }
  return next_ == count;
}

// Some places at once, as if a robot stood at each. Where the program ends its process, it moves nobody
// there.
void FieldReading::read_places(const run::MissionRun& run, const fleet::FleetRobot& body) {
  struct Outcome {
    percept::Action action;
    std::string fault;
    std::string failure;
  };
  std::array<Outcome, kPlacesAtOnce> unwanted;
  const std::uint32_t count = std::min(kPlacesAtOnce, grid_.columns * grid_.rows - next_);
  for (std::uint32_t i = 0; i < count; ++i) {
    runner_->restore(robots_[i], start_);
    runner_->join(robots_[i]);
  }
  runner_->open();
  for (std::uint32_t i = 0; i < count; ++i) {
    const percept::Percepts percepts =
        run.fleet().perceive_at(body, pose_of(next_ + i), needs_, run.cycle_duration());
    const robot::ProgramRunner::Turn turn{robots_[i], &percepts, &unwanted[i].action, &unwanted[i].fault,
                                          &unwanted[i].failure};
    runner_->act({&turn, 1});
  }
  runner_->ask();
  runner_->wait({});
  for (std::uint32_t i = 0; i < count; ++i) add_arrow(next_ + i);
  next_ += count;
}

void FieldReading::add_arrow(std::uint32_t place) {
  const robot::Workings robot = runner_->workings(robots_[place % kPlacesAtOnce]);
  geom::Vector v = flow::Program::vector(robot.frame, *port_).value_or(geom::Vector{});
  if (!std::isfinite(v.x + v.y)) v = {};
  const double c = std::cos(grid_.heading);
  const double s = std::sin(grid_.heading);
  const geom::Point at = pose_of(place).position;
  console::append(arrows_,
                  FieldArrow{static_cast<float>(at.x), static_cast<float>(at.y),
                             static_cast<float>(v.x * c - v.y * s), static_cast<float>(v.x * s + v.y * c)});
}

text::Result<std::string> field_arrows(const run::MissionRun& run, const fleet::FleetRobot& body, bool as_is,
                                       const FieldProgram& part, const FieldGrid& grid) {
  FieldReading reading(part, grid, as_is);
  reading.read(run, body, 1e9);
  if (!reading.problem().empty()) return no_field(reading.problem());
  return reading.arrows();
}

}  // namespace mlab::designer
