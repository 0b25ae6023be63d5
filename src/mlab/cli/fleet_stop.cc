#include "mlab/cli/fleet_stop.h"

#include <utility>
#include <vector>

#include "mlab/agents/agent_process.h"
#include "mlab/agents/stop_switch.h"

namespace mlab::cli {
namespace {

class FleetStopLine final : public run::StopLine {
 public:
  explicit FleetStopLine(std::unique_ptr<agents::StopSwitch> all) : all_(std::move(all)) {}
  State state() const override {
    agents::StopState state = all_->state();
    return {state.is_engaged, std::move(state.by)};
  }
  void engage() override { all_->engage(stopping_person()); }
  void release() override { all_->release(stopping_person()); }
  std::vector<std::string> unreached() const override {
    std::vector<std::string> out;
    for (agents::StopSwitch::Unreached& one : all_->unreached()) out.push_back(std::move(one.name));
    return out;
  }
  void tell(std::function<void()> changed) override { all_->tell(std::move(changed)); }

 private:
  std::unique_ptr<agents::StopSwitch> all_;
};

}  // namespace

std::string stopping_person() {
  std::string name = agents::machine_name();
  return name.empty() ? "somebody" : name;
}

std::expected<std::shared_ptr<run::StopLine>, std::string> fleet_stop_line(
    std::shared_ptr<agents::Roster> roster) {
  auto all = agents::StopSwitch::open(std::move(roster));
  if (!all) return std::unexpected(all.error());
  return std::make_shared<FleetStopLine>(std::move(*all));
}

}  // namespace mlab::cli
