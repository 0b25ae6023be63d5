#include "mlab/history/history.h"

#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::history {
namespace {

bool are_numbers(const wire::HistoryExecutive& options) {
  return std::isfinite(options.patience()) && std::isfinite(options.epoch_seconds()) &&
         std::isfinite(options.zone_offset()) && std::isfinite(options.bound_length()) &&
         std::isfinite(options.spacing()) && std::isfinite(options.phase_line_ahead());
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
      if (beginning.format() != kFormat)
        return fmt::format("it is of format {}, and this program reads format {}", beginning.format(),
                           kFormat);
      if (!are_numbers(beginning.executive())) return "a setting is no number";
      if (beginning.environment() != 0 && !text(beginning.environment()))
        return fmt::format("text {} is missing", beginning.environment());
      if (auto problem = check(beginning.mission())) return problem;
      beginning_ = beginning;
      return std::nullopt;
    }
    case Entry::kInput: {
      const wire::HistoryInput& input = entry.input();
      if (input.has_exchanged()) {
        if (auto problem = check(input.exchanged().mission())) return problem;
      }
      if (!are_numbers(input)) return "what came in holds what is no number";
      inputs_.push_back({{entry.cycle(), input.has_looked()}, entry.time(), input});
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
    case Entry::kEnd:
      end_ = EndEntry{entry.cycle(), entry.end().outcome(), entry.end().has_looked(), entry.end().digest()};
      return std::nullopt;
    case Entry::BODY_NOT_SET:
      return std::nullopt;  // of a later version
  }
  return std::nullopt;
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
  if (!has_own) return fmt::format("the text of the mission `{}` is missing", text::shown(mission.path()));
  return std::nullopt;
}

std::string History::why_not_recomputed() const {
  if (!beginning_) return "the run had not begun";
  if (beginning_->is_in_real_time())
    return "its robots were elsewhere, in real time: what they did was not computed here";
  const auto of = [](const wire::HistoryMission& mission) {
    return mission.executables().empty()
               ? std::string()
               : fmt::format("the program `{}` is in an executable, which is not part of the recording",
                             text::shown(mission.executables(0)));
  };
  if (std::string why = of(beginning_->mission()); !why.empty()) return why;
  for (const InputEntry& one : inputs_) {
    if (std::string why = of(one.input.exchanged().mission()); !why.empty()) return why;
  }
  return "";
}

}  // namespace mlab::history
