#include "mlab/designer/designer.h"

#include <utility>

#include "mlab/designer/session/core.h"

namespace mlab::designer {

Designer::Designer(DesignerSettings settings, Send send)
    : core_(std::make_unique<DesignerCore>(std::move(settings), std::move(send))) {}
Designer::~Designer() = default;

void Designer::receive(console::ConnectionId from, std::unique_ptr<ToDesigner> message) {
  core_->receive(from, std::move(message));
}
std::vector<std::string> Designer::end() {
  return core_->end();
}
void Designer::closed(console::ConnectionId connection) {
  core_->closed(connection);
}

}  // namespace mlab::designer
