#include "mlab/vehicle/server.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "mlab/vehicle/messages.h"
#include "mlab/vehicle/steering.h"

namespace mlab::vehicle {
namespace {

constexpr double kPartingPatience = 5.0;  // in which it is told to stop once no run drives it any more [s]

// Greater than all numbers of the process before: what answered that one answers nothing of this one.
std::uint64_t first_number(Clock::time_point now) {
  const auto age = std::chrono::duration_cast<std::chrono::microseconds>(now.time_since_epoch()).count();
  return static_cast<std::uint64_t>(std::max<std::int64_t>(age, 0));
}

percept::Action action_of(const wire::VehicleCommand& command) {
  percept::Action out;
  out.drives = command.drives();
  out.velocity = {command.velocity_x(), command.velocity_y(), 0.0};
  out.spins = command.spins();
  out.spin = command.spin();
  return out;
}

}  // namespace

Server::Server(Device& device, std::function<bool()> is_stopped)
    : device_(device), is_stopped_(std::move(is_stopped)) {}

void Server::hear(const std::string& sender, const std::string& body, Clock::time_point now) {
  wire::VehicleCommand command;
  if (!command.ParseFromString(body) || !is_sound(command)) return;
  // There was no such report yet: it would be live once there is one.
  if (command.answers() > reported_ && !command.leaves()) return;
  const bool is_free = session_ == 0 || seconds_between(heard_, now) > kSessionPatience;
  const bool is_drivers = session_ == command.session() && driver_ == sender;
  if (!is_free && !is_drivers) return;
  if (!is_drivers) {
    if (command.leaves()) return;
    session_ = command.session();
    driver_ = sender;
    carried_out_ = 0;
    newest_.Clear();
  }
  heard_ = now;
  driven_ = now;
  if (command.leaves()) {
    session_ = 0;
    return;
  }
  if (command.number() <= newest_.number()) return;
  // A run that was not heard for a while is still under the same word of a person.
  if (const std::pair word(command.session(), command.engagement()); word != engaged_by_) {
    engaged_by_ = word;
    has_driven_ = is_taken_ = false;
    device_.engage(now);
  }
  newest_ = std::move(command);
}

void Server::lose(const std::string& sender) {
  if (session_ != 0 && driver_ == sender) session_ = 0;
}

double Server::age_of(std::uint64_t report, Clock::time_point now) const {
  if (report == 0 || report > reported_ || reported_ - report >= kRemembered)
    return std::numeric_limits<double>::infinity();
  return seconds_between(told_at_[report % kRemembered], now);
}

void Server::stand(std::string why, Clock::time_point now) {
  standing_ = std::move(why);
  command_ = {};
  if (is_stopped_())
    device_.stop_in_emergency(now);
  else
    device_.stop(now);
}

// Empty: it does not have to.
std::string Server::why_it_stands(Readiness readiness, Clock::time_point now) const {
  if (is_stopped_()) return "the emergency stop holds";
  if (is_left_alone(readiness, now)) return "";
  if (session_ == 0) return "no run drives it";
  if (age_of(newest_.answers(), now) > kCommandPatience) return "what its run tells it is too old";
  // Nobody wants it to move: it is not made ready for that either.
  if (!newest_.drives() && readiness != Readiness::kReady) return "its robot does not drive";
  return "";
}

// Somebody has taken it; or no run drives it, and it has been told to stop for a while.
bool Server::is_left_alone(Readiness readiness, Clock::time_point now) const {
  const bool is_nobodys = session_ == 0 && (!driven_ || seconds_between(*driven_, now) > kPartingPatience);
  return is_taken_ || readiness == Readiness::kTaken || is_nobodys;
}

// Not what somebody had before: that is waited for.
void Server::notice_taking(Readiness readiness) {
  is_taken_ = is_taken_ || (session_ != 0 && has_driven_ && readiness == Readiness::kTaken);
}

void Server::work(Clock::time_point now) {
  device_.work(now);
  if (session_ != 0 && seconds_between(heard_, now) > kSessionPatience) session_ = 0;
  if (session_ != 0) driven_ = now;
  const Report& report = device_.report(now);
  if (report.motion) poses_.add(*report.motion);
  const Readiness readiness = report.readiness;
  notice_taking(readiness);
  if (std::string why = why_it_stands(readiness, now); !why.empty()) {
    stand(std::move(why), now);
  } else if (is_left_alone(readiness, now)) {
    standing_ = is_taken_ || readiness == Readiness::kTaken ? "somebody else has taken it" : "";
  } else {
    drive(readiness, now);
  }
}

void Server::drive(Readiness readiness, Clock::time_point now) {
  if (newest_.number() != carried_out_) {
    command_ = command_for(device_.limits(), action_of(newest_), command_, newest_.period());
    carried_out_ = newest_.number();
  }
  standing_.clear();
  has_driven_ = has_driven_ || readiness == Readiness::kReady;
  device_.drive(command_, now);
}

std::string Server::report(Clock::time_point now) {
  if (reported_ == 0) reported_ = first_number(now);
  message_.Clear();
  Report report = device_.report(now);
  for (Scan& scan : report.scans) scan.pose = poses_.at(scan.at);
  encode(report, now, message_);
  const auto told = static_cast<Readiness>(message_.readiness());
  if (is_taken_ && (told == Readiness::kReady || told == Readiness::kStandby)) {
    message_.set_readiness(static_cast<std::uint32_t>(Readiness::kTaken));
    message_.set_why("was taken by somebody else; Replace in the console takes it back");
  }
  message_.set_number(++reported_);
  message_.set_held_by(session_);
  message_.set_command(carried_out_);
  message_.set_is_stopped(is_stopped_());
  told_at_[reported_ % kRemembered] = now;
  return message_.SerializeAsString();
}

}  // namespace mlab::vehicle
