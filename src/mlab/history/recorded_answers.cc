#include "mlab/history/recorded_answers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "mlab/robot/program/bounded_needs.h"
#include "mlab/robot/program/program_runner.h"
#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/percepts_wire.h"

namespace mlab::history {
namespace {

constexpr std::size_t kMostWords = 10'000;  // of what is told of a program [bytes]

bool are_numbers(const wire::HistoryHearing& hearing) {
  return std::isfinite(hearing.silence()) && hearing.silence() >= 0.0 &&
         std::isfinite(hearing.percept_age()) && hearing.percept_age() >= 0.0;
}

// Without a place.
std::string what_is_wrong_with(const wire::HistoryAnswer& answer) {
  percept::Action action;
  if (const auto problem = robot_wire::decode(answer.action(), action)) return *problem;
  if (!robot::is_number(action)) return "an action holds what is no number";
  if (!are_numbers(answer.hearing())) return "how long a robot was silent is no time";
  if (answer.fault().size() > kMostWords || answer.failure().size() > kMostWords)
    return fmt::format("what is told of a program is longer than {} bytes", kMostWords);
  return "";
}

}  // namespace

std::optional<std::string> what_is_wrong(const wire::HistoryEntry& entry, std::uint64_t before) {
  const wire::HistoryAnswers& answers = entry.answers();
  std::pair<std::uint64_t, std::uint32_t> last(before, std::numeric_limits<std::uint32_t>::max());
  for (const wire::HistoryAnswer& one : answers.answers()) {
    const std::pair here(entry.cycle() - std::min<std::uint64_t>(one.before(), entry.cycle()), one.robot());
    if (here <= last)
      return fmt::format("an answer of robot {} in cycle {} comes after one of cycle {}", here.second,
                         here.first, last.first);
    if (const std::string wrong = what_is_wrong_with(one); !wrong.empty())
      return fmt::format("what robot {} answered in cycle {}: {}", here.second, here.first, wrong);
    last = here;
  }
  for (const wire::HistoryNotStarted& one : answers.not_started()) {
    if (one.before() > entry.cycle()) return "a robot was not brought to life before the first cycle";
    if (one.failure().size() > kMostWords)
      return fmt::format("what is told of a program is longer than {} bytes", kMostWords);
  }
  for (const wire::HistoryFailed& one : answers.failed()) {
    if (one.before() >= entry.cycle()) return "a program failed before the first cycle";
    if (one.failure().empty()) return "a program failed, and nothing says how";
    if (one.failure().size() > kMostWords)
      return fmt::format("what is told of a program is longer than {} bytes", kMostWords);
  }
  return std::nullopt;
}

void RecordedAnswers::go_to(std::uint64_t cycle) {
  if (entry_ && cycle == cycle_) return;
  const std::vector<AnswersEntry>& all = history_->answers();
  const bool is_within = entry_ && cycle > cycle_ && cycle <= all[*entry_].cycle;
  if (!is_within) {
    const auto at = std::ranges::lower_bound(all, cycle, {}, &AnswersEntry::cycle);
    entry_.reset();
    known_.clear();
    if (at != all.end()) enter(static_cast<std::size_t>(at - all.begin()));
  }
  cycle_ = cycle;
  for (auto& [robot, known] : known_) {
    known.fault.clear();
    known.failure.clear();
  }
  if (!entry_) return;
  const AnswersEntry& entry = all[*entry_];
  for (; next_ < entry.answers.answers_size(); ++next_) {
    const wire::HistoryAnswer& answer = entry.answers.answers(next_);
    if (entry.cycle - answer.before() > cycle) return;
    take(answer);
    if (entry.cycle - answer.before() == cycle) continue;
    known_[answer.robot()].fault.clear();
    known_[answer.robot()].failure.clear();
  }
}

void RecordedAnswers::enter(std::size_t entry) {
  entry_ = entry;
  next_ = 0;
}

void RecordedAnswers::take(const wire::HistoryAnswer& answer) {
  RecordedAnswer& known = known_[answer.robot()];
  // It was looked at when it was added to the history.
  if (answer.has_action()) static_cast<void>(robot_wire::decode(answer.action(), known.action));
  if (answer.has_needs()) known.needs = robot::bounded(robot_wire::needs_of(answer.needs()));
  if (answer.has_hearing()) {
    known.silence = answer.hearing().silence();
    known.percept_age = answer.hearing().percept_age();
  }
  known.fault = answer.fault();
  known.failure = answer.failure();
}

const RecordedAnswer* RecordedAnswers::find(std::uint32_t robot) const {
  const auto at = known_.find(robot);
  return at != known_.end() ? &at->second : nullptr;
}

}  // namespace mlab::history
