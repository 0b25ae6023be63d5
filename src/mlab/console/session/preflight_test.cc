// A session whose mission moves vehicles that are not simulated: nothing starts before somebody has signed.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/console/session.h"
#include "mlab/console/testing/browser.h"
#include "mlab/documents/testing/scratch_project.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/preflight/gate.h"
#include "mlab/run/crew.h"

namespace mlab::console {
namespace {

using documents::testing::ScratchProject;
using testing::Browser;
using testing::TestSession;

constexpr const char* kMission =
    "MISSION NAME \"Rover\"\n"
    "OVERLAY \"field.odl\"\n"
    "NEW-ROBOT rover \"robot\" green \"veh-1\" (base_velocity = 0.5)\n"
    "UNIT <a> rover\n"
    "COMMAND LIST:\n"
    "0. UNIT a START 100 100\n"
    "1. UNIT a MOVETO 400 100\n";
constexpr const char* kRefused = "there is no signed pre-flight checklist that holds";

/// A vehicle that is there, with which all is well that it says.
preflight::VehicleFacts rover() {
  preflight::VehicleFacts out;
  out.name = "veh-1";
  out.is_there = true;
  out.session = "started once";
  out.version = "test";
  out.limits.emplace();
  out.link = preflight::Link{0.002, 0.0, 0.0};
  out.report.emplace();
  out.report->readiness = vehicle::Readiness::kReady;
  out.report->motion.emplace();
  return out;
}

class CheckedSession : public ::testing::Test {
 protected:
  CheckedSession()
      : gate_(std::make_shared<preflight::Gate>(preflight::Gate::Parts{
            .fleet = "alpha",
            .version = "test",
            .look = [](const std::vector<std::string>&) { return std::vector{rover()}; },
            .wall_clock = [] { return 1000.0; },
            .store = preflight::Store(project_.path("state/preflight").string()),
            .how = "mlab preflight",
            .unchecked = ""})),
        session_((write(), ""), 100.0,
                 [&](SessionSettings& s) {
                   s.project_folder = project_.path("project").string();
                   s.state_folder = project_.path("state").string();
                   s.mission = mission_file();
                   s.gate = gate_;
                   s.run.vehicles = [gate = gate_](const mission::Mission&,
                                                   std::unique_ptr<binding::Binding> simulated) {
                     gate->new_permit();
                     return simulated;
                   };
                 }),
        anna_(session_, "Anna") {
    EXPECT_TRUE(is_ready());
  }
  bool is_ready() {
    return anna_.wait([&] { return anna_.status().mode() == Status::READY; });
  }
  void write() const {
    project_.write("project/rover.mdl", kMission);
    project_.write("project/field.odl", "MISSION-AREA 500 200\nCONTROL MEASURES:\n");
  }
  std::string mission_file() const { return project_.path("project/rover.mdl").string(); }

  /// As another program does it, with the texts on the disk.
  void sign() const {
    text::Diagnostics sink;
    const auto mission = mdl::load_mission(mission_file(), sink);
    ASSERT_TRUE(mission);
    const auto crew = run::make_crew(mission, {}, sink);
    ASSERT_TRUE(crew);
    preflight::Signature signature{.by = "Ada", .at = 0.0, .confirmed = {}, .accepted = {}};
    for (const preflight::ManualItem& one : preflight::manual_items()) signature.confirmed.push_back(one.id);
    const auto done = gate_->sign(*crew, signature);
    EXPECT_TRUE(done) << done.error();
  }
  void expect_refused(const std::string& error) {
    EXPECT_NE(error.find(kRefused), std::string::npos) << error;
  }

  ScratchProject project_;
  std::shared_ptr<preflight::Gate> gate_;
  TestSession session_;
  Browser anna_;
};

TEST_F(CheckedSession, StartsNothingBeforeSomebodySigns) {
  expect_refused(anna_.control(Control::EXECUTE));
  expect_refused(anna_.control(Control::RESUME));
  expect_refused(anna_.control(Control::SINGLE_STEP));
  expect_refused(anna_.control(Control::SINGLE_CYCLE));
  expect_refused(anna_.control(Control::SKIP_STEP));
  expect_refused(anna_.control(Control::JUMP, 1));
  expect_refused(anna_.type("UNIT a START 100 100"));
  EXPECT_EQ(anna_.status().mode(), Status::READY);
  sign();
  EXPECT_EQ(anna_.control(Control::EXECUTE), "");
  EXPECT_TRUE(anna_.wait([&] { return anna_.status().mode() == Status::RUNNING; }));
  EXPECT_TRUE(anna_.wait([&] { return anna_.has_log("the pre-flight checklist was signed by Ada"); }));
}

TEST_F(CheckedSession, AsksAnewWhenTheMissionWasChanged) {
  sign();
  EXPECT_EQ(anna_.type("UNIT <b> ROBOT"), "") << "moves nothing";
  const std::string error = anna_.control(Control::EXECUTE);
  expect_refused(error);
  EXPECT_NE(error.find("was changed since"), std::string::npos) << error;
}

}  // namespace
}  // namespace mlab::console
