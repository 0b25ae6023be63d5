#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/binding/binding.h"
#include "mlab/fleet/fleet.h"
#include "mlab/mission/executive.h"
#include "mlab/mission/mission.h"
#include "mlab/overlay/environment_change.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/run/crew.h"
#include "mlab/run/stop_line.h"
#include "mlab/text/diagnostic.h"

namespace mlab::run {

struct RunSettings {
  std::uint64_t seed = 1;
  int threads = 1;
  mission::ExecutiveOptions executive;
  overlay::EnvironmentChanges environment;  ///< what changes in the world, and when
  bool stands_still_for_operator = true;    ///< time does not pass while nothing but an answer is awaited
  bool goes_on_when_done =
      false;  ///< time passes after the mission is done: robots that act by themselves do so
  /// Makes what runs the robots' programs elsewhere, for one run of this seed; empty: they run on this
  /// machine.
  /// @param cycle_duration  of the mission [s]
  std::function<std::unique_ptr<robot::ProgramRunner>(std::uint64_t seed, double cycle_duration)>
      robots_elsewhere = {};
  std::shared_ptr<StopLine> stop_line = {};  ///< null: the emergency stop is this run's own
  bool is_in_real_time =
      false;  ///< robots elsewhere are not waited for: time passes as on the clock, no faster
};

/// How well a unit kept its formations.
struct UnitMetrics {
  double error_sum = 0.0;              ///< over robots and cycles [m]
  double max_error = 0.0;              ///< [m]
  std::uint64_t samples = 0;           ///< robot-cycles in which there was a formation to keep
  std::uint64_t out_of_formation = 0;  ///< of these, farther from the station than the robot's formation_slop

  double mean_error() const { return samples == 0 ? 0.0 : error_sum / static_cast<double>(samples); }
  double out_share() const {
    return samples == 0 ? 0.0 : static_cast<double>(out_of_formation) / static_cast<double>(samples);
  }
};

/// An operator's answer, with the cycle in which it was given.
struct AnswerRecord {
  std::uint64_t cycle = 0;
  std::uint32_t question = 0;
  bool proceed = false;
};

/// What a person made a robot, or its program, do.
struct InterventionRecord {
  enum class Kind : std::uint8_t { kForce, kHold, kRelease, kReplace };
  std::uint64_t cycle = 0;  ///< that had run; it counts from the next one on
  base::RobotId robot;
  Kind kind = Kind::kForce;
  std::string path;   ///< of the sequence, or of the port; empty: all that were held
  std::string value;  ///< the state, or at what it is held
};
std::string_view name(InterventionRecord::Kind kind);

/// Robots that go on with other programs.
struct Takeover {
  /// Of all robots whose program has changed this begins anew, though it was there before.
  struct Restart {
    std::string path;
    std::string why;
    std::vector<base::RobotId> robots;
  };
  std::uint64_t cycle = 0;  ///< that had run
  std::vector<base::RobotId> robots;
  std::vector<Restart> restarts;
};
/// In words: `robots 1 to 3 took over a change; ...`.
std::string text_of(const Takeover& takeover);

/// An object that came into a basket.
struct Delivery {
  double time = 0.0;  ///< [s]
  base::RobotId robot;
  base::ObjectId object;
  base::ObjectId basket;
};

/// What became of a robot's failsafes, as the log says it.
struct FailsafeRecord {
  double time = 0.0;  ///< [s]
  base::RobotId robot;
  std::string what;  ///< `FAILSAFE OUTSIDE Field HOLD` acts
};

/// A robot that has not been started, and where START will put it.
struct PlannedStart {
  base::RobotId robot;
  geom::Pose pose;
};

/// A mission that is carried out: executive, robots and their bodies, one control cycle at a time. What
/// bodies are, and where programs run, it does not know.
class MissionRun {
 public:
  /// Nothing is started.
  /// @param binding  the robots' bodies, not null
  MissionRun(std::shared_ptr<const Crew> crew, RunSettings settings,
             std::unique_ptr<binding::Binding> binding);

  /// Called for everything that the executive wants told, asked, shown or set, when it happens.
  using Observer = std::function<void(const mission::Effect&)>;
  void set_observer(Observer observer) { observer_ = std::move(observer); }

  /// What the operator does: Execute, Pause, Answer, a typed command, ...
  void post(const mission::Event& event);

  enum class Progress : std::uint8_t {
    kStepped,  ///< a cycle went by
    kWaits,    ///< paused, or only the operator can move things on: no time passed
    kOver,     ///< the mission has ended; no time passes any more, unless RunSettings::goes_on_when_done
  };
  /// One control cycle.
  Progress step();

  /// The plan, the robots and the world become those of another version of the mission, while it runs. Who is
  /// in the world already keeps its place, program and order; of its parameters those change that the
  /// versions set to different values. Only obstacles, walls and objects that came, went or moved are
  /// touched.
  void edit(std::shared_ptr<const Crew> crew);

  /// As `edit`, with other programs: robots that are in the world go on with the new ones where they are,
  /// with what of their values these can go on with (flow::carry_over). Held values and parameters that
  /// people set stay where the new program has them.
  /// @errors  a sentence that says why it can't be done while it runs; nothing has changed
  std::expected<Takeover, std::string> take_over(std::shared_ptr<const Crew> crew);

  /// All robots stand as soon as their bodies can, from the next cycle on. Mission and programs hold: nothing
  /// that happens in the meantime moves a robot. Once all stand, no time passes until the stop is released.
  void set_emergency_stop(bool stopped) {
    if (stopped && !is_stopped_) has_braked_ = false;
    is_stopped_ = stopped;
  }
  bool is_stopped() const { return is_stopped_; }
  /// How many robots are in the world, and how many of these the stop has brought to stand: none before the
  /// first cycle in which they were braked.
  std::size_t robots_in_world() const { return fleet_->bodies().all; }
  std::size_t robots_stopped() const {
    const fleet::Fleet::Bodies bodies = fleet_->bodies();
    return is_stopped_ && has_braked_ ? bodies.all - bodies.moving : 0;
  }

  /// As fleet::Fleet::set_meanwhile. What it calls must leave the run as it is.
  void set_meanwhile(robot::Meanwhile meanwhile) { fleet_->set_meanwhile(std::move(meanwhile)); }

  /// The operator's stick for one robot.
  void set_joystick(base::RobotId robot, const percept::Joystick& joystick) {
    fleet_->set_joystick(robot, joystick);
  }
  void let_go_of_stick(base::RobotId robot) { fleet_->let_go_of_stick(robot); }
  /// Sets a parameter or constant of one robot's program, from the next cycle on; it outlives a new START.
  /// @param value  as a person writes it, in the port's edge_unit; a Point may be the name of a place
  /// @errors  a sentence that says what is wrong
  std::optional<std::string> set_parameter(base::RobotId robot, std::string_view port,
                                           const std::string& value);
  /// In the next cycle a sequence of the robot's program goes to a state, whatever its triggers say.
  /// @errors  a sentence that says why not; nothing has changed
  std::optional<std::string> force_state(base::RobotId robot, const std::string& sequence,
                                         const std::string& state);
  /// From the next cycle on an output of the robot's program is held at a value, until it is released.
  /// @param value  as a person writes it, in the port's edge_unit
  /// @errors  likewise
  std::optional<std::string> hold_value(base::RobotId robot, const std::string& port,
                                        const std::string& value);
  /// @param port  empty: all that are held
  std::optional<std::string> release_value(base::RobotId robot, const std::string& port);
  /// As fleet::Fleet::replace.
  /// @errors  likewise
  std::optional<std::string> replace_robot(base::RobotId robot);
  bool is_in_real_time() const { return settings_.is_in_real_time; }
  /// As RunSettings::stands_still_for_operator.
  void set_stands_still_for_operator(bool stands_still) {
    settings_.stands_still_for_operator = stands_still;
  }

  /// Where the plan's first START of each robot will put it if the world stays as it is: the next free place
  /// included. In the order in which they start; without those that were started, that no START names, or for
  /// which there is no place. Nothing is changed.
  std::vector<PlannedStart> planned_starts();

  bool is_over() const;
  /// Simulated [s]. Counted in cycles, so that it does not drift; SET CYCLE-DURATION changes the length of
  /// later ones.
  double time() const { return start_of_duration_ + static_cast<double>(cycle_ - first_of_duration_) * dt_; }
  std::uint64_t cycle() const { return cycle_; }
  double cycle_duration() const { return dt_; }  ///< [s]
  std::uint64_t seed() const { return settings_.seed; }
  const mission::Mission& mission() const { return *state_.mission; }
  const mission::State& state() const { return state_; }
  const fleet::Fleet& fleet() const { return *fleet_; }
  /// The world, for who looks on.
  const binding::WorldView& world() const { return binding_->view(); }
  /// What the operator answered so far.
  const std::vector<AnswerRecord>& answers() const { return answers_; }
  /// What people made robots' programs do so far.
  const std::vector<InterventionRecord>& interventions() const { return interventions_; }
  const std::vector<Takeover>& takeovers() const { return takeovers_; }
  /// By unit of the mission.
  const std::vector<UnitMetrics>& unit_metrics() const { return metrics_; }
  /// What robots brought into baskets so far, in the order of time, then of objects.
  const std::vector<Delivery>& deliveries() const { return deliveries_; }
  /// The first kMostFailsafeRecords of them.
  const std::vector<FailsafeRecord>& failsafes() const { return failsafes_; }
  static constexpr std::size_t kMostFailsafeRecords = 100'000;
  /// Cycles run by all robots together.
  std::uint64_t robot_cycles() const { return robot_cycles_; }
  /// How many steps of the mission are done, and how many there are.
  std::size_t steps_done() const;

  /// What holds a robot where it is: what pulls and pushes it, and what is near. Several sentences, for a
  /// person.
  std::vector<std::string> explain(const fleet::FleetRobot& robot) const;

 private:
  Progress brake();
  void change_world(const overlay::Overlay& before, const overlay::Overlay& after);
  void tell_moved(const std::vector<base::RobotId>& moved, std::string_view by);
  void rename_metrics(const mission::Mission& before, const mission::Mission& after);
  void drop_unused_crews();
  void apply(const mission::Effect& effect);
  void start_robot(const mission::effect::Start& start);
  void note_teleoperated();
  void change_environment();
  void happen(const overlay::EnvironmentEvent& event, std::uint64_t execution);
  void measure();
  void note_deliveries();
  void tell(mission::effect::Tell::Kind kind, std::string text);
  void answer_calls();
  void tell_not_forced();
  void tell_faults();
  // Whom a command of the history was for.
  std::vector<base::RobotId> commanded(std::uint32_t command) const;
  void explain_failures(std::uint32_t command);

  RunSettings settings_;
  mission::State state_;
  std::vector<std::shared_ptr<const Crew>> crews_;  // robots point into them; the last one is in force
  std::unique_ptr<binding::Binding> binding_;
  std::unique_ptr<fleet::Fleet> fleet_;
  Observer observer_;
  double dt_ = 0.1;                      // cycle duration [s],
  double start_of_duration_ = 0.0;       // in force since this time [s]
  std::uint64_t first_of_duration_ = 0;  // and this cycle
  std::uint64_t cycle_ = 0;
  std::uint64_t robot_cycles_ = 0;
  std::size_t moved_at_start_ = 0;  // by the effects in hand
  bool is_full_ = false;            // the environment had no room once, which was told
  std::vector<UnitMetrics> metrics_;
  std::vector<AnswerRecord> answers_;
  std::vector<InterventionRecord> interventions_;
  std::vector<Takeover> takeovers_;
  std::vector<base::RobotId> forced_;  // in the coming cycle, ascending
  std::vector<Delivery> deliveries_;
  std::vector<FailsafeRecord> failsafes_;
  std::vector<base::RobotId> teleoperated_;
  std::vector<base::RobotId> carriers_;  // by object id: who carries it; none as well once it was delivered
  bool is_stopped_ = false;
  bool has_braked_ = false;  // for at least one cycle of this stop
  mission::event::Cycle report_;
};

}  // namespace mlab::run
