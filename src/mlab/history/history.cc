#include "mlab/history/history.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "mlab/history/recorded_answers.h"
#include "mlab/text/shown.h"

namespace mlab::history {
namespace {

// Something that a clock can show: up to the year 9999, and as long before 1970.
bool is_of_clock(double seconds) {
  return std::abs(seconds) <= 253'402'300'799.0;
}

bool are_numbers(const wire::HistoryExecutive& options) {
  return std::isfinite(options.patience()) && std::isfinite(options.bound_length()) &&
         std::isfinite(options.spacing()) && std::isfinite(options.phase_line_ahead());
}

bool are_of_clocks(const wire::HistoryBeginning& beginning) {
  return is_of_clock(beginning.started_at()) && is_of_clock(beginning.executive().epoch_seconds()) &&
         std::abs(beginning.executive().zone_offset()) <= 86'400.0;
}

bool are_numbers(const wire::HistoryInput& input) {
  if (input.has_stick())
    return std::isfinite(input.stick().x()) && std::isfinite(input.stick().y()) &&
           std::isfinite(input.stick().magnitude());
  return !input.has_posted() || (std::isfinite(input.posted().x()) && std::isfinite(input.posted().y()));
}

}  // namespace

text::SourcePtr History::text(std::uint32_t id) const {
  const auto found = texts_.find(id);
  return found == texts_.end() ? nullptr : found->second;
}

std::optional<std::string> History::add(const wire::HistoryEntry& entry) {
  if (end_) return "something comes after the end of the run";
  if (!std::isfinite(entry.time()) || entry.time() < last_time_ || entry.cycle() < last_cycle_)
    return fmt::format("cycle {} comes after cycle {}", entry.cycle(), last_cycle_);
  if (!beginning_ && !entry.has_text() && !entry.has_beginning())
    return "something happens before the run has begun";
  if (auto problem = add_body(entry)) return problem;
  last_cycle_ = entry.cycle();
  last_time_ = entry.time();
  return std::nullopt;
}

std::optional<std::string> History::add_body(const wire::HistoryEntry& entry) {
  using Entry = wire::HistoryEntry;
  switch (entry.body_case()) {
    case Entry::kText:
      return add_text(entry.text());
    case Entry::kBeginning: {
      const wire::HistoryBeginning& beginning = entry.beginning();
      if (beginning_) return "the run begins twice";
      // What another version means by it is not known here, so nothing is made of it again: what was told and
      // where robots were can be shown all the same.
      if (beginning.format() == kFormat) {
        if (!are_numbers(beginning.executive())) return "a setting is no number";
        if (!are_of_clocks(beginning)) return "it begins at a time that no clock shows";
        if (beginning.environment() != 0 && !text(beginning.environment()))
          return fmt::format("text {} is missing", beginning.environment());
        if (auto problem = check(beginning.mission())) return problem;
      }
      beginning_ = beginning;
      needs_answers_ = beginning.is_in_real_time() && beginning.holds_answers();
      note_need_of_answers(beginning.mission(), entry);
      return std::nullopt;
    }
    case Entry::kInput: {
      const wire::HistoryInput& input = entry.input();
      if (input.has_exchanged() && beginning_->format() == kFormat) {
        if (auto problem = check(input.exchanged().mission())) return problem;
      }
      if (!are_numbers(input)) return "what came in holds what is no number";
      inputs_.push_back({{entry.cycle(), input.has_looked()}, entry.time(), input});
      note_need_of_answers(input.exchanged().mission(), entry);
      return std::nullopt;
    }
    case Entry::kMark:
      marks_.push_back({entry.cycle(), entry.mark().digest()});
      return std::nullopt;
    case Entry::kPoses: {
      const wire::HistoryPoses& poses = entry.poses();
      if (poses.x_size() != poses.robots_size() || poses.y_size() != poses.robots_size() ||
          poses.heading_size() != poses.robots_size())
        return "poses and robots are not equally many";
      poses_.push_back({entry.cycle(), entry.time(), poses});
      return std::nullopt;
    }
    case Entry::kEvent:
      events_.push_back({entry.cycle(), entry.time(), entry.event().text(), entry.event().is_warning()});
      return std::nullopt;
    case Entry::kAnswers:
      return add_answers(entry);
    case Entry::kEnd:
      end_ = EndEntry{entry.cycle(), entry.end().outcome(), entry.end().has_looked(), entry.end().digest()};
      return std::nullopt;
    case Entry::BODY_NOT_SET:
      return std::nullopt;  // of a later version
  }
  return std::nullopt;
}

void History::reach(std::uint64_t cycle, double time) {
  last_cycle_ = std::max(last_cycle_, cycle);
  last_time_ = std::max(last_time_, time);
}

std::optional<std::string> History::add_text(const wire::HistoryText& text) {
  if (text.id() == 0 || texts_.contains(text.id())) return fmt::format("text {} comes twice", text.id());
  if (text.content().size() > text::Source::kMaxBytes || text.content().size() > kMostText - text_bytes_)
    return fmt::format("its texts have more than {} bytes", kMostText);
  text_bytes_ += text.content().size();
  texts_[text.id()] = std::make_shared<const text::Source>(text.path(), text.content());
  return std::nullopt;
}

std::optional<std::string> History::check(const wire::HistoryMission& mission) const {
  bool has_own = false;
  for (const std::uint32_t id : mission.texts()) {
    const text::SourcePtr source = text(id);
    if (!source) return fmt::format("text {} is missing", id);
    has_own = has_own || source->name() == mission.path();
  }
  for (const wire::HistoryExecutable& program : mission.programs()) {
    const auto is_number = [](const wire::HistoryNumber& one) { return std::isfinite(one.value()); };
    if (!std::ranges::all_of(program.numbers(), is_number) || !std::ranges::all_of(program.body(), is_number))
      return fmt::format("a value of the program `{}` is no number", text::shown(program.name()));
  }
  if (!has_own) return fmt::format("the text of the mission `{}` is missing", text::shown(mission.path()));
  return std::nullopt;
}

const wire::HistoryMission& History::version_at(std::uint64_t cycle) const {
  const wire::HistoryMission* out = &beginning_->mission();
  for (const InputEntry& one : inputs_) {
    if (one.moment.cycle >= cycle) break;
    if (one.input.has_exchanged()) out = &one.input.exchanged().mission();
  }
  return *out;
}

std::string History::why_not_recomputed() const {
  if (!beginning_) return "the run had not begun";
  if (beginning_->format() != kFormat)
    return fmt::format("it is of format {}, and this program computes format {} again", beginning_->format(),
                       kFormat);
  if (beginning_->holds_answers()) return "";
  if (beginning_->is_in_real_time())
    return "its robots were elsewhere, in real time, and what they answered is not in the recording: a "
           "version of "
           "missionlab made it that did not record that";
  if (const std::string name = executable(); !name.empty())
    return fmt::format(
        "the program `{}` is in an executable, and what it answered is not in the recording: a version of "
        "missionlab made it that did not record that",
        text::shown(name));
  return "";
}

std::string History::why_not_gone_on() const {
  if (std::string why = why_not_recomputed(); !why.empty()) return why;
  return why_not_gone_on(beginning_->is_in_real_time(), executable());
}

std::string History::why_not_gone_on(bool is_in_real_time, const std::string& executable) {
  if (is_in_real_time)
    return "its robots were elsewhere, in real time: what they would do next is not known here";
  if (executable.empty()) return "";
  return fmt::format(
      "the program `{}` is in an executable, which keeps what it had in mind to itself: only what it "
      "answered is known",
      text::shown(executable));
}

// The first program that is in one; empty: none is.
std::string History::executable() const {
  const auto of = [](const wire::HistoryMission& mission) {
    return mission.executables().empty() ? std::string() : mission.executables(0);
  };
  if (std::string name = of(beginning_->mission()); !name.empty()) return name;
  for (const InputEntry& one : inputs_) {
    if (std::string name = of(one.input.exchanged().mission()); !name.empty()) return name;
  }
  return "";
}

void History::note_need_of_answers(const wire::HistoryMission& mission, const wire::HistoryEntry& entry) {
  if (needs_answers_ || mission.programs().empty() || !beginning_->holds_answers()) return;
  needs_answers_ = true;
  answered_ = entry.cycle();
  answered_time_ = entry.time();
}

std::optional<std::string> History::add_answers(const wire::HistoryEntry& entry) {
  if (auto problem = what_is_wrong(entry, answers_.empty() ? 0 : answers_.back().cycle)) return problem;
  for (const wire::HistoryNotStarted& one : entry.answers().not_started()) {
    const Failure key{entry.cycle() - one.before(), one.robot(), one.start()};
    if (one.failure().empty())
      not_started_.erase(key);
    else
      not_started_[key] = one.failure();
  }
  for (const wire::HistoryFailed& one : entry.answers().failed())
    failed_[{entry.cycle() - one.before(), one.robot(), 0}] = one.failure();
  answers_.push_back({entry.cycle(), entry.answers()});
  answered_ = entry.cycle();
  answered_time_ = entry.time();
  return std::nullopt;
}

const std::string* History::why_not_started(std::uint64_t cycle, std::uint32_t robot,
                                            std::uint32_t start) const {
  auto at = not_started_.find({cycle, robot, start});
  if (at == not_started_.end()) at = not_started_.find({cycle, robot, 0});
  return at != not_started_.end() ? &at->second : nullptr;
}

const std::string* History::why_failed(std::uint64_t cycle, std::uint32_t robot) const {
  const auto at = failed_.find({cycle, robot, 0});
  return at != failed_.end() ? &at->second : nullptr;
}

}  // namespace mlab::history
