#include "mlab/robot/process/workings.h"

#include <set>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/robot/wire/framing.h"
#include "mlab/text/diagnostic.h"

namespace mlab::robot_process {

std::optional<std::string> Workings::build(flow::Network network) {
  network_ = std::move(network);
  text::Diagnostics sink;
  program_ = flow::build_program(network_, library_, sink);
  if (program_ == nullptr) return text::render(sink);
  if (program_->frame_size() <= robot_wire::kMaxFrame) return std::nullopt;
  return fmt::format("the values of a robot take up {} MB, and at most {} are possible",
                     program_->frame_size() >> 20, robot_wire::kMaxFrame >> 20);
}

void Workings::describe(wire::Loaded& out) const {
  std::set<std::string_view> types;
  const auto add_type = [&](const flow::TypeInfo* type) {
    if (type == nullptr || components_.find_type(type->name) != nullptr || !types.insert(type->name).second)
      return;
    wire::CompiledType& described = *out.add_types();
    described.set_name(std::string(type->name));
    described.set_size(type->size);
    described.set_alignment(type->alignment);
  };
  for (const flow::Behavior& behavior : brought_.behaviors()) {
    wire::CompiledBehavior& described = *out.add_behaviors();
    described.set_name(std::string(behavior.name));
    described.set_state_size(behavior.state_size);
    described.set_state_alignment(behavior.state_alignment);
    described.set_has_header(behavior.has_header);
    add_type(behavior.output);
    for (const flow::Input& input : behavior.inputs) add_type(input.type);
  }
  out.set_frame_layout(program_->layout_hash());
  const flow::Frame& frame = program_->initial_frame();
  out.set_frame(frame.data(), frame.size());
}

}  // namespace mlab::robot_process
