#include "mlab/designer/movement_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/wire.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

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
  const flow::Port* port = out.program ? out.program->find(node) : nullptr;
  if (port == nullptr)
    return no_field(out.program ? fmt::format("`{}` gives no movement", text::shown(node, 200))
                                : sink.items().front().message);
  if (!flow::Program::vector(out.program->initial_frame().data(), *port))
    return no_field(fmt::format("`{}` gives no movement, but {}", text::shown(node, 200), port->type->name));
  return out;
}

std::string field_arrows(const fleet::MissionRun& run, const fleet::FleetRobot& body, bool as_is,
                         const FieldProgram& part, const FieldGrid& grid) {
  const flow::Program& program = *part.program;
  const flow::Port& port = *program.find(part.port);
  flow::Frame start = program.make_frame();
  if (as_is && body.program->program)
    program.take_over(start.data(), *body.program->program, body.frame.data());
  const flow::Needs needs = program.needs(start.data());
  const double heading_cos = std::cos(grid.heading);
  const double heading_sin = std::sin(grid.heading);
  flow::Frame frame = start;
  sim::SenseBuffer buffer;
  std::string out;
  out.reserve(std::size_t{grid.columns} * grid.rows * sizeof(FieldArrow));
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    for (std::uint32_t column = 0; column < grid.columns; ++column) {
      const geom::Pose pose = grid.pose(column, row);
      percept::Percepts percepts;
      percept::Action unwanted;
      run.fleet().perceive_at(body, pose, needs, run.cycle_duration(), buffer, percepts);
      frame = start;
      program.step(frame.data(), percepts, unwanted, run.seed(), body.id.value);
      geom::Vector v = flow::Program::vector(frame.data(), port).value_or(geom::Vector{});
      if (!std::isfinite(v.x + v.y)) v = {};
      console::append(out,
                      FieldArrow{static_cast<float>(pose.position.x), static_cast<float>(pose.position.y),
                                 static_cast<float>(v.x * heading_cos - v.y * heading_sin),
                                 static_cast<float>(v.x * heading_sin + v.y * heading_cos)});
    }
  }
  return out;
}

}  // namespace mlab::designer
