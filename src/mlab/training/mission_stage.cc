#include "mlab/training/mission_stage.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "mlab/training/action_columns.h"
#include "mlab/training/seen_columns.h"

namespace mlab::training {
namespace {

using run::MissionRun;

class MissionStage final : public Stage {
 public:
  MissionStage(RunMaker make, std::vector<base::RobotId> robots, std::vector<std::string> seen,
               std::vector<std::string> acted)
      : make_(std::move(make)),
        robots_(std::move(robots)),
        wanted_(std::move(seen)),
        taken_(std::move(acted)) {}

  const std::vector<base::RobotId>& robots() const override { return robots_; }
  const std::vector<Column>& seen() const override { return seen_.front().columns(); }
  const std::vector<Column>& acted() const override { return acted_.front().columns(); }

  std::optional<std::string> reset(std::uint64_t seed) override {
    auto made = make_(seed);
    if (!made) return std::move(made.error());
    if (auto problem = find_columns(**made)) return problem;
    run_ = std::move(*made);
    run_->post(mission::event::Execute{});
    run_->look();  // robots that start at once are there
    last_.assign(robots_.size() * acted().size(), std::numeric_limits<double>::quiet_NaN());
    is_over_ = false;
    return std::nullopt;
  }

  std::optional<std::string> step(std::span<const double> actions, const std::function<bool()>& is_given_up,
                                  std::span<double> seen) override {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const double* const row = actions.data() + i * acted_[i].count();
      if (const auto column = acted_[i].refused(row))
        return fmt::format("row {} (robot {}): {}", i, robots_[i].value,
                           acted_[i].why_refused(*column, row[*column]));
    }
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (auto problem = act(i, actions.data() + i * acted_[i].count()))
        return fmt::format("row {} (robot {}): {}", i, robots_[i].value, *problem);
    }
    run_->set_meanwhile(is_given_up);
    is_over_ = run_->step() != MissionRun::Progress::kStepped;
    run_->set_meanwhile({});
    if (!seen.empty()) observe(seen);
    return std::nullopt;
  }

  void observe(std::span<double> out) override {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const fleet::FleetRobot& robot = *run_->fleet().find(robots_[i]);
      const robot::Workings at = robot.workings();
      double* const row = out.data() + i * seen_[i].count();
      if (at.program != programs_[i]) {  // another one was put in its place
        std::fill_n(row, seen_[i].count(), std::numeric_limits<double>::quiet_NaN());
        continue;
      }
      seen_[i].read(at.frame, body_of(robot, seen_[i]), row);
    }
  }

  bool is_over() const override { return is_over_; }
  void ended(std::span<std::uint8_t> out) const override {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const fleet::RobotLife life = run_->fleet().find(robots_[i])->life;
      out[i] = is_over_ || life == fleet::RobotLife::kStopped || life == fleet::RobotLife::kFaulted ? 1 : 0;
    }
  }
  double time() const override { return run_->time(); }
  std::uint64_t cycle() const override { return run_->cycle(); }
  double cycle_duration() const override { return run_->cycle_duration(); }

 private:
  // Robots of different types have programs of their own, with the same ports in other places.
  std::optional<std::string> find_columns(const MissionRun& run) {
    if (robots_.empty()) {
      for (const fleet::FleetRobot& robot : run.fleet().robots()) robots_.push_back(robot.id);
    }
    if (robots_.empty()) return "the mission has no robots";
    seen_.clear();
    acted_.clear();
    programs_.clear();
    for (const base::RobotId id : robots_) {
      const fleet::FleetRobot* const robot = run.fleet().find(id);
      if (robot == nullptr) return fmt::format("there is no robot {}", id.value);
      const robot::Workings at = robot->workings();
      if (!at) return fmt::format("robot {}: its program keeps its values elsewhere", id.value);
      auto seen = SeenColumns::of(*at.program, wanted_, robot->body_spec.ring);
      if (!seen) return fmt::format("robot {}: {}", id.value, seen.error());
      auto acted = ActionColumns::of(*at.program, taken_, true);
      if (!acted) return fmt::format("robot {}: {}", id.value, acted.error());
      if (!seen_.empty() &&
          (seen->count() != seen_.front().count() || acted->count() != acted_.front().count()))
        return fmt::format("robot {}: its ports give another number of columns than those of robot {}",
                           id.value, robots_.front().value);
      seen_.push_back(std::move(*seen));
      acted_.push_back(std::move(*acted));
      programs_.push_back(at.program);
    }
    return std::nullopt;
  }

  // What has not changed is there already.
  std::optional<std::string> act(std::size_t i, const double* row) {
    double* const last = last_.data() + i * acted_[i].count();
    for (const ActionColumns::Value& value : acted_[i].values()) {
      if (std::equal(row + value.first, row + value.first + value.count, last + value.first)) continue;
      const std::string text = ActionColumns::text_of(value, row);
      const bool is_held = value.port->role == flow::Port::Role::kOutput;
      const auto problem = is_held ? run_->hold_value(robots_[i], value.port->path, text)
                                   : run_->set_parameter(robots_[i], value.port->path, text);
      // Who does not run yet, or any more, holds nothing; it is tried again.
      if (problem && run_->fleet().find(robots_[i])->life == fleet::RobotLife::kRunning) return problem;
      if (!problem) std::copy_n(row + value.first, value.count, last + value.first);
    }
    return std::nullopt;
  }

  SeenBody body_of(const fleet::FleetRobot& robot, const SeenColumns& columns) const {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    if (robot.life == fleet::RobotLife::kNotStarted)
      return {.pose = {{kNone, kNone}, kNone}, .contacts = kNone, .driven = kNone, .ranges = {}};
    SeenBody out{.pose = run_->fleet().pose(robot), .contacts = 0.0, .driven = 0.0, .ranges = {}};
    if (columns.wants_body()) {
      const binding::BodyState body = run_->world().body(robot.body);
      out.contacts = body.contacts;
      out.driven = body.distance_driven;
    }
    if (columns.wants_ranges())
      out.ranges = run_->world().sense(robot.body, {{percept::Sensor::kRanges}}).ranges;
    return out;
  }

  RunMaker make_;
  std::vector<base::RobotId> robots_;
  std::vector<std::string> wanted_;
  std::vector<std::string> taken_;
  std::unique_ptr<MissionRun> run_;
  bool is_over_ = false;
  // By row:
  std::vector<SeenColumns> seen_;
  std::vector<ActionColumns> acted_;
  std::vector<const flow::Program*> programs_;
  std::vector<double> last_;  // what was set or held, all rows
};

}  // namespace

std::expected<std::unique_ptr<Stage>, std::string> make_mission_stage(RunMaker make,
                                                                      std::vector<base::RobotId> robots,
                                                                      std::vector<std::string> seen,
                                                                      std::vector<std::string> acted) {
  auto out =
      std::make_unique<MissionStage>(std::move(make), std::move(robots), std::move(seen), std::move(acted));
  if (auto problem = out->reset(1)) return std::unexpected(std::move(*problem));
  return out;
}

}  // namespace mlab::training
