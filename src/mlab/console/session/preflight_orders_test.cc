// What is looked at and signed before vehicles move, as browsers see it and ask for it.

#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/console/testing/browser.h"
#include "mlab/documents/testing/scratch_project.h"
#include "mlab/preflight/gate.h"

namespace mlab::console {
namespace {

using documents::testing::ScratchProject;
using preflight::Gate;
using preflight::VehicleFacts;
using testing::Browser;
using testing::TestSession;

constexpr const char* kDriven =
    "NEW-ROBOT rover \"robot\" green \"veh-1\"\n"
    "MISSION-AREA 200 100\n"
    "UNIT <a> rover\n"
    "COMMAND LIST:\n"
    "0. UNIT a START 20 30\n"
    "1. UNIT a MOVETO 90 30\n";

class PreflightSession : public ::testing::Test {
 protected:
  PreflightSession() {
    project_.write("project/driven.mdl", kDriven);
    gate_ = std::make_shared<Gate>(Gate::Parts{
        .fleet = "alpha",
        .version = "test",
        .look =
            [this](const std::vector<std::string>& names) {
              ++looks_;
              return facts(names);
            },
        .glance =
            [this](const std::vector<std::string>& names) {
              std::vector<VehicleFacts> out = facts(names);
              for (VehicleFacts& one : out) {
                one.report.emplace();
                one.report->readiness = vehicle::Readiness::kStandby;
                one.report->why = "is not armed";
                one.report->battery = vehicle::Battery{0.64, 24.6, {}};
              }
              return out;
            },
        .wall_clock = [] { return 1.7e9; },
        .store = preflight::Store(project_.path("signed").string()),
        .how = "mlab preflight driven.mdl",
        .unchecked = unchecked_,
    });
  }
  std::vector<VehicleFacts> facts(const std::vector<std::string>& names) const {
    std::vector<VehicleFacts> out;
    for (const std::string& name : names) {
      VehicleFacts& one = out.emplace_back();
      one.name = name;
      one.is_there = true;
      one.kind = "MAVLink rover at udp:14550";
      one.session = "s1";
      one.version = "test";
      one.is_simulated = is_simulated_;
      one.limits = vehicle::Limits{};
    }
    return out;
  }
  void begin() {
    session_ = std::make_unique<TestSession>("", 50.0, [this](SessionSettings& s) {
      s.project_folder = project_.path("project").string();
      s.state_folder = project_.path("state").string();
      s.mission = project_.path("project/driven.mdl").string();
      s.gate = gate_;
      s.run.is_vehicle = [](const std::string& host) { return host == "veh-1"; };
      s.run.vehicles = [gate = gate_](const mission::Mission&, std::unique_ptr<binding::Binding> simulated) {
        gate->new_permit();
        return simulated;
      };
    });
    anna_ = std::make_unique<Browser>(*session_, "Anna");
    ASSERT_TRUE(anna_->wait([&] { return anna_->preflight().looked_at() > 0.0; }));
  }
  static ToServer signed_by(const Preflight& checklist, const std::string& name) {
    ToServer out;
    SignPreflight& sign = *out.mutable_sign_preflight();
    sign.set_by(name);
    for (const Preflight::Manual& item : checklist.manual()) sign.add_confirmed(item.id());
    for (const Preflight::Item& item : checklist.items()) {
      if (item.result() != Preflight::FAIL) continue;
      sign.add_accepted()->set_item(item.id());
      sign.mutable_accepted()->rbegin()->set_because("it is a test");
    }
    return out;
  }

  ScratchProject project_;
  bool is_simulated_ = false;
  std::string unchecked_;
  std::atomic<int> looks_ = 0;
  std::shared_ptr<Gate> gate_;
  std::unique_ptr<TestSession> session_;
  std::unique_ptr<Browser> anna_;
};

TEST_F(PreflightSession, NothingMovesBeforeTheChecklistIsSigned) {
  begin();
  const Preflight before = anna_->preflight();
  EXPECT_TRUE(before.has_vehicles() && before.is_needed());
  ASSERT_EQ(before.vehicles_size(), 1);
  EXPECT_EQ(before.vehicles(0).name(), "veh-1");
  EXPECT_EQ(before.vehicles(0).robots(0), 1U);
  EXPECT_GT(before.items_size(), 3);
  EXPECT_GT(before.manual_size(), 0);
  EXPECT_NE(before.why_not_start(), "");
  const std::string refused = anna_->control(Control::EXECUTE);
  EXPECT_NE(refused.find("checklist"), std::string::npos) << refused;
  EXPECT_NE(anna_->type("UNIT a START 20 30"), "");

  ToServer unconfirmed = signed_by(before, "Ada");
  unconfirmed.mutable_sign_preflight()->clear_confirmed();
  EXPECT_NE(Browser::error_of(anna_->ask(unconfirmed)), "");
  EXPECT_NE(Browser::error_of(anna_->ask(signed_by(before, ""))), "");

  EXPECT_EQ(Browser::error_of(anna_->ask(signed_by(before, "Ada"))), "");
  ASSERT_TRUE(anna_->wait([&] { return anna_->preflight().signed_by() == "Ada"; }));
  EXPECT_EQ(anna_->preflight().signed_at(), 1.7e9);
  EXPECT_EQ(anna_->preflight().why_not_start(), "");
  EXPECT_TRUE(anna_->wait([&] { return anna_->has_log("the pre-flight checklist is signed by Ada"); }));
  EXPECT_EQ(anna_->control(Control::EXECUTE), "");
}

TEST_F(PreflightSession, VehiclesAreShownBeforeTheirRunHearsThem) {
  begin();
  const auto vehicle = [&] {
    const Status status = anna_->status();
    return status.vehicles_size() == 1 ? status.vehicles(0) : Status::Vehicle();
  };
  ASSERT_TRUE(anna_->wait([&] { return vehicle().readiness() == Status::Vehicle::STANDBY; }));
  EXPECT_EQ(vehicle().kind(), "MAVLink rover at udp:14550");
  EXPECT_EQ(vehicle().why(), "is not armed");
  EXPECT_EQ(vehicle().battery().share(), 0.64);
  EXPECT_EQ(vehicle().held_back(),
            "nothing of this reaches the run before the mission starts on its vehicles");
  EXPECT_EQ(Browser::error_of(anna_->ask(signed_by(anna_->preflight(), "Ada"))), "");
  EXPECT_EQ(anna_->control(Control::EXECUTE), "");
  EXPECT_TRUE(anna_->wait([&] { return vehicle().readiness() == Status::Vehicle::UNHEARD; }))
      << "from then on it is told what the run knows";
}

TEST_F(PreflightSession, WhoOnlyWatchesLooksAgainAndCanNotSign) {
  begin();
  Browser bert(*session_, "Bert");
  ASSERT_TRUE(bert.wait([&] { return bert.preflight().looked_at() > 0.0; }));
  const int looks = looks_;
  ToServer check;
  check.mutable_check_vehicles();
  EXPECT_EQ(Browser::error_of(bert.ask(check)), "");
  EXPECT_TRUE(bert.wait([&] { return looks_ > looks; }));
  EXPECT_NE(Browser::error_of(bert.ask(signed_by(bert.preflight(), "Bert"))), "");
}

TEST_F(PreflightSession, WhereNothingRealMovesNobodyHasToSign) {
  is_simulated_ = true;
  begin();
  EXPECT_TRUE(anna_->preflight().has_vehicles());
  EXPECT_FALSE(anna_->preflight().is_needed());
  EXPECT_EQ(anna_->preflight().why_not_start(), "");
  EXPECT_EQ(anna_->control(Control::EXECUTE), "");
}

}  // namespace
}  // namespace mlab::console
