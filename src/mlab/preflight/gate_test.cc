#include "mlab/preflight/gate.h"

#include <filesystem>
#include <utility>

#include <gtest/gtest.h>

#include "mlab/preflight/gated_line.h"
#include "mlab/preflight/testing/yard.h"

namespace mlab::preflight {
namespace {

namespace fs = std::filesystem;
using testing::crew;
using testing::signature;

class Gates : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              (std::string("gate_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Gate gate(std::string unchecked = "") {
    return Gate(Gate::Parts{.fleet = "alpha",
                            .version = "1.0",
                            .look =
                                [this](const std::vector<std::string>& names) {
                                  EXPECT_EQ(names, (std::vector<std::string>{"veh-1", "veh-2"}));
                                  ++looks_;
                                  return facts_;
                                },
                            .glance =
                                [this](const std::vector<std::string>& names) {
                                  std::vector<VehicleFacts> out = facts_;
                                  std::erase_if(out, [&](const VehicleFacts& one) {
                                    return std::ranges::find(names, one.name) == names.end();
                                  });
                                  return out;
                                },
                            .wall_clock = [this] { return now_; },
                            .store = Store(folder_.string()),
                            .how = "mlab preflight yard.mdl",
                            .unchecked = std::move(unchecked)});
  }

  std::vector<VehicleFacts> facts_ = testing::both_well();
  double now_ = 1000.0;
  int looks_ = 0;
  fs::path folder_;
};

TEST_F(Gates, AreShutUntilSomebodySigns) {
  Gate one = gate();
  const auto permit = one.new_permit();
  EXPECT_EQ(
      one.why_not_start(crew()),
      "the mission moves the vehicles `veh-1`, `veh-2`, and there is no signed pre-flight checklist that "
      "holds: nobody has signed one for this mission yet. Make one: mlab preflight yard.mdl");
  EXPECT_FALSE(permit->is_given());
  const auto done = one.sign(crew(), signature());
  ASSERT_TRUE(done) << done.error();
  EXPECT_EQ(done->signature.at, now_);
  EXPECT_EQ(one.why_not_start(crew()), "");
  EXPECT_TRUE(permit->lets_pass("veh-1"));
  EXPECT_EQ(one.passed().said, "the pre-flight checklist was signed by Ada");
  EXPECT_EQ(read_signed(one.passed().checklist), *done);
}

TEST_F(Gates, LookOnceMoreWhenTheMissionStarts) {
  Gate one = gate();
  ASSERT_TRUE(one.sign(crew(), signature()));
  const auto permit = one.new_permit();
  facts_[1].report->battery->share = 0.05;
  EXPECT_NE(one.why_not_start(crew()).find("`veh-2/battery` has failed since"), std::string::npos);
  EXPECT_FALSE(permit->is_given());
  facts_[1].report->battery->share = 0.9;
  now_ += 2.0 * kHoldsFor;
  EXPECT_NE(one.why_not_start(crew()).find("120 minutes ago"), std::string::npos);
}

TEST_F(Gates, TellPeopleWhatTheyHoldBackFromARun) {
  const std::vector<std::string> both = {"veh-1", "veh-2"};
  const auto held = [&](const Gate& one) {
    std::vector<std::string> out;
    for (const VehicleFacts& facts : one.held_back(both)) out.push_back(facts.name);
    return out;
  };
  Gate one = gate();
  EXPECT_EQ(held(one), std::vector<std::string>{}) << "there is no run with vehicles";
  const auto permit = one.new_permit();
  EXPECT_EQ(held(one), both);
  EXPECT_FALSE(one.has_let_pass());
  facts_[0].is_simulated = true;
  EXPECT_EQ(held(one), std::vector<std::string>{"veh-2"}) << "of what is simulated nothing is held back";
  facts_[0].is_simulated = false;
  facts_[1].is_there = false;
  facts_[1].session.clear();
  Signature accepted = signature();
  accepted.accepted = {{"veh-2/presence", "it is not needed"}};
  const auto done = one.sign(crew(), accepted);
  ASSERT_TRUE(done) << done.error();
  ASSERT_EQ(one.why_not_start(crew()), "");
  EXPECT_TRUE(one.has_let_pass());
  EXPECT_EQ(held(one), std::vector<std::string>{"veh-2"}) << "it comes too late";
  EXPECT_FALSE(permit->lets_pass("veh-2"));
}

TEST_F(Gates, AskNobodyTwiceForARunAndAnewForTheNext) {
  Gate one = gate();
  ASSERT_TRUE(one.sign(crew(), signature()));
  const auto first = one.new_permit();
  EXPECT_EQ(one.why_not_start(crew()), "");
  const int looks = looks_;
  now_ += 2.0 * kHoldsFor;
  EXPECT_EQ(one.why_not_start(crew()), "") << "it goes on";
  EXPECT_EQ(looks_, looks);
  const auto second = one.new_permit();
  EXPECT_NE(one.why_not_start(crew()), "");
  EXPECT_TRUE(first->is_given());
  EXPECT_FALSE(second->is_given());
  EXPECT_EQ(one.passed().said, "");
}

TEST_F(Gates, RefuseASignatureWithWhatHasFailedMeanwhile) {
  Gate one = gate();
  facts_[0].link.reset();
  EXPECT_EQ(one.sign(crew(), signature()).error(),
            "`veh-1/link` has failed: `veh-1`, link: has answered no question");
  Signature by = signature();
  by.accepted = {{"veh-1/link", "on the bench"}};
  ASSERT_TRUE(one.sign(crew(), by));
  const auto permit = one.new_permit();
  EXPECT_EQ(one.why_not_start(crew()), "");
  EXPECT_EQ(
      one.passed().said,
      "the pre-flight checklist was signed by Ada; `veh-1/link` has failed, and was accepted: on the bench");
}

TEST_F(Gates, AreOpenWhereNothingRealMoves) {
  for (VehicleFacts& one : facts_) one.is_simulated = true;
  Gate one = gate();
  const auto permit = one.new_permit();
  EXPECT_EQ(one.why_not_start(crew()), "");
  EXPECT_TRUE(permit->is_given());
  EXPECT_EQ(one.passed().said, "");
}

TEST_F(Gates, KeepOutWhoWasNotThereWhenTheOthersWereChecked) {
  facts_[1] = {.name = "veh-2", .why_not_there = "has been silent for 7 s"};
  Gate one = gate();
  Signature by = signature();
  by.accepted = {{"veh-2/presence", "the first one does it alone"}};
  ASSERT_TRUE(one.sign(crew(), by));
  const auto permit = one.new_permit();
  EXPECT_EQ(one.why_not_start(crew()), "");
  EXPECT_TRUE(permit->lets_pass("veh-1"));
  EXPECT_FALSE(permit->lets_pass("veh-2"));
  facts_[0] = {.name = "veh-1", .why_not_there = "has been silent for 7 s"};
  const auto next = one.new_permit();
  EXPECT_EQ(one.why_not_start(crew()), "") << "none that is there is real";
  EXPECT_FALSE(next->lets_pass("veh-1"));
}

TEST_F(Gates, SayWhyNothingWasChecked) {
  Gate one = gate("wheels are off the ground");
  const auto permit = one.new_permit();
  EXPECT_EQ(one.why_not_start(crew()), "");
  EXPECT_TRUE(permit->is_given());
  EXPECT_EQ(one.passed().said, "the vehicles were not checked before the mission: wheels are off the ground");
  EXPECT_TRUE(one.passed().is_unchecked);
  EXPECT_EQ(looks_, 0);
}

/// Says each time something new, and counts what it is told.
class Heard final : public vehicle::Line {
 public:
  explicit Heard(int& told) : told_(told) {}
  std::optional<std::string> hear() override { return std::to_string(++said_); }
  void tell(const wire::VehicleCommand&) override { ++told_; }

 private:
  int& told_;
  int said_ = 0;
};

TEST(GatedLine, LetsNothingPassBeforeThePermit) {
  const auto permit = std::make_shared<Permit>();
  int told = 0;
  const auto line = gated("veh-1", std::make_unique<Heard>(told), permit);
  EXPECT_FALSE(line->hear());
  line->tell({});
  EXPECT_EQ(told, 0);
  permit->give({"veh-1"});
  EXPECT_EQ(line->hear(), "2");
  line->tell({});
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace mlab::preflight
