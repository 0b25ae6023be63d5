#include "mlab/console/session.h"

#include <utility>

#include "mlab/console.pb.h"
#include "mlab/console/session/core.h"

namespace mlab::console {

Session::Session(SessionSettings settings, Send send)
    : core_(std::make_unique<SessionCore>(std::move(settings), std::move(send))) {}
Session::~Session() = default;

void Session::receive(ConnectionId from, std::unique_ptr<ToServer> message) {
  core_->receive(from, std::move(message));
}
void Session::closed(ConnectionId connection) {
  core_->closed(connection);
}
void Session::try_out(Trial trial, TrialDone done) {
  core_->try_out(std::move(trial), std::move(done));
}
void Session::look_at_run(RunLook look) {
  core_->look_at_run(std::move(look));
}
void Session::emergency_stop() {
  core_->emergency_stop();
}
Session::Picture Session::picture(std::uint64_t revision) const {
  return core_->picture(revision);
}

Session::Picture Session::tile(std::uint32_t zoom, std::uint32_t column, std::uint32_t row) const {
  return core_->tile(zoom, column, row);
}
std::vector<std::string> Session::end() {
  return core_->end();
}
std::string Session::report() const {
  return core_->report();
}
void Session::tell_metrics(metrics::Exposition& out) const {
  core_->tell_metrics(out);
}
bool Session::has_ended() const {
  return core_->has_ended();
}

}  // namespace mlab::console
