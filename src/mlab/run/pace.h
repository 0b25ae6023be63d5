#pragma once

namespace mlab::run {

/// When the next cycle is due, for a wanted number of simulated seconds per second. What can't be kept up
/// with is made up for within kMostBehind and forgotten beyond, so that a run that was held up does not race
/// afterwards.
///
/// All times are in seconds: `wall` of any clock that does not go back, `sim` of the run.
class Pace {
 public:
  static constexpr double kSlowest = 0.1;
  static constexpr double kFastest = 1000.0;
  static constexpr double kMostBehind = 0.5;

  /// @param speed  0: as fast as it goes; else it is brought into the range
  explicit Pace(double speed) { set_speed(speed, 0.0, 0.0); }

  void set_speed(double speed, double wall, double sim);
  double speed() const { return speed_; }
  /// Time begins to pass, after a pause say: now is in time.
  void start(double wall, double sim);
  /// The moment at which the cycle that begins at `sim` is due.
  double due(double sim) const;
  /// How late that cycle is; 0 where it is not, or there is no wanted speed.
  double behind(double wall, double sim) const;
  /// Forgets what is more than kMostBehind late.
  void forgive(double wall, double sim);
  /// Forgets all of it where a cycle is later than `most`.
  void forgive_all(double wall, double sim, double most);

 private:
  double speed_ = 1.0;
  double wall_ = 0.0;
  double sim_ = 0.0;
};

}  // namespace mlab::run
