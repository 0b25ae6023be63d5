#include "mlab/comparison/inputs.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::comparison {
namespace {

using history::History;
using history::InputEntry;

std::string words_of(const wire::HistoryPosted& posted) {
  using Posted = wire::HistoryPosted;
  switch (posted.kind()) {
    case Posted::EXECUTE:
      return "Execute";
    case Posted::PAUSE:
      return "Pause";
    case Posted::RESUME:
      return "Resume";
    case Posted::SINGLE_STEP:
      return "Single step";
    case Posted::STOP_AFTER_STEP:
      return "Stop after this step";
    case Posted::JUMP:
      return fmt::format("Jump to step {}", posted.number() + 1);
    case Posted::REWIND:
      return "Rewind";
    case Posted::ABORT:
      return "Abort";
    case Posted::ANSWER:
      return fmt::format("{} to question {}", posted.proceed() ? "yes" : "no", posted.number());
    case Posted::TYPED:
      return fmt::format("typed `{}`", text::shown(posted.line(), 120));
    case Posted::TELEOPERATE:
      return "an order to steer";
    case Posted::TELEOPERATION_COMPLETE:
      return "the end of steering";
    default:
      return "something that this program doesn't know";
  }
}

std::string words_of(const wire::HistoryIntervention& one) {
  using Kind = wire::HistoryIntervention;
  const std::string path = text::shown(one.path(), 80);
  switch (one.kind()) {
    case Kind::FORCE:
      return fmt::format("`{}` of robot {} is made to go to `{}`", path, one.robot(),
                         text::shown(one.value()));
    case Kind::HOLD:
      return fmt::format("`{}` of robot {} is held at {}", path, one.robot(), text::shown(one.value()));
    case Kind::RELEASE:
      return path.empty() ? fmt::format("all that is held of robot {} is released", one.robot())
                          : fmt::format("`{}` of robot {} is released", path, one.robot());
    case Kind::REPLACE:
      return fmt::format("another robot takes the place of robot {}", one.robot());
    default:
      return "something that this program doesn't know";
  }
}

// Texts have numbers of their own in each history.
std::set<std::pair<std::string, std::string>> texts_of(const History& history,
                                                       const wire::HistoryMission& version) {
  std::set<std::pair<std::string, std::string>> out;
  for (const std::uint32_t id : version.texts()) {
    if (const text::SourcePtr source = history.text(id)) out.emplace(source->name(), source->text());
  }
  return out;
}

bool is_same(const Both<const History*>& histories, const InputEntry& a, const InputEntry& b) {
  if (a.moment != b.moment) return false;
  if (!a.input.has_exchanged() || !b.input.has_exchanged())
    return a.input.SerializeAsString() == b.input.SerializeAsString();
  wire::HistoryExchanged one = a.input.exchanged();
  wire::HistoryExchanged other = b.input.exchanged();
  if (texts_of(*histories[0], one.mission()) != texts_of(*histories[1], other.mission())) return false;
  one.mutable_mission()->clear_texts();
  other.mutable_mission()->clear_texts();
  return one.SerializeAsString() == other.SerializeAsString();
}

}  // namespace

std::string words_of(const wire::HistoryInput& input) {
  switch (input.body_case()) {
    case wire::HistoryInput::kPosted:
      return words_of(input.posted());
    case wire::HistoryInput::kExchanged:
      return input.exchanged().takes_over() ? "robots take over another version of their programs"
                                            : "another version of the mission";
    case wire::HistoryInput::kEmergencyStop:
      return input.emergency_stop() ? "emergency stop" : "the emergency stop is released";
    case wire::HistoryInput::kStick:
      return input.stick().is_let_go()
                 ? fmt::format("the stick of robot {} is let go", input.stick().robot())
                 : fmt::format("the stick of robot {} at ({:g}, {:g})", input.stick().robot(),
                               input.stick().x(), input.stick().y());
    case wire::HistoryInput::kParameter:
      return fmt::format("parameter `{}` of robot {}: {}", text::shown(input.parameter().port(), 80),
                         input.parameter().robot(), text::shown(input.parameter().value()));
    case wire::HistoryInput::kIntervention:
      return words_of(input.intervention());
    case wire::HistoryInput::kStandsStill:
      return input.stands_still() ? "time stands still for the operator" : "time passes without the operator";
    case wire::HistoryInput::kHeard:
      return fmt::format("the vehicle `{}` says how it is", text::shown(input.heard().vehicle(), 64));
    case wire::HistoryInput::BODY_NOT_SET:
      break;
  }
  return "something that this program doesn't know";
}

std::optional<InputDifference> first_difference(const Both<const History*>& histories) {
  const std::vector<InputEntry>& a = histories[0]->inputs();
  const std::vector<InputEntry>& b = histories[1]->inputs();
  std::size_t i = 0;
  while (i < a.size() && i < b.size() && is_same(histories, a[i], b[i])) ++i;
  const InputEntry* const one = i < a.size() ? &a[i] : nullptr;
  const InputEntry* const other = i < b.size() ? &b[i] : nullptr;
  const std::uint64_t shorter = std::min(histories[0]->last_cycle(), histories[1]->last_cycle());
  const bool is_first = one != nullptr && (other == nullptr || one->moment <= other->moment);
  const bool is_second = other != nullptr && (one == nullptr || other->moment <= one->moment);
  if (!is_first && !is_second) return std::nullopt;
  const InputEntry& earlier = is_first ? *one : *other;
  if (earlier.moment.cycle > shorter) return std::nullopt;
  return InputDifference{earlier.moment.cycle,
                         earlier.time,
                         {is_first ? words_of(one->input) : "", is_second ? words_of(other->input) : ""}};
}

}  // namespace mlab::comparison
