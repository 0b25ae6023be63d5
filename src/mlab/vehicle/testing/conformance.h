#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "mlab/vehicle/testing/rig.h"

namespace mlab::vehicle {

/// What every device has to hold, whatever connects it. A kind of device is tried by all of it with
///
///     INSTANTIATE_TEST_SUITE_P(Rover, Conformance, testing::Values(RigKind{"Rover", make_rover_rig}),
///     kind_name);
///
/// in a test that links mlab_vehicle_conformance. While time goes by it is asked each time whether the
/// vehicle keeps its limits and whether what is reported of it was so.
class Conformance : public testing::TestWithParam<RigKind> {
 protected:
  Conformance();
  ~Conformance() override;
  void SetUp() override;

  /// What becomes of the device while time goes by.
  enum class Care { kWork, kNone };
  /// Lets time go by; commands are given ten times a second.
  /// @param seconds  at least
  void go(double seconds, const std::optional<Command>& command, Care care = Care::kWork);
  /// Until it is ready, at most for `ready_within`; where it has to be driven for that, it is told to stand.
  /// A test fails where it is not.
  void wait_until_ready();
  /// Drives until it is at least as fast, for some seconds at most; a test fails where it is not.
  void get_moving(const Command& command);
  void cut(Cut how);
  void mend();
  void impair(const Impairment& impairment);

  /// Fails where it moves now.
  void expect_standing(const std::string& when) const;
  bool stands() const;
  bool is_ready();
  const Facts& facts() const { return rig_->facts(); }
  Device& device() { return *device_; }
  Command full_ahead() const;

  /// Destroys the device.
  void drop_device();

  base::Random random_;
  std::unique_ptr<Rig> rig_;
  Clock::time_point now_;

 private:
  struct Moment {
    Clock::time_point at;
    Truth truth;
  };
  void step();
  void check_limits() const;
  void check_report();
  /// Nothing is told of a vehicle that nothing has come from for too long.
  void check_silence(const Report& report) const;
  void check_motion(const Motion& motion, bool is_global);
  /// @param lasts  how old it may be, where that is more than `Facts::silent_after` [s]
  void check_stamp(const std::string& what, Clock::time_point at, double lasts = 0.0) const;
  void check_scan(const Scan& scan) const;
  /// Whether the vehicle once was where this says, in the time that the stamp means.
  bool was_so(const Motion& motion) const;
  bool has_stood_since(Clock::time_point then) const;
  bool is_at(const Moment& moment, const Motion& motion) const;

  std::uint64_t seed_;
  Device* device_ = nullptr;
  Limits limits_;
  std::deque<Moment> past_;
  /// Where the origin of its odometry is; nothing: it was switched on and has not told since where it stands.
  std::optional<geom::Pose> origin_;
  /// It was switched off; what it says from then on counts from somewhere else.
  std::optional<Clock::time_point> restarted_at_;
  std::optional<Clock::time_point> cut_at_;
  Impairment impairment_;
  Clock::time_point driven_at_;
  int failures_ = 0;
};

/// The name of the kind, for INSTANTIATE_TEST_SUITE_P.
std::string kind_name(const testing::TestParamInfo<RigKind>& info);

}  // namespace mlab::vehicle
