#include "mlab/console/session.h"

#include <utility>

#include "mlab/console.pb.h"
#include "mlab/console/session_parts.h"

namespace mlab::console {

Session::Session(SessionSettings settings, Send send)
    : parts_(std::make_unique<Parts>(std::move(settings), std::move(send))) {}
Session::~Session() = default;

void Session::receive(ConnectionId from, std::unique_ptr<ToServer> message) {
  parts_->receive(from, std::move(message));
}
void Session::closed(ConnectionId connection) {
  parts_->closed(connection);
}
void Session::try_out(Trial trial, TrialDone done) {
  parts_->try_out(std::move(trial), std::move(done));
}
void Session::look_at_run(RunLook look) {
  parts_->look_at_run(std::move(look));
}
void Session::emergency_stop() {
  parts_->emergency_stop();
}
Session::Picture Session::picture(std::uint64_t revision) const {
  return parts_->picture(revision);
}
std::vector<std::string> Session::end() {
  return parts_->end();
}
std::string Session::report() const {
  return parts_->report();
}
bool Session::has_ended() const {
  return parts_->has_ended();
}

}  // namespace mlab::console
