// Robots and societies.

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/editor.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

constexpr std::uint32_t kMostRobots = 100'000;

const cdl::SocietyMember* member_at(const cdl::SocietyMember& top, const auto& path, std::size_t depth) {
  const cdl::SocietyMember* out = &top;
  for (std::size_t i = 0; i < depth; ++i) {
    const auto at = static_cast<std::size_t>(path[static_cast<int>(i)]);
    if (at >= out->members.size()) return nullptr;
    out = &out->members[at];
  }
  return out;
}

std::string member_words(const SetMember& change) {
  const std::string by = change.by().empty() ? "" : " by " + change.by();
  if (change.is_caste()) return fmt::format("caste {{\n{};\n}}{}", change.name(), by);
  if (change.count() > 1) return fmt::format("team of {} {}{}", change.count(), change.name(), by);
  return change.name() + by;
}

}  // namespace

Done Editor::set_class(const SetClass& change) {
  const cdl::Robot* robot = work_.model().robot(change.robot());
  if (robot == nullptr) return refusal(fmt::format("there is no robot `{}`", text::shown(change.robot())));
  const std::string& wanted = change.class_name();
  if (!wanted.empty() && !work_.model().configuration().classes.contains(wanted))
    return refusal(fmt::format("there is no class `{}`", text::shown(wanted)));
  if (wanted == robot->class_name.text) return true;
  const TokenMap& tokens = work_.tokens();
  const text::Span old = robot->class_name.place.span;
  if (!robot->class_name.text.empty() && wanted.empty()) {
    work_.erase({tokens.tokens()[tokens.at(old.begin) - 2].span.end, old.end});
  } else if (!robot->class_name.text.empty()) {
    work_.replace(old, wanted);
  } else {
    std::size_t behind = tokens.at(robot->name.place.span.end);
    if (tokens.word(behind) == "(") behind = tokens.closer(behind) + 1;
    work_.insert(tokens.tokens()[behind - 1].span.end, " is " + wanted);
  }
  // Devices of the class before are none of this one.
  const auto other = work_.model().configuration().classes.find(wanted);
  for (const cdl::Choice& choice : robot->choices) {
    const bool stays =
        other != work_.model().configuration().classes.end() &&
        std::ranges::any_of(other->second->devices, [&](const cdl::Device& device) {
          return device.name.text == choice.device.text && device.binds.text == choice.binding.text;
        });
    if (stays) continue;
    work_.erase_statement(tokens.tokens()[tokens.at(choice.device.place.span.begin) - 1].span.begin);
  }
  return work_.commit();
}

Done Editor::use_device(const UseDevice& change) {
  const cdl::Robot* robot = work_.model().robot(change.robot());
  if (robot == nullptr) return refusal(fmt::format("there is no robot `{}`", text::shown(change.robot())));
  const TokenMap& tokens = work_.tokens();
  const auto known = std::ranges::find_if(
      robot->choices, [&](const cdl::Choice& choice) { return choice.binding.text == change.binding(); });
  if (change.device().empty()) {
    if (known == robot->choices.end()) return true;
    work_.erase_statement(tokens.tokens()[tokens.at(known->device.place.span.begin) - 1].span.begin);
    return work_.commit();
  }
  const auto& classes = work_.model().configuration().classes;
  const auto found = classes.find(robot->class_name.text);
  if (found == classes.end()) return refusal("the robot has no class yet, so it has no devices");
  const auto& devices = found->second->devices;
  const bool fits = std::ranges::any_of(devices, [&](const cdl::Device& device) {
    return device.name.text == change.device() && device.binds.text == change.binding();
  });
  if (!fits)
    return refusal(fmt::format("`{}` has no device `{}` that serves `{}`", found->first,
                               text::shown(change.device()), text::shown(change.binding())));
  if (known != robot->choices.end()) {
    work_.replace(known->device.place.span, change.device());
    return work_.commit();
  }
  const std::string words = fmt::format("use {} for {};", change.device(), change.binding());
  if (!robot->choices.empty()) {
    work_.insert_statement_behind(tokens.statement_end(robot->choices.back().binding.place.span.end), words);
    return work_.commit();
  }
  if (!robot->lets.empty()) {
    work_.insert_statement_behind(tokens.statement_end(robot->lets.back().value->place.span.end), words);
    return work_.commit();
  }
  std::size_t open = tokens.at(robot->name.place.span.end);
  if (tokens.word(open) == "(") open = tokens.closer(open);
  while (open + 1 < tokens.tokens().size() && tokens.word(open) != "{") ++open;
  work_.insert_statement_behind(tokens.tokens()[open].span.end, words);
  return work_.commit();
}

Done Editor::set_coordinator(const cdl::SocietyMember& caste, const std::string& by) {
  if (by == caste.by.text) return true;
  if (!by.empty() && !work_.model().configuration().operators.contains(by))
    return refusal(fmt::format("there is no operator `{}`", text::shown(by)));
  const TokenMap& tokens = work_.tokens();
  std::size_t brace = tokens.at(caste.place.span.begin);
  while (brace + 1 < tokens.tokens().size() && tokens.word(brace) != "{") ++brace;
  const std::uint32_t end = tokens.tokens()[tokens.closer(brace)].span.end;
  if (caste.by.text.empty()) {
    work_.insert(end, " by " + by);
  } else if (by.empty()) {
    work_.erase({end, caste.by.place.span.end});
  } else {
    work_.replace(caste.by.place.span, by);
  }
  return work_.commit();
}

Done Editor::set_member(const SetMember& change) {
  const cdl::Society* society = work_.model().society(change.society());
  if (society == nullptr)
    return refusal(fmt::format("there is no society `{}`", text::shown(change.society())));
  const auto& configuration = work_.model().configuration();
  const cdl::SocietyMember* there =
      member_at(society->what, change.path(), static_cast<std::size_t>(change.path_size()));
  // A caste is called by nobody: what changes of one that is there is who coordinates it.
  if (change.is_caste() && there != nullptr && there->kind == cdl::SocietyMember::Kind::kCaste)
    return set_coordinator(*there, change.by());
  const bool is_known =
      configuration.robots.contains(change.name()) ||
      (configuration.societies.contains(change.name()) && change.name() != change.society());
  if (!is_known)
    return refusal(fmt::format("`{}` is neither a robot nor another society", text::shown(change.name())));
  if (!change.by().empty() && !configuration.operators.contains(change.by()))
    return refusal(fmt::format("there is no operator `{}`", text::shown(change.by())));
  if (change.count() > kMostRobots)
    return refusal(fmt::format("a team has no more than {} robots", kMostRobots));
  const TokenMap& tokens = work_.tokens();
  const auto depth = static_cast<std::size_t>(change.path_size());
  if (depth == 0) {
    work_.replace(society->what.place.span, member_words(change));
    return work_.commit();
  }
  const cdl::SocietyMember* group = member_at(society->what, change.path(), depth - 1);
  if (group == nullptr) return refusal("the member has gone");
  const auto at = static_cast<std::size_t>(change.path(static_cast<int>(depth) - 1));
  if (at < group->members.size()) {
    work_.replace(group->members[at].place.span, member_words(change));
    return work_.commit();
  }
  if (group->kind == cdl::SocietyMember::Kind::kCaste && !group->members.empty()) {
    work_.insert_statement_behind(tokens.statement_end(group->members.back().place.span.end),
                                  member_words(change) + ";");
    return work_.commit();
  }
  if (group->kind == cdl::SocietyMember::Kind::kCaste) {
    std::size_t open = tokens.at(group->place.span.begin);
    while (open + 1 < tokens.tokens().size() && tokens.word(open) != "{") ++open;
    work_.insert_statement_behind(tokens.tokens()[open].span.end, member_words(change) + ";");
    return work_.commit();
  }
  // One member becomes two.
  work_.replace(
      group->place.span,
      Fragment("caste {\n").add(work_.moved(group->place.span)).add(";\n" + member_words(change) + ";\n}"));
  return work_.commit();
}

Done Editor::remove_member(const RemoveMember& change) {
  const cdl::Society* society = work_.model().society(change.society());
  if (society == nullptr)
    return refusal(fmt::format("there is no society `{}`", text::shown(change.society())));
  const auto depth = static_cast<std::size_t>(change.path_size());
  if (depth == 0) return refusal("a society has one member at least: remove the society itself");
  const cdl::SocietyMember* group = member_at(society->what, change.path(), depth - 1);
  const cdl::SocietyMember* gone = member_at(society->what, change.path(), depth);
  if (group == nullptr || gone == nullptr) return refusal("the member has gone");
  if (group->members.size() < 2) return refusal("a caste has one member at least: remove the caste itself");
  work_.erase_statement(gone->place.span.begin);
  return work_.commit();
}

}  // namespace mlab::designer
