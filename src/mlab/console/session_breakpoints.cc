#include <utility>

#include <fmt/core.h>

#include "mlab/console/session_parts.h"

namespace mlab::console {

Session::Parts::Answered Session::Parts::set_breakpoint(const std::string& who, const SetBreakpoint& set,
                                                        Reply& reply) {
  std::string error;
  const std::uint32_t id = breakpoints_.set(set.breakpoint(), error);
  if (id == 0) return error;
  reply.set_breakpoint(id);
  if (set.breakpoint().id() == 0) note(who, fmt::format("breakpoint {}", id));
  return std::nullopt;
}

Session::Parts::Answered Session::Parts::remove_breakpoint(const std::string& who,
                                                           const RemoveBreakpoint& remove) {
  if (!breakpoints_.remove(remove.id())) return fmt::format("there is no breakpoint {}", remove.id());
  note(who, remove.id() == 0 ? "remove all breakpoints" : fmt::format("remove breakpoint {}", remove.id()));
  return std::nullopt;
}

bool Session::Parts::step_once() {
  halted_.Clear();
  if (live_->step() != fleet::MissionRun::Progress::kStepped) return false;
  ++version_;
  if (breakpoints_.are_on()) look_at_breakpoints();
  return true;
}

void Session::Parts::look_at_breakpoints() {
  breakpoints_.look(live_->run(), halted_);
  if (halted_.hits().empty()) return;
  for (const Halted::Hit& hit : halted_.hits())
    log_.add(sim_time(), {Log::BREAKPOINT, hit.text(), hit.robot(), "", {}, false});
  const mission::State& state = live_->run().state();
  if (state.mode == mission::State::Mode::kRunning && !state.paused) post(mission::event::Pause{});
}

void Session::Parts::publish_breakpoints() {
  ToBrowser out;
  if (breakpoints_.take_news()) {
    breakpoints_.encode(*out.mutable_breakpoints());
    broadcast(out);
  }
  // Whatever makes the run go on ends the halt.
  const bool stands = live_ && live_->run().state().paused;
  if (!stands) halted_.Clear();
  std::string bytes = halted_.SerializeAsString();
  if (bytes == halted_told_) return;
  halted_told_ = std::move(bytes);
  *out.mutable_halted() = halted_;
  broadcast(out);
}

void Session::Parts::greet_with_breakpoints(ConnectionId to) {
  ToBrowser out;
  breakpoints_.encode(*out.mutable_breakpoints());
  send(to, out);
  if (halted_.hits().empty()) return;
  *out.mutable_halted() = halted_;
  send(to, out);
}

}  // namespace mlab::console
