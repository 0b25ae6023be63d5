#include "mlab/robot/runner/host.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/flow/module_file.h"
#include "mlab/robot/wire/network_wire.h"

namespace mlab::robot_runner {
Host::Host(flow::Library components, std::string version)
    : Speaker("mlab-robots", std::move(version)), workings_(std::move(components)) {}

void Host::answer_other(const wire::ToRobot& message) {
  if (message.has_load())
    load(message.load());
  else
    refuse("this program loads procedures and computes cycles, and does nothing else");
}

void Host::begin_sharing(robot_wire::Control& control) {
  workings_.trace(control);
}

bool Host::open_libraries(const wire::Load& load) {
  return std::ranges::all_of(load.libraries(), [this](const std::string& file) {
    const auto behaviors = flow::open_module(file);
    if (behaviors)
      workings_.add(*behaviors);
    else
      refuse(fmt::format("cannot load the compiled procedures: {}", behaviors.error()));
    return behaviors.has_value();
  });
}

void Host::load(const wire::Load& load) {
  if (program() != nullptr) {
    refuse("this program was loaded already");
    return;
  }
  if (load.layout() != robot_wire::shared_layout()) {
    refuse("this program was made with headers of another version than the run");
    return;
  }
  if (!open_libraries(load)) return;
  if (const auto problem = workings_.build(robot_wire::decode(load.network()))) {
    refuse(fmt::format("the network can't be built: {}", *problem));
    return;
  }
  workings_.describe(*reply().mutable_loaded());
}

}  // namespace mlab::robot_runner
