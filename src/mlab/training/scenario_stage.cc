#include "mlab/training/scenario_stage.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/sim/bench_scenario.h"
#include "mlab/sim/simulator.h"
#include "mlab/training/action_columns.h"
#include "mlab/training/seen_columns.h"

namespace mlab::training {
namespace {

constexpr std::size_t kRobotsAtOnce = 64;  // what a thread takes in one piece, so that it stays in the cache

class ScenarioStage final : public Stage {
 public:
  ScenarioStage(const ScenarioSettings& settings, std::shared_ptr<const flow::Program> program,
                SeenColumns seen, ActionColumns acted)
      : settings_(settings),
        program_(std::move(program)),
        seen_(std::move(seen)),
        acted_(std::move(acted)),
        scenario_(sim::make_bench_scenario(settings.robots, settings.places)),
        initial_(program_->make_frame()) {
    if (const flow::Port* half = program_->find(settings_.half_parameter))
      program_->set(initial_.data(), *half, fmt::format("{}", sim::kShareOfArena * scenario_.side / 2.0));
    for (std::uint32_t i = 1; i <= settings_.robots; ++i) robots_.push_back({i});
    reset(1);
  }

  const std::vector<base::RobotId>& robots() const override { return robots_; }
  const std::vector<Column>& seen() const override { return seen_.columns(); }
  const std::vector<Column>& acted() const override { return acted_.columns(); }

  std::optional<std::string> reset(std::uint64_t seed) override {
    seed_ = seed;
    simulator_ = std::make_unique<sim::Simulator>(
        sim::bench_world(scenario_), sim::SimulatorSettings{.seed = seed, .threads = settings_.threads});
    const sim::BodySpec spec = sim::bench_body(settings_.range);
    for (std::size_t i = 0; i < robots_.size(); ++i)
      simulator_->add_body({.spec = spec, .pose = scenario_.robots[i], .robot = robots_[i]});
    frames_.assign(robots_.size(), initial_);
    actions_.assign(robots_.size(), {});
    percepts_.assign(robots_.size(), {});
    buffers_.clear();
    buffers_.resize(robots_.size());
    for (sim::SenseBuffer& buffer : buffers_) buffer.reserve(0, 0, 0, spec.ring.count);
    sense_all({});
    return std::nullopt;
  }

  std::optional<std::string> step(std::span<const double> actions,
                                  const std::function<bool()>& /*is_given_up*/,
                                  std::span<double> seen) override {
    const std::size_t width = acted_.count();
    for (std::size_t i = 0; width > 0 && i < robots_.size(); ++i) {
      const double* const row = actions.data() + i * width;
      if (const auto column = acted_.refused(row))
        return fmt::format("row {}: {}", i, acted_.why_refused(*column, row[*column]));
    }
    for_each_robot([&](std::size_t i) {
      if (width > 0) acted_.write(frames_[i].data(), actions.data() + i * width);
      actions_[i] = {};
      program_->step(frames_[i].data(), percepts_[i], actions_[i], seed_, robots_[i].value);
    });
    simulator_->step(actions_, settings_.cycle_duration);
    sense_all(seen);
    return std::nullopt;
  }

  void observe(std::span<double> out) override {
    for_each_robot([&](std::size_t i) { look_at(i, out); });
  }

  bool is_over() const override { return false; }
  void ended(std::span<std::uint8_t> out) const override { std::ranges::fill(out, std::uint8_t{0}); }
  double time() const override { return simulator_->time(); }
  std::uint64_t cycle() const override { return simulator_->cycle(); }
  double cycle_duration() const override { return settings_.cycle_duration; }

 private:
  // What robots see is what they act on in the next cycle: between the two nothing moves.
  void sense_all(std::span<double> seen) {
    for_each_robot([&](std::size_t i) {
      percept::Needs needs = program_->needs(frames_[i].data());
      if (seen_.wants_ranges()) needs.want(percept::Sensor::kRanges);
      simulator_->sense({static_cast<std::uint32_t>(i)}, needs, buffers_[i], percepts_[i]);
      if (!seen.empty()) look_at(i, seen);
    });
  }

  void look_at(std::size_t i, std::span<double> out) {
    const sim::BodyIndex body{static_cast<std::uint32_t>(i)};
    SeenBody seen{.pose = {}, .contacts = 0.0, .driven = 0.0, .ranges = percepts_[i].ranges};
    if (seen_.wants_body()) {
      seen.pose = simulator_->pose(body);
      seen.contacts = simulator_->contacts(body);
      seen.driven = simulator_->distance_driven(body);
    }
    seen_.read(frames_[i].data(), seen, out.data() + i * seen_.count());
  }

  template <class Do>
  void for_each_robot(const Do& work) {
    simulator_->workers().run(robots_.size(), kRobotsAtOnce,
                              [&](std::size_t first, std::size_t last, int /*worker*/) {
                                for (std::size_t i = first; i < last; ++i) work(i);
                              });
  }

  ScenarioSettings settings_;
  std::shared_ptr<const flow::Program> program_;
  SeenColumns seen_;
  ActionColumns acted_;
  sim::BenchScenario scenario_;
  flow::Frame initial_;
  std::uint64_t seed_ = 1;
  std::vector<base::RobotId> robots_;
  std::unique_ptr<sim::Simulator> simulator_;
  // By robot:
  std::vector<flow::Frame> frames_;
  std::vector<percept::Action> actions_;
  std::vector<percept::Percepts> percepts_;  // lists lie in buffers_
  std::vector<sim::SenseBuffer> buffers_;
};

}  // namespace

std::expected<std::unique_ptr<Stage>, std::string> make_scenario_stage(
    const ScenarioSettings& settings, std::shared_ptr<const flow::Program> program,
    std::span<const std::string> seen, std::span<const std::string> acted) {
  auto shown = SeenColumns::of(*program, seen, sim::bench_body(settings.range).ring);
  if (!shown) return std::unexpected(std::move(shown.error()));
  auto taken = ActionColumns::of(*program, acted, false);
  if (!taken) return std::unexpected(std::move(taken.error()));
  return std::make_unique<ScenarioStage>(settings, std::move(program), std::move(*shown), std::move(*taken));
}

}  // namespace mlab::training
