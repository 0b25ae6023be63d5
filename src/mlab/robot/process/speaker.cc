#include "mlab/robot/process/speaker.h"

#include <fmt/core.h>

#include "mlab/robot/wire/framing.h"

namespace mlab::robot_process {

const wire::FromRobot& Speaker::answer(std::string_view bytes) {
  answer_.clear_body();
  if (bytes.size() > robot_wire::kMaxMessage ||
      !message_.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    refuse("this is no message of the protocol");
  } else if (message_.has_hello()) {
    answer_hello(message_.hello());
  } else if (message_.has_share()) {
    answer_share(message_.share());
  } else {
    answer_other(message_);
  }
  return answer_;
}

void Speaker::answer_hello(const wire::Hello& hello) {
  if (hello.protocol() != robot_wire::kProtocol) {
    refuse(fmt::format("this program speaks version {} of the protocol, not {}", robot_wire::kProtocol,
                       hello.protocol()));
    return;
  }
  wire::Welcome& welcome = *answer_.mutable_welcome();
  welcome.set_protocol(robot_wire::kProtocol);
  welcome.set_name(name_);
  welcome.set_version(version_);
  if (!reveals()) return;
  welcome.set_layout(robot_wire::shared_layout());
  welcome.set_source(source());
}

void Speaker::answer_share(const wire::Share& share) {
  if (program() == nullptr) {
    refuse("no network was loaded");
    return;
  }
  if (share.layout() != robot_wire::shared_layout()) {
    refuse("this program was made with headers of another version than the run");
    return;
  }
  auto files = SharedFiles::open(robot_wire::kFramesDescriptor, robot_wire::kPerceptsDescriptor);
  if (!files) {
    refuse(files.error());
    return;
  }
  shared_.emplace(std::move(*files));
  begin_sharing(shared_->control());
  answer_.mutable_shared()->set_frame_layout(program()->layout_hash());
}

}  // namespace mlab::robot_process
