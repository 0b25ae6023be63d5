#include "mlab/vehicle/testing/conformance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mlab/base/angle.h"

namespace mlab::vehicle {
namespace {

using std::chrono::milliseconds;

constexpr auto kDrivenEvery = milliseconds(100);
/// What a clock that is read at the begin of a period is behind [s].
constexpr double kPeriod = 0.05;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

Clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

std::uint64_t chosen_seed() {
  const char* const chosen = std::getenv("MLAB_VEHICLE_SEED");  // NOLINT(concurrency-mt-unsafe): one thread
  return chosen != nullptr ? std::strtoull(chosen, nullptr, 10) : 1;
}

/// Where the origin of an odometry is that tells `told` of a vehicle at `truth`.
geom::Pose origin_of(const geom::Pose& truth, const geom::Pose& told) {
  const double heading = truth.heading - told.heading;
  const geom::Pose turned{{}, heading};
  const geom::Offset way = turned.to_world({told.position.x, told.position.y, 0.0});
  return {truth.position - way, base::wrap_angle(heading)};
}

}  // namespace

std::string kind_name(const testing::TestParamInfo<RigKind>& info) {
  return info.param.name;
}

Conformance::Conformance() : random_(base::combine_bits(chosen_seed(), 17)), seed_(chosen_seed()) {}

Conformance::~Conformance() = default;

void Conformance::SetUp() {
  RecordProperty("seed", std::to_string(seed_));
  rig_ = GetParam().make(seed_);
  ASSERT_NE(rig_, nullptr);
  device_ = &rig_->device();
  limits_ = device_->limits();
}

void Conformance::step() {
  now_ = rig_->step();
  past_.push_back({now_, rig_->truth()});
  while (seconds(now_ - past_.front().at) > 10.0) past_.pop_front();
}

void Conformance::go(double for_seconds, const std::optional<Command>& command, Care care) {
  if (past_.empty()) step();
  const Clock::time_point end = now_ + duration_of(for_seconds);
  while (now_ < end && !HasFailure()) {
    step();
    check_limits();
    if (care == Care::kNone || device_ == nullptr) continue;
    device_->work(now_);
    if (command.has_value() && now_ - driven_at_ >= kDrivenEvery) {
      device_->drive(*command, now_);
      driven_at_ = now_;
    }
    check_report();
  }
  if (HasFailure() && failures_++ == 0) ADD_FAILURE() << "with MLAB_VEHICLE_SEED=" << seed_;
}

void Conformance::check_limits() const {
  const Truth& truth = past_.back().truth;
  const Facts& facts = rig_->facts();
  const binding::Kinematics& k = limits_.kinematics;
  EXPECT_LE(truth.speed, k.max_speed + facts.speed_error) << "faster than its limits say";
  EXPECT_GE(truth.speed, std::min(limits_.min_speed, 0.0) - facts.speed_error) << "goes backwards";
  if (k.max_turn_rate > 0.0) {
    EXPECT_LE(std::abs(truth.turn_rate), k.max_turn_rate + facts.turn_error)
        << "turns faster than its limits";
  }
}

bool Conformance::is_at(const Moment& moment, const Motion& motion) const {
  const Facts& facts = rig_->facts();
  const geom::Pose place{origin_->point_at({motion.pose.position.x, motion.pose.position.y, 0.0}),
                         motion.pose.heading + origin_->heading};
  return geom::distance(moment.truth.pose.position, place.position) <= facts.pose_error &&
         std::abs(base::wrap_angle(moment.truth.pose.heading - place.heading)) <= facts.heading_error &&
         std::abs(moment.truth.speed - motion.speed) <= facts.speed_error &&
         std::abs(moment.truth.turn_rate - motion.turn_rate) <= facts.turn_error;
}

bool Conformance::was_so(const Motion& motion) const {
  const double early = rig_->facts().stamp_error + seconds(impairment_.delay);
  auto moment = std::ranges::lower_bound(past_, motion.at - duration_of(early), {}, &Moment::at);
  for (; moment != past_.end() && moment->at <= motion.at + duration_of(kPeriod); ++moment) {
    if (is_at(*moment, motion)) return true;
  }
  return false;
}

bool Conformance::has_stood_since(Clock::time_point then) const {
  const auto moment = std::ranges::lower_bound(past_, then - duration_of(kPeriod), {}, &Moment::at);
  return stands() && moment != past_.end() && moment->truth.pose == past_.back().truth.pose;
}

void Conformance::check_motion(const Motion& motion, bool is_global) {
  if (is_global) origin_ = geom::Pose{};
  if (restarted_at_.has_value() && motion.at > *restarted_at_) {
    origin_.reset();
    restarted_at_.reset();
  }
  const Truth& truth = past_.back().truth;
  // Only of one that stands is it known exactly where it was at the time of the stamp.
  if (!origin_.has_value() && has_stood_since(motion.at)) origin_ = origin_of(truth.pose, motion.pose);
  if (!origin_.has_value()) return;
  EXPECT_TRUE(was_so(motion)) << "reported: " << motion.pose.position.x << ' ' << motion.pose.position.y
                              << ' ' << motion.pose.heading << " at " << motion.speed << " m/s "
                              << motion.turn_rate << " rad/s, " << seconds(now_ - motion.at)
                              << " s ago; now true: " << truth.pose.position.x << ' ' << truth.pose.position.y
                              << ' ' << truth.pose.heading << " at " << truth.speed << " m/s "
                              << truth.turn_rate << " rad/s; origin " << origin_->position.x << ' '
                              << origin_->position.y << ' ' << origin_->heading;
}

void Conformance::check_stamp(const std::string& what, Clock::time_point at, double lasts) const {
  EXPECT_LE(at, now_) << what << " is of the future";
  EXPECT_LE(seconds(now_ - at), std::max(rig_->facts().silent_after, lasts) + kPeriod) << what << " is stale";
  if (cut_at_.has_value()) {
    EXPECT_LE(at, *cut_at_ + impairment_.delay + duration_of(kPeriod))
        << what << " came over a line that is cut";
  }
}

void Conformance::check_scan(const Scan& scan) const {
  check_stamp("a scan", scan.at);
  EXPECT_FALSE(scan.distances.empty());
  EXPECT_GE(scan.nearest, 0.0);
  EXPECT_GT(scan.farthest, scan.nearest);
  for (const float distance : scan.distances) {
    if (std::isnan(distance) || distance == std::numeric_limits<float>::infinity()) continue;
    EXPECT_GE(distance, scan.nearest - 1e-4);
    EXPECT_LE(distance, scan.farthest + 1e-4);
  }
}

void Conformance::check_report() {
  const Report& report = device_->report(now_);
  EXPECT_EQ(report.why.empty(), report.readiness == Readiness::kReady) << report.why;
  if (report.readiness == Readiness::kReady) {
    EXPECT_TRUE(report.motion.has_value()) << "ready, and nothing is known";
  }
  if (report.motion.has_value()) {
    check_stamp("its motion", report.motion->at);
    check_motion(*report.motion, report.is_global);
  }
  for (const Scan& scan : report.scans) check_scan(scan);
  if (report.battery.has_value()) {
    check_stamp("its battery", report.battery->at, rig_->facts().battery_lasts);
    EXPECT_GE(report.battery->share, 0.0);
    EXPECT_LE(report.battery->share, 1.0);
  }
  check_silence(report);
}

void Conformance::check_silence(const Report& report) const {
  const double cut_for = cut_at_.has_value() ? seconds(now_ - *cut_at_ - impairment_.delay) : 0.0;
  if (cut_for <= rig_->facts().silent_after + kPeriod) return;
  EXPECT_TRUE(report.readiness == Readiness::kSilent || report.readiness == Readiness::kAbsent);
  EXPECT_FALSE(report.motion.has_value());
  EXPECT_TRUE(report.scans.empty());
  EXPECT_FALSE(report.battery.has_value());
}

bool Conformance::is_ready() {
  return device_->report(now_).readiness == Readiness::kReady;
}

void Conformance::wait_until_ready() {
  if (past_.empty()) step();
  const Clock::time_point end = now_ + duration_of(rig_->facts().ready_within);
  while (!is_ready() && now_ < end && !HasFailure()) {
    const bool is_waiting = device_->report(now_).readiness == Readiness::kStandby;
    go(0.02, is_waiting ? std::optional(Command{}) : std::nullopt);
  }
  if (!is_ready()) ADD_FAILURE() << "is not ready in time: it " << device_->report(now_).why;
}

void Conformance::get_moving(const Command& command) {
  const auto is_moving = [&] {
    const Truth& truth = past_.back().truth;
    return truth.speed * command.speed >= 0.8 * command.speed * command.speed &&
           truth.turn_rate * command.turn_rate >= 0.8 * command.turn_rate * command.turn_rate;
  };
  const Clock::time_point end = now_ + duration_of(rig_->facts().ready_within);
  while (now_ < end && !is_moving() && !HasFailure()) go(0.02, command);
  EXPECT_TRUE(is_moving()) << "does not do what it is told: " << past_.back().truth.speed << " m/s";
}

void Conformance::cut(Cut how) {
  rig_->cut(how);
  cut_at_ = now_;
  if (how == Cut::kPowerOff || how == Cut::kRestart) restarted_at_ = now_;
}

void Conformance::mend() {
  rig_->mend();
  cut_at_.reset();
}

void Conformance::impair(const Impairment& impairment) {
  rig_->impair(impairment);
  impairment_ = impairment;
}

void Conformance::drop_device() {
  rig_->drop_device();
  device_ = nullptr;
}

bool Conformance::stands() const {
  const Truth& truth = past_.back().truth;
  return std::abs(truth.speed) <= rig_->facts().standing_speed &&
         std::abs(truth.turn_rate) <= rig_->facts().standing_turn_rate;
}

void Conformance::expect_standing(const std::string& when) const {
  const Truth& truth = past_.back().truth;
  EXPECT_TRUE(stands()) << when << ": " << truth.speed << " m/s, " << truth.turn_rate << " rad/s; seed "
                        << seed_;
}

Command Conformance::full_ahead() const {
  return {limits_.kinematics.max_speed, 0.0};
}

namespace {

Command random_command(const Limits& limits, base::Random& random) {
  const binding::Kinematics& k = limits.kinematics;
  return {random.uniform(-0.3, 1.0) * k.max_speed, random.uniform(-1.0, 1.0) * k.max_turn_rate};
}

TEST_P(Conformance, SaysWhatItMayBeAskedFor) {
  const Limits& limits = device().limits();
  EXPECT_NE(limits.kinematics.drive, binding::Drive::kHolonomic);
  EXPECT_GT(limits.kinematics.max_speed, 0.0);
  EXPECT_LE(limits.min_speed, 0.0);
  EXPECT_GT(limits.radius, 0.0);
  EXPECT_GT(limits.standstill, 0.0);
  EXPECT_FALSE(device().name().empty());
}

TEST_P(Conformance, IsReadyOnceItsVehicleIsHeard) {
  const Clock::time_point before = rig_->step();
  EXPECT_NE(device().report(before).readiness, Readiness::kReady);
  EXPECT_FALSE(device().report(before).motion.has_value());
  wait_until_ready();
  const Clock::time_point end = now_ + std::chrono::seconds(3);
  bool has_ranges = false;
  while (now_ < end && !HasFailure()) {
    go(0.1, std::nullopt);
    has_ranges = has_ranges || !device().report(now_).scans.empty();
  }
  EXPECT_EQ(has_ranges, facts().has_ranges);
  EXPECT_EQ(device().report(now_).battery.has_value(), facts().has_battery);
  expect_standing("never told anything");
}

TEST_P(Conformance, HasNoCheckThatFailsOnceItIsReady) {
  if (!rig_->facts().has_checks) GTEST_SKIP() << "it is looked at from the run's end, where there are none";
  wait_until_ready();
  const std::vector<Check> checks = device().checks(now_);
  EXPECT_FALSE(device().is_simulated());
  EXPECT_FALSE(checks.empty());
  std::set<std::string> names;
  for (const Check& one : checks) {
    EXPECT_NE(one.result, CheckResult::kFail) << one.name << " " << one.is;
    EXPECT_FALSE(one.is.empty()) << one.name;
    EXPECT_TRUE(names.insert(one.name).second) << one.name << " is told twice";
  }
}

TEST_P(Conformance, DoesWhatItIsTold) {
  wait_until_ready();
  const geom::Pose before = rig_->truth().pose;
  get_moving(full_ahead());
  go(2.0, full_ahead());
  EXPECT_GT(before.to_robot(rig_->truth().pose.position).x, 0.0);
  const double turn = 0.5 * device().limits().kinematics.max_turn_rate;
  for (const double rate : {turn, -turn}) {
    const Command command{0.5 * device().limits().kinematics.max_speed, rate};
    if (facts().holds_turn_rates) {
      get_moving(command);
      continue;
    }
    const double heading = rig_->truth().pose.heading;
    go(3.0, command);
    EXPECT_GT(base::wrap_angle(rig_->truth().pose.heading - heading) * rate, 0.3 * std::abs(rate));
  }
}

TEST_P(Conformance, StandsWhenItIsToldToStop) {
  wait_until_ready();
  get_moving(full_ahead());
  device().stop(now_);
  go(facts().stops_within, std::nullopt);
  expect_standing("stopped");
  for (int i = 0; i < 20; ++i) {
    go(0.1, std::nullopt);
    expect_standing("stopped, and nobody has driven");
  }
  get_moving(full_ahead());
}

TEST_P(Conformance, StandsInAnEmergency) {
  wait_until_ready();
  get_moving(full_ahead());
  device().stop_in_emergency(now_);
  go(facts().stops_within, std::nullopt);
  expect_standing("stopped in an emergency");
  go(2.0, std::nullopt);
  expect_standing("stopped in an emergency, and nobody has driven");
}

TEST_P(Conformance, IsLeftToWhoHasTakenItButInAnEmergency) {
  wait_until_ready();
  get_moving(full_ahead());
  if (!rig_->take()) GTEST_SKIP() << "nobody else can take it";
  go(1.0, full_ahead());
  EXPECT_EQ(device().report(now_).readiness, Readiness::kTaken);
  device().stop(now_);
  go(2.0, std::nullopt);
  EXPECT_FALSE(stands()) << "a routine stop takes it from whoever has taken it";
  device().stop_in_emergency(now_);
  go(facts().stops_within, std::nullopt);
  expect_standing("stopped in an emergency");
  go(2.0, std::nullopt);
  device().engage(now_);
  wait_until_ready();
  get_moving(full_ahead());
}

// What a stop of ours did to it must not hide who takes it a second later.
TEST_P(Conformance, IsLeftToWhoTakesItRightAfterAStop) {
  wait_until_ready();
  get_moving(full_ahead());
  device().stop(now_);
  go(facts().stops_within, std::nullopt);
  get_moving(full_ahead());
  if (!rig_->take_to_stand()) GTEST_SKIP() << "nobody else can have it stand";
  go(3.0, full_ahead());
  EXPECT_EQ(device().report(now_).readiness, Readiness::kTaken);
  expect_standing("taken by somebody who has it stand");
  rig_->give_back();
  device().engage(now_);
  wait_until_ready();
  get_moving(full_ahead());
}

TEST_P(Conformance, IsToldToStopUntilItStands) {
  for (int i = 0; i < 10 && !HasFailure(); ++i) {
    wait_until_ready();
    get_moving(full_ahead());
    go(0.1, full_ahead());
    cut(Cut::kSilence);
    device().stop(now_);
    go(0.1, std::nullopt);
    mend();
    go(facts().stops_within, std::nullopt);
    expect_standing("told to stop while nothing arrived");
  }
}

TEST_P(Conformance, StandsWhenNobodyDrives) {
  wait_until_ready();
  get_moving(full_ahead());
  go(device().limits().standstill, std::nullopt);
  expect_standing("nobody drives");
  go(2.0, std::nullopt);
  expect_standing("nobody drives");
}

TEST_P(Conformance, StandsWhenItsDriverHangs) {
  wait_until_ready();
  get_moving(full_ahead());
  go(device().limits().standstill, std::nullopt, Care::kNone);
  expect_standing("nobody calls `work`");
  go(3.0, std::nullopt, Care::kNone);
  expect_standing("nobody calls `work`");
  wait_until_ready();
  get_moving(full_ahead());
}

TEST_P(Conformance, StandsWhenItsDriverIsGone) {
  wait_until_ready();
  get_moving(full_ahead());
  const double standstill = device().limits().standstill;
  drop_device();
  go(standstill, std::nullopt);
  expect_standing("its device is destroyed");
}

TEST_P(Conformance, KeepsItsLimitsWhateverIsAsked) {
  wait_until_ready();
  constexpr std::array<double, 6> kAsked = {1e9, -1e9, 1e300, 30.0, -30.0, 0.0};
  for (int i = 0; i < 40; ++i)
    go(0.3, Command{kAsked[random_.below(kAsked.size())], kAsked[random_.below(kAsked.size())]});
}

TEST_P(Conformance, StandsWhereACommandIsNoNumber) {
  wait_until_ready();
  for (const Command& command :
       {Command{kNan, 0.0}, Command{0.1, kNan}, Command{kInfinity, 0.0}, Command{0.1, -kInfinity}}) {
    get_moving(full_ahead());
    go(device().limits().standstill, command);
    expect_standing("told what is no number");
  }
}

TEST_P(Conformance, ReportsWhatIsSo) {
  wait_until_ready();
  for (int i = 0; i < 30; ++i) go(random_.uniform(0.2, 1.5), random_command(device().limits(), random_));
}

TEST_P(Conformance, SaysNothingOldWhenItsVehicleIsSilent) {
  for (const Cut how : {Cut::kSilence, Cut::kHangUp, Cut::kPowerOff, Cut::kRestart}) {
    wait_until_ready();
    get_moving(full_ahead());
    cut(how);
    go(device().limits().standstill, full_ahead());
    expect_standing("its line is cut");
    go(facts().silent_after + 3.0, full_ahead());
    EXPECT_FALSE(is_ready());
    mend();
  }
}

TEST_P(Conformance, SurvivesThatItGoesAwayAndComesBack) {
  const double standstill = device().limits().standstill;
  for (int i = 0; i < GetParam().outages && !HasFailure(); ++i) {
    wait_until_ready();
    const Command command = random_command(device().limits(), random_);
    go(random_.uniform(0.0, 1.5), command);
    cut(static_cast<Cut>(random_.below(static_cast<std::uint64_t>(kLastCut) + 1)));
    const bool is_driven = random_.uniform() < 0.5;
    go(random_.uniform(0.0, 3.0), is_driven ? std::optional(command) : std::nullopt);
    mend();
    go(standstill, std::nullopt);
    expect_standing("back, and nobody has driven");
    wait_until_ready();
    go(0.5, std::nullopt);
    expect_standing("back and ready, and nobody has driven");
    if (i % 10 == 0) get_moving(full_ahead());
  }
}

TEST_P(Conformance, GetsAlongWithLossesAndDelays) {
  impair({.loss = 0.2, .delay = milliseconds(200)});
  go(facts().ready_within, std::nullopt);
  const double standstill = device().limits().standstill;
  double moved = 0.0;
  for (int i = 0; i < 10 && !HasFailure(); ++i) {
    const geom::Point before = rig_->truth().pose.position;
    go(3.0, Command{0.5 * device().limits().kinematics.max_speed, 0.0});
    moved += geom::distance(before, rig_->truth().pose.position);
    const bool stops = i % 2 == 0;
    if (stops) device().stop(now_);
    go(standstill, std::nullopt);
    expect_standing(stops ? "stopped over a bad line" : "nobody drives over a bad line");
  }
  const double told = 10 * 3.0 * 0.5 * device().limits().kinematics.max_speed;
  EXPECT_GT(moved, facts().bad_line_share * told) << "hardly ever moves";
}

TEST_P(Conformance, StandsThoughItsLineHoldsBackWhatItWasTold) {
  if (!facts().refuses_late_commands) GTEST_SKIP() << "nothing in what it is told says when that was";
  for (int i = 0; i < 20 && !HasFailure(); ++i) {
    wait_until_ready();
    get_moving(full_ahead());
    rig_->hold_back();
    go(random_.uniform(0.3, 4.0), full_ahead());
    go(device().limits().standstill, std::nullopt);
    expect_standing("nothing arrives");
    rig_->release();
    for (int k = 0; k < 10; ++k) {
      go(0.1, std::nullopt);
      expect_standing("what it was told long ago arrives");
    }
  }
}

}  // namespace
}  // namespace mlab::vehicle
