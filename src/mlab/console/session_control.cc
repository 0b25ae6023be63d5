#include <algorithm>
#include <cctype>
#include <variant>

#include <fmt/core.h>

#include "mlab/console/overview.h"
#include "mlab/console/session_parts.h"
#include "mlab/console/status_encoder.h"
#include "mlab/console/targets.h"

namespace mlab::console {
namespace {

namespace event = mission::event;

constexpr const char* kNoRun = "there is no mission that could run";
constexpr const char* kLoading = "the mission is still being made ready";
constexpr const char* kStopped = "an emergency stop holds all robots: release it first";

std::string name_of(Control::Action action) {
  std::string name = Control::Action_Name(action);
  std::ranges::replace(name, '_', ' ');
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

}  // namespace

void Session::Parts::note(const std::string& who, const std::string& what) {
  log_.add(sim_time(), {Log::OPERATOR, fmt::format("{}: {}", who, what), 0, "", {}, false});
}

void Session::Parts::post(const mission::Event& event) {
  live_->run().post(event);
  has_nothing_to_do_ = false;
  changes_.status = changes_.questions = true;
  ++version_;
}

Session::Parts::Answered Session::Parts::why_not_now() const {
  if (!live_ || is_loading_) return is_loading_ ? kLoading : kNoRun;
  if (is_stopped_) return kStopped;
  if (live_->run().state().mode == mission::State::Mode::kQuit) return "the mission has quit: restart it";
  return std::nullopt;
}

Session::Parts::Answered Session::Parts::control(const std::string& who, const Control& control) {
  if (control.action() == Control::RESTART) {
    if (!documents_.mission()) return kNoRun;
    note(who, "restart");
    load(control.has_seed() ? control.seed() : seed_);
    return std::nullopt;
  }
  if (control.action() == Control::RELEASE_STOP) {
    if (!is_stopped_) return "there is no emergency stop";
    release_stop(who);
    return std::nullopt;
  }
  if (auto refused = why_not_now()) return refused;
  const mission::State& state = live_->run().state();
  const bool is_running = state.mode == mission::State::Mode::kRunning;
  if (control.action() == Control::JUMP && control.step() >= state.mission->steps.size())
    return fmt::format("there is no step {} in this mission", control.step());
  if (control.action() == Control::PAUSE && !is_running) return "nothing runs";
  if (control.action() == Control::SKIP_STEP && !state.in_step &&
      state.step + 1 >= state.mission->steps.size())
    return "there is no step after this one";
  const bool has_ended = mode_of(live_->run()) == Status::ENDED;
  if (control.action() == Control::JUMP && has_ended) return "the mission has ended: restart it first";
  if (has_ended && control.action() != Control::ABORT) forget_earlier_run();
  note(who, control.action() == Control::JUMP
                ? fmt::format("jump to step {}", clean(state.mission->steps[control.step()].label))
                : name_of(control.action()));
  switch (control.action()) {
    case Control::EXECUTE:
      documents_.sync_drafts(now());  // so that it stays known what was executed
      tell_not_kept();
      post(event::Execute{});
      break;
    case Control::PAUSE:
      post(event::Pause{});
      break;
    case Control::RESUME:
      if (is_running)
        post(event::Resume{});
      else
        post(event::Execute{});
      break;
    case Control::SINGLE_STEP:
      single_step();
      break;
    case Control::SKIP_STEP:
      skip_step();
      break;
    case Control::SINGLE_CYCLE:
      single_cycle();
      break;
    case Control::JUMP:
      post(event::Jump{control.step()});
      break;
    case Control::REWIND:
      post(event::Rewind{});
      break;
    case Control::ABORT:
      post(event::Abort{});
      break;
    default:
      return "this control is not known here";
  }
  return std::nullopt;
}

void Session::Parts::forget_earlier_run() {
  log_.begin_run();
  live_->trails().clear();
  changes_.trails = true;
}

// What runs is finished, and then nothing goes on by itself.
void Session::Parts::single_step() {
  const mission::State& state = live_->run().state();
  if (!state.in_step) {
    post(event::SingleStep{});
    return;
  }
  post(event::StopAfterStep{});
  if (state.paused) post(event::Resume{});
}

void Session::Parts::skip_step() {
  const mission::State& state = live_->run().state();
  if (!state.in_step)
    post(event::Jump{state.step + 1});
  else
    post(event::SingleStep{});
}

// One cycle, whatever the run was doing before; afterwards it is paused.
void Session::Parts::single_cycle() {
  const mission::State& state = live_->run().state();
  if (state.mode != mission::State::Mode::kRunning)
    post(event::Execute{});
  else if (state.paused)
    post(event::Resume{});
  step_once();
  if (state.mode == mission::State::Mode::kRunning && !state.paused) post(event::Pause{});
  ++version_;
}

void Session::Parts::release_stop(const std::string& who) {
  is_stopped_ = false;
  note(who, "release the emergency stop");
  changes_.status = true;
  if (!live_) return;
  const mission::State& state = live_->run().state();
  if (state.mode == mission::State::Mode::kRunning && !state.paused) post(event::Pause{});
  live_->run().set_emergency_stop(false);
}

Session::Parts::Answered Session::Parts::set_speed(const std::string& who, double speed) {
  const bool is_allowed = speed == 0.0 || (speed >= Pace::kSlowest && speed <= Pace::kFastest);
  if (!is_allowed) return "the speed is a number from 0.1 to 1000, or 0 for as fast as it goes";
  pace_.set_speed(speed, now(), sim_time());
  if (live_) live_->run().set_stands_still_for_operator(speed == 0.0);
  note(who, speed == 0.0 ? "speed max" : fmt::format("speed {}", speed));
  changes_.status = true;
  return std::nullopt;
}

Session::Parts::Answered Session::Parts::answer(const std::string& who, const Answer& answer) {
  if (!live_) return kNoRun;
  if (is_stopped_) return kStopped;
  const auto& questions = live_->run().state().questions;
  const auto open = std::ranges::find(questions, answer.question(), &mission::Question::id);
  if (open == questions.end()) return "this question is no longer open";
  const auto text = live_->question_texts().find(answer.question());
  log_.add(sim_time(), {Log::ANSWER,
                        fmt::format("{}: {} to `{}`", who, answer.proceed() ? "yes" : "no",
                                    text == live_->question_texts().end() ? "" : text->second),
                        0,
                        "",
                        {},
                        false});
  post(event::Answer{answer.question(), answer.proceed()});
  return std::nullopt;
}

Session::Parts::Answered Session::Parts::typed(const std::string& who, const Typed& typed, Reply& reply) {
  if (!live_) return is_loading_ ? kLoading : kNoRun;
  text::Diagnostics problems;
  const auto read = mdl::parse_immediate(typed.line(), *plain_, problems, documents_.load_options());
  for (const text::Diagnostic& problem : problems.items())
    *reply.add_diagnostics() = documents_.message(problem);
  if (!read) {
    return problems.items().empty() ? "this can't be understood" : clean(problems.items().front().message);
  }
  const mission::Mission& mission = read->edited ? *read->edited : *plain_;
  encode_targets(live_->run(), mission, read->commands, *reply.mutable_targets());
  if (typed.preview()) return std::nullopt;
  if (auto refused = why_not_now()) return refused;
  log_.add(sim_time(), {Log::OPERATOR, fmt::format("{} typed: {}", who, typed.line()), 0, "", {}, false});
  if (read->edited) {
    if (!change_mission(read->edited)) return kLoading;
    typed_edits_.push_back(typed.line());
  }
  if (!read->commands.empty()) post(event::Typed{read->commands});
  return std::nullopt;
}

Session::Parts::Answered Session::Parts::set_option(const std::string& who, const SetOption& option) {
  if (!live_) return is_loading_ ? kLoading : kNoRun;
  const std::string line = fmt::format("SET {} {}", option.option(), option.value());
  text::Diagnostics problems;
  const auto read = mdl::parse_immediate(line, *plain_, problems, documents_.load_options());
  if (!read && !problems.items().empty()) return clean(problems.items().front().message);
  const bool is_set = read && read->commands.size() == 1 &&
                      (std::holds_alternative<mission::SetBoolean>(read->commands[0]) ||
                       std::holds_alternative<mission::SetNumber>(read->commands[0]));
  if (!is_set) return fmt::format("`{}` is no option with a value", clean(line));
  if (read->edited) {
    if (!change_mission(read->edited)) return kLoading;
    typed_edits_.push_back(line);
  }
  post(event::Typed{read->commands});
  note(who, line);
  return std::nullopt;
}

}  // namespace mlab::console
