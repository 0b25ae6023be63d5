#include "mlab/cli/run_recording.h"

#include <utility>

#include <fmt/core.h>

namespace mlab::cli {

RunRecording::RunRecording(std::string file, run::MissionRun& run,
                           const history::Circumstances& circumstances, double viewer_rate)
    : recorder_([path = std::move(file)] { return path; }, run, circumstances) {
  if (viewer_rate <= 0.0) return;
  viewers_ = std::make_unique<viewers::Viewers>(
      [this](const std::string& topic, const google::protobuf::Message& message) {
        recorder_.put_beside(topic, message);
      },
      run, circumstances.started_at, viewers::Rates{.poses = viewer_rate});
}

void RunRecording::see(const mission::Effect& effect) {
  recorder_.see(effect);
  // Before there is a file nothing has happened that a viewer would show.
  if (viewers_ && recorder_.is_recording()) viewers_->see(effect);
}

void RunRecording::note(run::MissionRun::Progress progress) {
  if (progress != run::MissionRun::Progress::kStepped) {
    recorder_.note_rest();
    return;
  }
  if (viewers_ && recorder_.is_recording()) viewers_->note_cycle();
  recorder_.note_cycle();
}

std::string RunRecording::take_problem() {
  if (is_problem_taken_ || recorder_.problem().empty()) return "";
  is_problem_taken_ = true;
  return recorder_.problem();
}

bool RunRecording::end(const std::string& command, const std::string& outcome) {
  recorder_.end(outcome);
  if (recorder_.problem().empty()) {
    fmt::print("recording: {}\n", recorder_.path());
    return true;
  }
  fmt::print(stderr, "{}: the recording is not whole: {}\n", command, recorder_.problem());
  return false;
}

}  // namespace mlab::cli
