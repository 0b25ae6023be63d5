#include "mlab/vehicles/vehicle_process.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include <fmt/core.h>

#include "mlab/dds/reader.h"
#include "mlab/dds/waiter.h"
#include "mlab/dds/writer.h"
#include "mlab/text/shown.h"
#include "mlab/vehicle.pb.h"
#include "mlab/vehicle/messages.h"
#include "mlab/vehicle/server.h"
#include "mlab/vehicles/vehicle_line.h"

namespace mlab::vehicles {
namespace {

using vehicle::Clock;

constexpr std::chrono::milliseconds kTick(20);
constexpr std::chrono::milliseconds kReporting(50);
constexpr std::chrono::milliseconds kChecking(1000);
constexpr std::chrono::milliseconds kParting(200);  // in which the device is told to stop

std::string_view word(vehicle::Readiness readiness) {
  constexpr std::array<std::string_view, 7> kWords = {"has no device", "is silent", "is not ready",
                                                      "is ready",      "is faulty", "waits to be driven",
                                                      "is taken"};
  static_assert(kWords.size() == static_cast<std::size_t>(vehicle::kLastReadiness) + 1);
  return kWords[static_cast<std::size_t>(readiness)];
}

class DrivenDevice final : public agents::Companion {
 public:
  DrivenDevice(std::shared_ptr<vehicle::Device> device, std::string name,
               std::shared_ptr<agents::AgentLog> log, dds::Waiter waiter, dds::Reader commands,
               dds::Writer reports, dds::Writer checks, std::function<bool()> is_stopped,
               const dds::Guid& own)
      : own_(own),
        device_(std::move(device)),
        name_(std::move(name)),
        log_(std::move(log)),
        waiter_(std::move(waiter)),
        commands_(std::move(commands)),
        reports_(std::move(reports)),
        checks_(std::move(checks)),
        server_(*device_, std::move(is_stopped)),
        thread_([this](const std::stop_token& stop) { serve(stop); }) {}

  std::size_t robot_count() const override { return is_driven_ ? 1 : 0; }

 private:
  void serve(const std::stop_token& stop) {
    const std::stop_callback wakes(stop, [this] { waiter_.wake(); });
    Clock::time_point next = Clock::now();
    Clock::time_point next_checks = next;
    while (!stop.stop_requested()) {
      waiter_.wait(kTick);
      for (const dds::Arrival& one : commands_.take()) {
        if (one.kind == dds::Arrival::Kind::kMessage && is_for_this(one.body))
          server_.hear(one.sender.text(), one.body, one.noticed);
        if (one.kind == dds::Arrival::Kind::kUnmatched) server_.lose(one.sender.text());
      }
      const Clock::time_point now = Clock::now();
      server_.work(now);
      is_driven_ = server_.is_driven();
      tell(now);
      if (now < next) continue;
      next = now + kReporting;
      // One that nobody takes is followed by the next.
      static_cast<void>(reports_.write(name_, server_.report(now)));
      if (now < next_checks) continue;
      next_checks = now + kChecking;
      static_cast<void>(checks_.write(name_, vehicle::encode(device_->checks(now))));
    }
    const Clock::time_point last = Clock::now() + kParting;
    for (Clock::time_point now = Clock::now(); now < last; now = Clock::now()) {
      device_->work(now);
      device_->stop(now);
      std::this_thread::sleep_for(kTick);
    }
  }

  bool is_for_this(const std::string& body) const {
    wire::VehicleCommand command;
    return command.ParseFromString(body) && std::ranges::equal(command.to(), own_.bytes, {}, [](char one) {
             return static_cast<std::uint8_t>(one);
           });
  }

  // What has changed, for people.
  void tell(Clock::time_point now) {
    for (const std::string& one : device_->take_news()) log_->add(text::shown(one, 200));
    const vehicle::Report& report = device_->report(now);
    const std::string state =
        fmt::format("{}{}", word(report.readiness), report.why.empty() ? "" : ": it " + report.why);
    if (state != told_state_) log_->add(fmt::format("the vehicle {}", state));
    told_state_ = state;
    if (is_driven_ != told_driven_) log_->add(is_driven_ ? "a run drives it" : "no run drives it any more");
    told_driven_ = is_driven_;
    const std::string& standing = is_driven_ ? server_.standing() : kNothing;
    if (standing != told_standing_ && !standing.empty()) log_->add(fmt::format("it stands: {}", standing));
    told_standing_ = standing;
  }

  inline static const std::string kNothing;
  dds::Guid own_;
  std::shared_ptr<vehicle::Device> device_;
  std::string name_;
  std::shared_ptr<agents::AgentLog> log_;
  dds::Waiter waiter_;
  dds::Reader commands_;
  dds::Writer reports_;
  dds::Writer checks_;
  vehicle::Server server_;
  std::atomic<bool> is_driven_ = false;
  std::string told_state_;
  std::string told_standing_;
  bool told_driven_ = false;
  std::jthread thread_;
};

}  // namespace

agents::OfferedVehicle offer(std::shared_ptr<vehicle::Device> device, std::string name,
                             std::shared_ptr<agents::AgentLog> log) {
  agents::OfferedVehicle out;
  out.said = vehicle::offered(device->name(), device->limits(), device->is_simulated());
  out.begin = [device = std::move(device), name = std::move(name), log = std::move(log)](
                  dds::Participant& participant, std::function<bool()> is_stopped)
      -> std::expected<std::unique_ptr<agents::Companion>, std::string> {
    auto waiter = dds::Waiter::make();
    if (!waiter) return std::unexpected(waiter.error());
    auto commands = participant.reader(commands_topic(name), dds::ChannelKind::kLivePercepts, *waiter);
    if (!commands) return std::unexpected(commands.error());
    auto reports = participant.writer(reports_topic(name), dds::ChannelKind::kLivePercepts);
    if (!reports) return std::unexpected(reports.error());
    auto checks = participant.writer(checks_topic(name), dds::ChannelKind::kLivePercepts);
    if (!checks) return std::unexpected(checks.error());
    return std::make_unique<DrivenDevice>(device, name, log, std::move(*waiter), std::move(*commands),
                                          std::move(*reports), std::move(*checks), std::move(is_stopped),
                                          participant.guid());
  };
  return out;
}

}  // namespace mlab::vehicles
