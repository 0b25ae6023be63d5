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
#include "mlab/run/checkpoint.h"
#include "mlab/run/crew.h"
#include "mlab/run/input.h"
#include "mlab/run/intervention.h"
#include "mlab/run/records.h"
#include "mlab/run/run_state.h"
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
  /// Whether the host that a robot's type names is a vehicle, and so its body; may wait for it to be found.
  /// Empty: none is.
  std::function<bool(const std::string& host)> is_vehicle = {};
  /// Makes the bodies of a mission some of whose robots are vehicles out of simulated ones; empty: all are
  /// simulated.
  std::function<std::unique_ptr<binding::Binding>(const mission::Mission& mission,
                                                  std::unique_ptr<binding::Binding> simulated)>
      vehicles = {};
  /// What programs answered that can't be computed again.
  struct Recorded {
    /// Makes what says it for one run, of which it is told how many cycles have run, the one that is being
    /// computed included; empty: there are none.
    std::function<std::unique_ptr<robot::ProgramRunner>(std::function<std::uint64_t()> cycle)> runner = {};
    bool is_of_all = false;  ///< all programs that can be elsewhere are among these
    /// Likewise, makes what knows which programs failed; empty: they fail by themselves alone.
    std::function<std::unique_ptr<fleet::KnownFailures>(std::function<std::uint64_t()> cycle)> failures = {};
  };
  Recorded recorded = {};
  std::shared_ptr<StopLine> stop_line = {};  ///< null: the emergency stop is this run's own
  bool is_in_real_time =
      false;  ///< robots elsewhere are not waited for: time passes as on the clock, no faster
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
  MissionRun(const MissionRun&) = delete;
  MissionRun& operator=(const MissionRun&) = delete;

  /// Called for everything that the executive wants told, asked, shown or set, when it happens.
  using Observer = std::function<void(const mission::Effect&)>;
  void set_observer(Observer observer) { observer_ = std::move(observer); }
  /// As binding::Binding::vehicles.
  std::vector<std::string> vehicles() const { return binding_->vehicles(); }
  /// As binding::Binding::vehicle.
  std::optional<binding::VehicleState> vehicle(std::string_view name) const {
    return binding_->vehicle(name);
  }
  /// Takes what bodies that are not simulated have said, as each cycle does: for who looks at a run that
  /// stands.
  void hear_bodies();

  /// Called for all that comes in from outside, before it has any effect.
  using InputObserver = std::function<void(const Moment&, const Input&)>;
  void set_input_observer(InputObserver observer) { input_observer_ = std::move(observer); }
  /// As fleet::Fleet.
  void set_answer_witness(fleet::AnswerWitness* witness) { fleet_->set_witness(witness); }
  /// What the settings know of failures has been computed: from now on programs fail by themselves alone.
  void forget_known_failures() { fleet_->set_known_failures(nullptr); }
  /// Takes what came into another run of this mission. What was refused there is refused here.
  void take(const Input& input);
  /// Where the run stands.
  Moment moment() const { return {now_.cycle, now_.has_looked}; }
  /// The executive is told how the robots stand, as `step` does before a cycle; at most once in a moment.
  void look();

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
  void set_emergency_stop(bool stopped);
  bool is_stopped() const { return now_.is_stopped; }
  /// How many robots are in the world, and how many of these the stop has brought to stand: none before the
  /// first cycle in which they were braked.
  std::size_t robots_in_world() const { return fleet_->bodies().all; }
  std::size_t robots_stopped() const {
    const fleet::Fleet::Bodies bodies = fleet_->bodies();
    return now_.is_stopped && now_.has_braked ? bodies.all - bodies.moving : 0;
  }

  /// As fleet::Fleet::set_meanwhile. What it calls must leave the run as it is.
  void set_meanwhile(robot::Meanwhile meanwhile) { fleet_->set_meanwhile(std::move(meanwhile)); }

  /// The operator's stick for one robot.
  void set_joystick(base::RobotId robot, const percept::Joystick& joystick);
  void let_go_of_stick(base::RobotId robot);
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
  void set_stands_still_for_operator(bool stands_still);
  bool stands_still_for_operator() const { return now_.stands_still_for_operator; }

  /// How the run stands, between two calls: all that decides how it goes on.
  /// @errors  a sentence: robots or bodies are where nobody can put them back
  std::expected<Checkpoint, std::string> save() const;
  /// Goes on from there, back or ahead, and takes whatever comes in as the run did from which it is. Nobody
  /// is told of it: neither observer is called.
  /// @param checkpoint  of this run, or of another one of the same crew and settings
  /// @errors  a sentence: it is of a run of another kind; nothing has changed
  std::optional<std::string> restore(const Checkpoint& checkpoint);

  /// Where the plan's first START of each robot will put it if the world stays as it is: the next free place
  /// included. In the order in which they start; without those that were started, that no START names, or for
  /// which there is no place. Nothing is changed.
  std::vector<PlannedStart> planned_starts() const;

  bool is_over() const;
  /// Simulated [s]. Counted in cycles, so that it does not drift; SET CYCLE-DURATION changes the length of
  /// later ones.
  double time() const { return now_.time(); }
  std::uint64_t cycle() const { return now_.cycle; }
  double cycle_duration() const { return now_.dt; }  ///< [s]
  std::uint64_t seed() const { return settings_.seed; }
  const RunSettings& settings() const { return settings_; }
  /// What its robots are made of, as of the last edit.
  const std::shared_ptr<const Crew>& crew() const { return now_.crews.back(); }
  const mission::Mission& mission() const { return *now_.executive.mission; }
  const mission::State& state() const { return now_.executive; }
  const fleet::Fleet& fleet() const { return *fleet_; }
  /// The world, for who looks on.
  const binding::WorldView& world() const { return binding_->view(); }
  /// What the operator answered so far.
  const std::vector<AnswerRecord>& answers() const { return now_.answers; }
  /// What people made robots' programs do so far.
  const std::vector<InterventionRecord>& interventions() const { return now_.interventions; }
  const std::vector<Takeover>& takeovers() const { return now_.takeovers; }
  /// By unit of the mission.
  const std::vector<UnitMetrics>& unit_metrics() const { return now_.metrics; }
  /// What robots brought into baskets so far, in the order of time, then of objects.
  const std::vector<Delivery>& deliveries() const { return now_.deliveries; }
  /// The first kMostFailsafeRecords of them.
  const std::vector<FailsafeRecord>& failsafes() const { return now_.failsafes; }
  static constexpr std::size_t kMostFailsafeRecords = 100'000;
  /// Cycles run by all robots together.
  std::uint64_t robot_cycles() const { return now_.robot_cycles; }
  /// How many steps of the mission are done, and how many there are.
  std::size_t steps_done() const;

  /// What holds a robot where it is: what pulls and pushes it, and what is near. Several sentences, for a
  /// person.
  std::vector<std::string> explain(const fleet::FleetRobot& robot) const;

 private:
  Progress brake();
  /// Something comes in.
  void note(const Input& input);
  void hear(const binding::Heard& heard);
  void carry_out(const mission::Event& event);
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
  void measure_way(std::size_t robot, const fleet::Group& group, UnitMetrics& metrics);
  void note_deliveries();
  void tell(mission::effect::Tell::Kind kind, std::string text);
  void answer_calls();
  void tell_not_forced();
  // @return  whose program has stopped since it was told last
  std::vector<base::RobotId> tell_faults();
  // Whom a command of the history was for.
  std::vector<base::RobotId> commanded(std::uint32_t command) const;
  void explain_failures(std::uint32_t command);

  RunSettings settings_;
  RunState now_;
  std::unique_ptr<binding::Binding> binding_;
  std::unique_ptr<fleet::Fleet> fleet_;
  Observer observer_;
  InputObserver input_observer_;
  std::vector<binding::Heard> heard_;                // of this cycle
  std::vector<base::RobotId> teleoperated_;          // filled anew in each cycle
  mission::Event report_ = mission::event::Cycle{};  // filled anew for each
  std::vector<mission::RobotReport> seen_;           // likewise, before anybody is told
};

}  // namespace mlab::run
