#include "mlab/robot_process/speaker.h"

namespace mlab::robot_process {

std::expected<SharedFiles, std::string> accept_share(const wire::Share& share) {
  if (share.layout() != robot_wire::shared_layout())
    return std::unexpected("this program was made with headers of another version than the run");
  return SharedFiles::open(robot_wire::kFramesDescriptor, robot_wire::kPerceptsDescriptor);
}

}  // namespace mlab::robot_process
