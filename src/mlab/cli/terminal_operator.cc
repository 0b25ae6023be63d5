#include "mlab/cli/terminal_operator.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "mlab/cli/clock.h"
#include "mlab/text/shown.h"

namespace mlab::cli {

Answers::Kind Answers::poll_line(int wait_ms, std::string& line) {
  if (const std::size_t end = pending_.find('\n'); end != std::string::npos) {
    line = pending_.substr(0, end);
    pending_.erase(0, end + 1);
    return Kind::kLine;
  }
  if (is_over_) return Kind::kEnd;
  pollfd fd{STDIN_FILENO, POLLIN, 0};
  if (::poll(&fd, 1, wait_ms) <= 0) return Kind::kNone;
  char block[512];
  const ssize_t n = ::read(STDIN_FILENO, block, sizeof block);
  if (n > 0) {
    pending_.append(block, static_cast<std::size_t>(n));
  } else {
    is_over_ = true;
    if (!pending_.empty()) pending_ += '\n';
  }
  return poll_line(0, line);
}

TerminalOperator::TerminalOperator(run::MissionRun& run, RunScreen& screen)
    : run_(run), screen_(screen), is_person_(isatty(STDIN_FILENO) == 1) {}

void TerminalOperator::see(const mission::Effect& effect) {
  if (const auto* ask = std::get_if<mission::effect::Ask>(&effect)) {
    Question question{text::shown(ask->text, 200) + " [y/n] ", ask->expires.has_value(), run_.time(),
                      steady_seconds()};
    if (is_person_ && ask->expires)
      question.text += fmt::format("(yes by itself after {:.0f} s) ", *ask->expires - run_.time());
    asked_[ask->question] = std::move(question);
  }
  if (const auto* gone = std::get_if<mission::effect::Withdraw>(&effect)) withdraw(gone->question);
  const auto* told = std::get_if<mission::effect::Tell>(&effect);
  if (told != nullptr && told->kind == mission::effect::Tell::Kind::kCommandEnded)
    teleoperated_.erase(told->command);
  if (const auto* open = std::get_if<mission::effect::OpenTeleoperation>(&effect)) {
    teleoperated_.insert(open->command);
    screen_.line(fmt::format("  {}: there is no stick here, press Enter to end it",
                             text::shown(run_.state().commands[open->command].text)));
  }
}

bool TerminalOperator::is_steering() const {
  return std::ranges::any_of(run_.state().runs, [&](const mission::Run& run) {
    return teleoperated_.contains(run.record) && !run.ends;
  });
}

void TerminalOperator::withdraw(std::uint32_t question) {
  const bool is_shown = !asked_.empty() && asked_.begin()->first == question;
  asked_.erase(question);
  if (is_shown) screen_.end_prompt(false);
}

double TerminalOperator::ahead() const {
  if (!is_person_ || is_over_) return 0.0;
  double out = 0.0;
  for (const auto& [id, question] : asked_) {
    if (!question.expires) continue;
    const double passed = steady_seconds() - question.asked_when;
    out = std::max(out, run_.time() - question.asked_at - passed);
  }
  return out;
}

bool TerminalOperator::attend(int wait_ms) {
  if (!asked_.empty()) screen_.show_prompt(asked_.begin()->second.text);
  std::string line;
  const Answers::Kind kind = answers_.poll_line(wait_ms, line);
  if (kind == Answers::Kind::kEnd) {
    is_over_ = true;
    screen_.end_prompt(false);
    return false;
  }
  if (kind == Answers::Kind::kLine) {
    if (!is_person_) fmt::print("{}\n", text::shown(line));
    screen_.end_prompt(true);
    take(line);
  }
  return true;
}

void TerminalOperator::take(std::string line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
  if (asked_.empty()) {
    if (!teleoperated_.empty()) run_.post(mission::event::TeleoperationComplete{*teleoperated_.begin()});
    return;
  }
  const bool yes = line == "y" || line == "Y" || line == "yes" || line == "proceed" || line == "PROCEED";
  const bool no = line == "n" || line == "N" || line == "no" || line == "abort" || line == "ABORT";
  if (!yes && !no) {
    screen_.line("  y lets the unit proceed, n aborts the mission");
    return;
  }
  const std::uint32_t question = asked_.begin()->first;
  asked_.erase(asked_.begin());
  run_.post(mission::event::Answer{question, yes});
}

}  // namespace mlab::cli
