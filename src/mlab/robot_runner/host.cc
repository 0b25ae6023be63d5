#include "mlab/robot_runner/host.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/flow/module_file.h"
#include "mlab/robot_wire/network_wire.h"
#include "mlab/text/diagnostic.h"

namespace mlab::robot_runner {
namespace {

void describe(const robot_process::TracedLibrary& brought, const flow::Library& components,
              wire::Loaded& out) {
  std::set<std::string_view> types;
  const auto add_type = [&](const flow::TypeInfo* type) {
    if (type == nullptr || components.find_type(type->name) != nullptr || !types.insert(type->name).second)
      return;
    wire::CompiledType& described = *out.add_types();
    described.set_name(std::string(type->name));
    described.set_size(type->size);
    described.set_alignment(type->alignment);
  };
  for (const flow::Behavior& behavior : brought.behaviors()) {
    wire::CompiledBehavior& described = *out.add_behaviors();
    described.set_name(std::string(behavior.name));
    described.set_state_size(behavior.state_size);
    described.set_state_alignment(behavior.state_alignment);
    described.set_has_header(behavior.has_header);
    add_type(behavior.output);
    for (const flow::Input& input : behavior.inputs) add_type(input.type);
  }
}

}  // namespace

Host::Host(flow::Library components, std::string version)
    : Speaker("mlab-robots", std::move(version)), library_(std::move(components)) {}

void Host::answer_other(const wire::ToRobot& message) {
  if (message.has_load())
    load(message.load());
  else
    refuse("this program loads procedures and computes cycles, and does nothing else");
}

void Host::begin_sharing(robot_wire::Control& control) {
  brought_.trace(network_, library_, control);
}

bool Host::open_libraries(const wire::Load& load) {
  return std::ranges::all_of(load.libraries(), [this](const std::string& file) {
    const auto behaviors = flow::open_module(file);
    if (behaviors)
      brought_.add(*behaviors, library_);
    else
      refuse(fmt::format("cannot load the compiled procedures: {}", behaviors.error()));
    return behaviors.has_value();
  });
}

void Host::load(const wire::Load& load) {
  if (program_ != nullptr) {
    refuse("this program was loaded already");
    return;
  }
  if (load.layout() != robot_wire::shared_layout()) {
    refuse("this program was made with headers of another version than the run");
    return;
  }
  const flow::Library components = library_;
  if (!open_libraries(load)) return;
  network_ = robot_wire::decode(load.network());
  text::Diagnostics sink;
  program_ = flow::build_program(network_, library_, sink);
  if (program_ == nullptr) {
    refuse(fmt::format("the network can't be built: {}", text::render(sink)));
    return;
  }
  wire::Loaded& loaded = *reply().mutable_loaded();
  describe(brought_, components, loaded);
  loaded.set_frame_layout(program_->layout_hash());
  const flow::Frame& frame = program_->initial_frame();
  loaded.set_frame(frame.data(), frame.size());
}

}  // namespace mlab::robot_runner
