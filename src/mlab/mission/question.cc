#include "mlab/mission/question.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "mlab/mission/clock.h"
#include "mlab/mission/step.h"
#include "mlab/mission/wording.h"

namespace mlab::mission {
namespace {

// `Unit "scouts" is`, `Robots 2, 5 are`
std::string asking_text(const State& state, const Run& run) {
  if (run.unit != kNoUnit) return fmt::format("Unit \"{}\" is", unit_name(*state.mission, run.unit));
  return fmt::format("R{} {}", robots_name(run.command->robots).substr(1), is_one(run) ? "is" : "are");
}

void ask(Turn& turn, const Run& run, std::string text, std::optional<std::uint32_t> phase_line,
         std::optional<double> expires) {
  State& s = turn.state;
  const std::uint32_t id = ++s.last_question;
  s.questions.push_back({.id = id, .run = index_of(s, run), .phase_line = phase_line, .expires = expires});
  emit(turn, effect::Ask{id, std::move(text), expires, run.record});
}

void say_yes(Turn& turn, const Question& question) {
  if (question.robot.value != 0) {
    emit(turn, effect::LetProceed{question.robot});
    return;
  }
  Run& run = turn.state.runs[question.run];
  if (question.phase_line)
    run.lines[*question.phase_line].acknowledged = true;
  else
    complete(turn, run);
}

}  // namespace

void ask_to_proceed(Turn& turn, Run& run) {
  const State& s = turn.state;
  const std::optional<MissionTime>& until = run.command->until;
  std::optional<double> expires;
  if (until) expires = run_time_of(*until, s.options, s.time);
  if (expires && *expires <= s.time) {
    complete(turn, run);
    return;
  }
  const std::string_view doing = run.command->task == Task::kPatrol ? "patrolling" : "occupying";
  std::string text = fmt::format("{} {} {}. Proceed?", asking_text(s, run), doing, run.command->place_name);
  if (s.options.proceed_all) {
    message(turn, text + " yes");
    complete(turn, run);
    return;
  }
  run.phase = Run::Phase::kProceed;
  ask(turn, run, std::move(text), std::nullopt, expires);
}

void ask_to_acknowledge(Turn& turn, Run& run, std::uint32_t phase_line) {
  const State& s = turn.state;
  const PhaseLine& line = run.command->phase_lines[phase_line];
  std::string text =
      fmt::format("{} at phase line {}: {}. Acknowledge?", asking_text(s, run), line.name, line.acknowledge);
  if (s.options.proceed_all) {
    message(turn, text + " yes");
    run.lines[phase_line].acknowledged = true;
    return;
  }
  ask(turn, run, std::move(text), phase_line, std::nullopt);
}

void ask_for_robot(Turn& turn, base::RobotId robot) {
  State& s = turn.state;
  if (std::ranges::find(s.questions, robot, &Question::robot) != s.questions.end()) return;
  std::string text = fmt::format("Robot {} asks whether it may go on. Proceed?", robot.value);
  if (s.options.proceed_all) {
    message(turn, text + " yes");
    emit(turn, effect::LetProceed{robot});
    return;
  }
  const std::uint32_t id = ++s.last_question;
  s.questions.push_back({.id = id, .phase_line = {}, .expires = {}, .robot = robot});
  emit(turn, effect::Ask{id, std::move(text), {}, 0, robot});
}

void withdraw_of(Turn& turn, base::RobotId robot) {
  auto& questions = turn.state.questions;
  const auto at = std::ranges::find(questions, robot, &Question::robot);
  if (at != questions.end()) withdraw(turn, static_cast<std::size_t>(at - questions.begin()));
}

void withdraw_of(Turn& turn, const Run& run) {
  const State& s = turn.state;
  for (std::size_t i = s.questions.size(); i-- > 0;) {
    if (s.questions[i].robot.value == 0 && s.questions[i].run == index_of(s, run)) withdraw(turn, i);
  }
}

void answer(Turn& turn, std::uint32_t question, bool proceed) {
  auto& questions = turn.state.questions;
  const auto at = std::ranges::find(questions, question, &Question::id);
  if (at == questions.end()) return;
  const Question found = *at;
  questions.erase(at);
  if (proceed)
    say_yes(turn, found);
  else
    abort_mission(turn);
}

void expire_questions(Turn& turn) {
  State& s = turn.state;
  for (std::size_t i = 0; i < s.questions.size();) {
    const Question question = s.questions[i];
    if (!question.expires || *question.expires > s.time) {
      ++i;
      continue;
    }
    withdraw(turn, i);
    message(turn,
            fmt::format("{}: it is {}, proceeds by itself", s.commands[s.runs[question.run].record].text,
                        clock_text(s.time, s.options)),
            s.runs[question.run].owner);
    say_yes(turn, question);
  }
}

void withdraw(Turn& turn, std::size_t index) {
  auto& questions = turn.state.questions;
  emit(turn, effect::Withdraw{questions[index].id});
  questions.erase(questions.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace mlab::mission
