#include "mlab/console/past/survey.h"

#include <algorithm>
#include <utility>

#include "mlab/console/published/overview.h"
#include "mlab/console/run/measure_series.h"
#include "mlab/console/session/request.h"

namespace mlab::console {

Survey::Survey(std::unique_ptr<history::Replay> replay, const std::vector<Series>& series,
               const std::vector<std::uint32_t>& states_of)
    : replay_(std::move(replay)) {
  series_.watch(series, 0.0);
  for (const std::uint32_t robot : states_of) robots_.try_emplace(robot);
}

void Survey::advance(double seconds) {
  const double end = wall_time() + seconds;
  while (replay_->step()) {
    look();
    if (wall_time() >= end) break;
  }
}

void Survey::look() {
  const run::MissionRun& run = replay_->run();
  known_to_ = run.time();
  series_.look(run);
  for (auto& [id, known] : robots_) look_at(known, id);
}

void Survey::look_at(Robot& known, std::uint32_t id) {
  const fleet::FleetRobot* const robot = replay_->run().fleet().find({id});
  const bool runs =
      robot != nullptr && robot->life == fleet::RobotLife::kRunning && robot->workings().program;
  if (!runs) {
    for (Track& track : known.tracks) note(track, "");
    known.program = nullptr;
    return;
  }
  const flow::Program& program = *robot->workings().program;
  const std::byte* const frame = robot->workings().frame;
  program.sequence_states(frame, known.states);
  if (known.program != &program) {
    known.program = &program;
    known.sequences.clear();
    for (std::uint32_t i = 0; i < known.states.size(); ++i) {
      const std::string path = clean(program.sequence_name(i));
      auto at = std::ranges::find(known.tracks, path, &Track::path);
      if (at == known.tracks.end()) at = known.tracks.insert(at, Track{path, "", {}});
      known.sequences.push_back(static_cast<std::size_t>(at - known.tracks.begin()));
    }
  }
  const auto now = static_cast<std::uint32_t>(flow::Program::cycle(frame));
  for (std::uint32_t i = 0; i < known.states.size(); ++i) {
    const flow::Program::SequenceState& state = known.states[i];
    note(known.tracks[known.sequences[i]],
         state.cycle == now ? program.state_names(i)[state.active] : std::string());
  }
}

void Survey::note(Track& track, const std::string& state) const {
  if (track.state == state) return;
  track.state = state;
  Past::Sequence::Span span;
  span.set_begin(known_to_);
  span.set_state(clean(state));
  track.spans.push_back(std::move(span));
}

void Survey::encode(const Series& series, Past::Samples& out) const {
  out.set_id(series.id());
  series_.encode_since(series, -1.0, *out.mutable_samples());
  if (out.samples().empty()) out.set_error(problem_of(replay_->run(), series));
}

void Survey::encode_states(std::uint32_t robot, Past::States& out) const {
  out.set_robot(robot);
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return;
  for (const Track& track : known->second.tracks) {
    Past::Sequence& told = *out.add_sequences();
    told.set_path(track.path);
    for (const Past::Sequence::Span& span : track.spans) *told.add_spans() = span;
  }
}

}  // namespace mlab::console
