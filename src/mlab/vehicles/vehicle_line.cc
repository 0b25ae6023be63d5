#include "mlab/vehicles/vehicle_line.h"

#include <optional>
#include <utility>

#include "mlab/dds/reader.h"
#include "mlab/dds/waiter.h"
#include "mlab/dds/writer.h"

namespace mlab::vehicles {
namespace {

class DdsLine final : public vehicle::Line {
 public:
  DdsLine(std::shared_ptr<agents::Roster> roster, dds::Waiter waiter, dds::Reader reports,
          dds::Writer commands, std::string name)
      : roster_(std::move(roster)),
        waiter_(std::move(waiter)),
        reports_(std::move(reports)),
        commands_(std::move(commands)),
        name_(std::move(name)) {}

  /// Until it has said where it is, or the time is over.
  void wait(std::chrono::milliseconds patience, const Wondering& wondering) {
    const auto began = std::chrono::steady_clock::now();
    const auto last = began + patience;
    bool has_told = false;
    wire::VehicleReport report;
    while (!report.has_motion() && std::chrono::steady_clock::now() < last) {
      waiter_.wait(std::chrono::milliseconds(20));
      if (!has_told && std::chrono::steady_clock::now() - began > wondering.after) {
        has_told = true;
        wondering.tell();
      }
      first_ = hear();
      // What is no report is told where it is taken.
      if (!first_ || !report.ParseFromString(*first_)) report.Clear();
    }
  }

  std::optional<std::string> hear() override {
    std::optional<std::string> out = std::exchange(first_, std::nullopt);
    const auto vehicle = roster_->sight(name_);
    for (dds::Arrival& one : reports_.take()) {
      const bool is_its = vehicle && one.sender == vehicle->guid && one.key == name_;
      if (one.kind == dds::Arrival::Kind::kMessage && is_its) out = std::move(one.body);
    }
    return out;
  }
  void tell(const wire::VehicleCommand& command) override {
    const auto vehicle = roster_->sight(name_);
    if (!vehicle) return;
    wire::VehicleCommand addressed = command;
    addressed.set_to(vehicle->guid.bytes.data(), vehicle->guid.bytes.size());
    // One that nobody takes is followed by the next.
    static_cast<void>(commands_.write(name_, addressed.SerializeAsString()));
  }

 private:
  std::shared_ptr<agents::Roster> roster_;  // keeps the participant
  dds::Waiter waiter_;
  dds::Reader reports_;
  dds::Writer commands_;
  std::string name_;
  std::optional<std::string> first_;  // what was heard while it waited
};

}  // namespace

std::expected<std::unique_ptr<vehicle::Line>, std::string> open_line(
    const std::shared_ptr<agents::Roster>& roster, const std::string& name,
    std::chrono::milliseconds patience, const Wondering& wondering) {
  auto waiter = dds::Waiter::make();
  if (!waiter) return std::unexpected(waiter.error());
  auto reports = roster->participant().reader(reports_topic(name), dds::ChannelKind::kLivePercepts, *waiter);
  if (!reports) return std::unexpected(reports.error());
  auto commands = roster->participant().writer(commands_topic(name), dds::ChannelKind::kLivePercepts);
  if (!commands) return std::unexpected(commands.error());
  auto out =
      std::make_unique<DdsLine>(roster, std::move(*waiter), std::move(*reports), std::move(*commands), name);
  out->wait(patience, wondering);
  return out;
}

}  // namespace mlab::vehicles
