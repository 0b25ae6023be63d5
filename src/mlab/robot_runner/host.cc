#include "mlab/robot_runner/host.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/flow/module_file.h"
#include "mlab/robot_wire/framing.h"
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
    : library_(std::move(components)), version_(std::move(version)) {}

const wire::FromRobot& Host::answer(std::string_view bytes) {
  answer_.clear_body();
  if (bytes.size() > robot_wire::kMaxMessage ||
      !message_.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    refuse("this is no message of the protocol");
  } else if (message_.has_hello()) {
    answer(message_.hello());
  } else if (message_.has_load()) {
    answer(message_.load());
  } else if (message_.has_share()) {
    answer(message_.share());
  } else {
    refuse("this program loads procedures and computes cycles, and does nothing else");
  }
  return answer_;
}

void Host::refuse(std::string why) {
  answer_.mutable_problem()->set_text(std::move(why));
}

void Host::answer(const wire::Hello& hello) {
  if (hello.protocol() != robot_wire::kProtocol) {
    refuse(fmt::format("this program speaks version {} of the protocol, not {}", robot_wire::kProtocol,
                       hello.protocol()));
    return;
  }
  wire::Welcome& welcome = *answer_.mutable_welcome();
  welcome.set_protocol(robot_wire::kProtocol);
  welcome.set_name("mlab-robots");
  welcome.set_version(version_);
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

void Host::answer(const wire::Load& load) {
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
  wire::Loaded& loaded = *answer_.mutable_loaded();
  describe(brought_, components, loaded);
  loaded.set_frame_layout(program_->layout_hash());
  const flow::Frame& frame = program_->initial_frame();
  loaded.set_frame(frame.data(), frame.size());
}

void Host::answer(const wire::Share& share) {
  if (program_ == nullptr) {
    refuse("no network was loaded");
    return;
  }
  auto files = robot_process::accept_share(share);
  if (!files) {
    refuse(files.error());
    return;
  }
  shared_.emplace(std::move(*files));
  brought_.trace(network_, library_, shared_->control());
  answer_.mutable_shared()->set_frame_layout(program_->layout_hash());
}

}  // namespace mlab::robot_runner
