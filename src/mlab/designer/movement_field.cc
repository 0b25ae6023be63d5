#include "mlab/designer/movement_field.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/console/wire.h"
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
    : part_(std::move(part)),
      grid_(grid),
      as_is_(as_is),
      port_(part_.program->find(part_.port)),
      start_(part_.program->make_frame()),
      frame_(start_) {
  if (part_.hosted) hosted_ = std::make_unique<robot_host::HostedCycle>(part_.hosted, true);
}

void FieldReading::begin(const fleet::FleetRobot& body) {
  const flow::Program& program = *part_.program;
  if (as_is_ && body.workings().program)
    program.take_over(start_.data(), *body.workings().program, body.workings().frame);
  needs_ = program.needs(start_.data());
  arrows_.reserve(std::size_t{grid_.columns} * grid_.rows * sizeof(FieldArrow));
}

bool FieldReading::read(const fleet::MissionRun& run, const fleet::FleetRobot& body, double budget) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(budget);
  const std::uint32_t count = grid_.columns * grid_.rows;
  if (next_ == 0) begin(body);
  while (next_ < count) {
    if (hosted_)
      read_hosted(run, body);
    else
      read_place(run, body);
    if (next_ % kPlacesAtOnce == 0 && Clock::now() >= end) break;
  }
  return next_ == count;
}

percept::Percepts FieldReading::perceive(const fleet::MissionRun& run, const fleet::FleetRobot& body,
                                         std::uint32_t place) const {
  const geom::Pose pose = grid_.pose(place % grid_.columns, place / grid_.columns);
  return run.fleet().perceive_at(body, pose, needs_, run.cycle_duration());
}

void FieldReading::add_arrow(const geom::Pose& pose, const std::byte* frame) {
  geom::Vector v = flow::Program::vector(frame, *port_).value_or(geom::Vector{});
  if (!std::isfinite(v.x + v.y)) v = {};
  const double c = std::cos(grid_.heading);
  const double s = std::sin(grid_.heading);
  console::append(arrows_,
                  FieldArrow{static_cast<float>(pose.position.x), static_cast<float>(pose.position.y),
                             static_cast<float>(v.x * c - v.y * s), static_cast<float>(v.x * s + v.y * c)});
}

void FieldReading::read_place(const fleet::MissionRun& run, const fleet::FleetRobot& body) {
  const percept::Percepts percepts = perceive(run, body, next_);
  percept::Action unwanted;
  frame_ = start_;
  part_.program->step(frame_.data(), percepts, unwanted, run.seed(), body.id.value);
  add_arrow(percepts.pose, frame_.data());
  ++next_;
}

// Some places at once, as if a robot stood at each. Where the program ends its process, it moves nobody
// there.
void FieldReading::read_hosted(const fleet::MissionRun& run, const fleet::FleetRobot& body) {
  const std::uint32_t count = std::min(kPlacesAtOnce, grid_.columns * grid_.rows - next_);
  std::vector<geom::Pose> poses;
  hosted_->begin();
  for (std::uint32_t i = 0; i < count; ++i) hosted_->join(body.id.value, run.seed());
  hosted_->open();
  for (std::uint32_t i = 0; i < count; ++i) {
    const percept::Percepts percepts = perceive(run, body, next_ + i);
    poses.push_back(percepts.pose);
    hosted_->set(i, percepts, {start_.data(), start_.size()});
  }
  hosted_->ask();
  hosted_->wait({});
  for (std::uint32_t i = 0; i < count; ++i) {
    percept::Action unwanted;
    const robot_host::HostedCycle::Outcome outcome = hosted_->take(i, unwanted);
    add_arrow(poses[i], outcome.failure.empty() ? outcome.frame.data() : start_.data());
  }
  next_ += count;
}

std::string field_arrows(const fleet::MissionRun& run, const fleet::FleetRobot& body, bool as_is,
                         const FieldProgram& part, const FieldGrid& grid) {
  FieldReading reading(part, grid, as_is);
  reading.read(run, body, 1e9);
  return reading.arrows();
}

}  // namespace mlab::designer
