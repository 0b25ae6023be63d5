#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/binding/binding.h"
#include "mlab/fleet/failsafes.h"
#include "mlab/fleet/fleet_robot.h"
#include "mlab/fleet/fleet_state.h"
#include "mlab/fleet/group.h"
#include "mlab/fleet/messages.h"
#include "mlab/flow/carry_over.h"
#include "mlab/mission/effect.h"
#include "mlab/mission/event.h"
#include "mlab/mission/mission.h"
#include "mlab/percept/action.h"
#include "mlab/percept/needs.h"
#include "mlab/robot/program/program_runners.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::fleet {

/// Is told what the robots' programs answer, as it is before failsafes and bodies make something of it.
class AnswerWitness {
 public:
  virtual ~AnswerWitness() = default;
  /// The robot's program was brought to life, or was not: see its `failure`.
  virtual void note_start(const FleetRobot& robot) = 0;
  /// Those that run are asked now.
  virtual void note_asked(std::span<const FleetRobot> robots) = 0;
  /// They have answered.
  virtual void note_answered(std::span<const FleetRobot> robots) = 0;
};

/// Knows of a run that is computed again whose programs failed in it, and when: machines were lost, processes
/// were killed. Asked between and in cycles, by the run's thread.
class KnownFailures {
 public:
  virtual ~KnownFailures() = default;
  /// Why the robot's program was not brought to life now; null: it was.
  /// @param start  which of the robot's starts this is, from 1
  virtual const std::string* at_start(base::RobotId robot, std::uint32_t start) const = 0;
  /// Some program failed in the cycle that is being computed.
  virtual bool are_any() const = 0;
  /// What the robot's program did in it instead of acting; null: it acted.
  virtual const std::string* in_cycle(base::RobotId robot) const = 0;
};

/// The robots of a run in this process: steps their programs against their bodies, all by the same seed.
///
/// Per cycle: `step` computes what units have in common, senses, runs every program, moves all bodies, and
/// passes on what robots tell each other. Results are the same for any number of threads.
class Fleet {
 public:
  /// @param programs   by index of the mission's robot types; outlive the fleet
  /// @param elsewhere, recorded  as robot::ProgramRunners
  Fleet(const mission::Mission& mission, const std::vector<robot::RobotProgram>& programs,
        const std::vector<binding::BodySpec>& bodies, binding::Binding& binding, std::uint64_t seed,
        std::unique_ptr<robot::ProgramRunner> elsewhere = nullptr,
        std::unique_ptr<robot::ProgramRunner> recorded = nullptr);

  /// @param witness  outlives this, or another one is set; null: there is none
  void set_witness(AnswerWitness* witness) { witness_ = witness; }
  /// Programs fail where these say so, as if they did by themselves.
  /// @param failures  null: they fail by themselves alone
  void set_known_failures(std::unique_ptr<KnownFailures> failures) { known_failures_ = std::move(failures); }

  /// Brings a robot into the world.
  /// @return  where it stands
  /// @errors  a sentence about the robot: `is started already`
  std::expected<binding::Placement, std::string> start(base::RobotId robot, geom::Pose pose);
  /// Another robot of its type takes the place of one that stands because of a fault: its program begins anew
  /// where it stands, wherever programs can be run now, under the order that the robot has. A body that is
  /// gone gives way to another one.
  /// @errors  a sentence that says why not; the robot stands, for what has gone wrong now
  std::optional<std::string> replace(base::RobotId robot);
  void order(const mission::effect::Order& order);
  /// Ends the robot's program; its body keeps standing.
  void stop(base::RobotId robot);
  /// Somebody holds the stick, which may be in its middle.
  void set_joystick(base::RobotId robot, const percept::Joystick& joystick);
  /// Nobody holds it.
  void let_go_of_stick(base::RobotId robot);
  /// Whom an operator is to steer from now on, and nobody else; ascending.
  void set_teleoperated(std::span<const base::RobotId> robots);

  /// @errors  a sentence that says what is wrong
  std::optional<std::string> set_parameter(base::RobotId robot, std::string_view port,
                                           const std::string& value);

  /// What a person makes a robot's program do, see flow::Interventions.
  /// @errors  a sentence that says why not
  std::optional<std::string> force(base::RobotId robot, std::string_view sequence, std::string_view state);
  std::optional<std::string> hold(base::RobotId robot, std::string_view port, std::string_view value);
  /// @param port  empty: all
  std::optional<std::string> release(base::RobotId robot, std::string_view port);

  /// Robots of another version of the mission, see MissionRun::edit.
  /// @param programs, bodies  as for the constructor; what it was made with before is needed as long as
  ///                          `uses` says so
  void edit(const mission::Mission& mission, const std::vector<robot::RobotProgram>& programs,
            const std::vector<binding::BodySpec>& bodies);
  /// As `edit`, and robots in the world go on with the new programs, see MissionRun::take_over.
  /// @param restarts  what of whom begins anew is added
  /// @return  whose program has changed
  std::vector<base::RobotId> take_over(const mission::Mission& mission,
                                       const std::vector<robot::RobotProgram>& programs,
                                       const std::vector<binding::BodySpec>& bodies,
                                       std::vector<std::pair<base::RobotId, flow::Restart>>& restarts);
  /// True where a robot's program is one of these.
  bool uses(const std::vector<robot::RobotProgram>& programs) const;

  /// Asked again and again while `step` waits for a robot's own process; true: nobody has time for it any
  /// more, it is ended, and its robot stands.
  void set_meanwhile(robot::Meanwhile meanwhile) { meanwhile_ = std::move(meanwhile); }

  /// One control cycle of all robots [s].
  void step(double dt);
  /// One cycle in which no program runs and every body brakes [s].
  void brake(double dt);
  /// Robots in the world, and those of them that have not come to rest.
  struct Bodies {
    std::size_t all = 0;
    std::size_t moving = 0;
  };
  Bodies bodies() const;

  const std::vector<FleetRobot>& robots() const { return now_.robots; }
  /// That carry some of the robots.
  std::vector<robot::SilentMachine> silent_machines() const;
  /// Of those that nobody waits for; null: all are waited for.
  const robot::Punctuality* punctuality() const;
  const FleetRobot* find(base::RobotId id) const;
  geom::Pose pose(const FleetRobot& robot) const { return now_.poses[index_of(robot)]; }
  /// The failsafe that the robot is under, as the mission's language writes it; empty: none.
  std::string failsafe(const FleetRobot& robot) const;
  /// The table that is in force, and how each of its rows stands for the robot, between two cycles [s].
  const Failsafes& failsafes() const { return *now_.failsafes; }
  std::vector<RowStanding> standings(const FleetRobot& robot, double dt) const;
  /// What its failsafes look at, but for what is in its way. Of a robot that was not started, what is known
  /// of its body.
  Situation situation(const FleetRobot& robot) const;
  /// The group under whose order the robot is; null without an order.
  const Group* group(const FleetRobot& robot) const;
  /// Distance of the robot from its station [m]; 0 without a formation.
  double station_error(const FleetRobot& robot) const;
  /// Where its formation wants the robot [m, world]; nothing without a formation.
  std::optional<geom::Point> station_place(const FleetRobot& robot) const;
  /// What the executive wants to know of every started robot, by id. Fills `out`.
  void report(std::vector<mission::RobotReport>& out) const;

  /// What robots called since the last time that somebody asked, by cycle and robot.
  std::vector<RobotCall> take_calls();
  /// Puts a notification into a robot's inbox, as another robot's would be: it reads it in the next cycle.
  void notify(base::RobotId id, std::string_view notification);

  /// What a robot would perceive in the next cycle if it stood elsewhere. Nothing has changed afterwards; to
  /// be called between cycles. Its lists are valid until something is sensed again.
  /// @param needs  of its program, or of a part of it
  percept::Percepts perceive_at(const FleetRobot& robot, const geom::Pose& pose, const percept::Needs& needs,
                                double dt) const;

  /// How it stands, between two cycles.
  /// @errors  a sentence: a robot's values are kept where they can't be put back
  std::expected<FleetCheckpoint, std::string> save() const;
  /// Goes on from there. Robots whose program is still computed at the same place keep their processes.
  /// @param checkpoint  of this fleet, or of one of the same mission, programs and seed; its programs are
  ///                    there as long as `uses` says so
  void restore(const FleetCheckpoint& checkpoint);

  /// Robots that faulted since the last call, to be told once.
  std::vector<base::RobotId> take_new_faults();

 private:
  static constexpr std::size_t kRobotsAtOnce = binding::Binding::kMostAtOnce;
  /// Some robots' part of the cycle.
  struct Worker {
    std::array<std::uint32_t, kRobotsAtOnce> robots{};  // indices of those that run
    std::array<robot::ProgramRunner::Member, kRobotsAtOnce> members{};
    std::array<percept::Needs, kRobotsAtOnce> needs;
    std::array<percept::Percepts, kRobotsAtOnce> percepts;
    std::array<robot::ProgramRunner::Turn, kRobotsAtOnce> turns;
    std::array<binding::Sensing, kRobotsAtOnce> senses;
    std::vector<std::pair<std::uint32_t, ways::Round>> found;   // on the ground, and new; by robot's index
    std::vector<std::pair<std::uint32_t, geom::Point>> missed;  // what is known and no longer there, likewise
  };
  /// As find.
  FleetRobot* find_own(base::RobotId id);
  /// One whose program runs now. @errors  a sentence
  std::expected<FleetRobot*, std::string> running(base::RobotId id);
  std::size_t index_of(const FleetRobot& robot) const {
    return static_cast<std::size_t>(&robot - now_.robots.data());
  }
  FleetRobot make_robot(const mission::Mission& mission, const mission::Robot& declared,
                        const std::vector<robot::RobotProgram>& programs,
                        const std::vector<binding::BodySpec>& bodies);
  /// What the mission says besides of its robots: teams, failsafes, the map.
  void adopt(const mission::Mission& mission);
  void form_teams(const mission::Mission& mission);
  void exchange_ground(const mission::Mission& mission);
  void note_calls(const FleetRobot& robot);
  void leave_groups(std::span<const std::uint32_t> members);
  /// @errors  as Fleet::start
  std::expected<binding::Placement, std::string> embody(FleetRobot& robot, geom::Pose pose);
  void update_poses();
  void look_after_bodies();
  /// Gives the robot's program to who runs it, and takes it from there.
  void enrol(FleetRobot& robot);
  void enrol_again(FleetRobot& robot, const robot::RobotMemory& memory);
  static void dismiss(const FleetRobot& robot);
  /// @param exchange  called for robots in the world that can't keep their program
  void edit(const mission::Mission& mission, const std::vector<robot::RobotProgram>& programs,
            const std::vector<binding::BodySpec>& bodies,
            const std::function<void(FleetRobot&, const robot::RobotProgram&)>& exchange);
  std::vector<flow::Restart> exchange_program(FleetRobot& robot, const robot::RobotProgram& after);
  /// @return  false: it has failed at once, and why stands in the robot
  bool start_program(FleetRobot& robot);
  /// All that is not sensed: orders, the unit, what people and robots say.
  void add_told(const FleetRobot& robot, const percept::Needs& needs, double dt,
                percept::Percepts& out) const;
  const TeamGround& ground_of(const FleetRobot& robot) const;
  bool is_wreck(const FleetRobot& robot) const;
  /// Whether a wreck stands there.
  bool is_of_wreck(geom::Point place) const;
  /// @param reach  how far it sees everything [m]; 0: it may overlook things
  void note_found(std::uint32_t robot, const percept::Percepts& percepts, double reach, Worker& worker) const;
  /// Teams remember what their robots found, and forget what they missed.
  void add_found();
  void run_programs(double dt);
  void fail_as_known();
  void run_piece(std::size_t begin, std::size_t end, double dt, int worker);
  void collect(FleetRobot& robot, double dt);
  /// What the program wants passes through the failsafes. @return  false: it is stopped
  bool guard(FleetRobot& robot, double dt);
  /// Its program is gone, its body goes on.
  void go_on_by_failsafe(FleetRobot& robot, double dt);
  void exchange_failsafes(const mission::Mission& mission);
  void note_seen(std::size_t robot, const percept::Percepts& percepts);
  /// With what is in its way.
  Situation situation_of(const FleetRobot& robot, double dt);
  void look_for_passage(const FleetRobot& robot, double reach);

  binding::Binding& binding_;
  FleetState now_;
  std::vector<binding::BodyIndex> bodies_;  // of now_.robots
  binding::Passage passage_;
  std::vector<percept::Action> actions_;  // by body
  std::vector<Worker> workers_;
  robot::ProgramRunners runners_;
  robot::Meanwhile meanwhile_;
  AnswerWitness* witness_ = nullptr;
  std::unique_ptr<KnownFailures> known_failures_;
  std::vector<binding::Ailment> ailments_;
};

}  // namespace mlab::fleet
