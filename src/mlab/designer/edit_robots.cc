// Robots and societies.

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/editor.h"
#include "mlab/designer/values.h"
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

cdl::SocietyMember caste_of(std::vector<cdl::SocietyMember> members) {
  cdl::SocietyMember out;
  out.kind = cdl::SocietyMember::Kind::kCaste;
  out.members = std::move(members);
  return out;
}

cdl::SocietyMember member_of(const SetMember& change) {
  cdl::SocietyMember out;
  out.name.text = change.name();
  if (change.count() > 1 && !change.is_caste()) {
    out.kind = cdl::SocietyMember::Kind::kTeam;
    out.count = static_cast<int>(change.count());
  }
  if (change.is_caste()) out = caste_of({out});
  out.by.text = change.by();
  return out;
}

}  // namespace

Done Editor::set_class(const SetClass& change) {
  const cdl::Robot* robot = work_.model().robot(change.robot());
  if (robot == nullptr) return refusal(fmt::format("there is no robot `{}`", text::shown(change.robot())));
  const std::string& wanted = change.class_name();
  if (!wanted.empty() && !work_.model().configuration().classes.contains(wanted))
    return refusal(fmt::format("there is no class `{}`", text::shown(wanted)));
  if (wanted == robot->class_name.text) return true;
  work_.changes().change<cdl::Robot>(*robot, [wanted](cdl::Robot& now) { now.class_name.text = wanted; });
  // Devices of the class before are none of this one.
  const auto other = work_.model().configuration().classes.find(wanted);
  for (const cdl::Choice& choice : robot->choices) {
    const bool stays =
        other != work_.model().configuration().classes.end() &&
        std::ranges::any_of(other->second->devices, [&](const cdl::Device& device) {
          return device.name.text == choice.device.text && device.binds.text == choice.binding.text;
        });
    if (!stays) work_.changes().remove(choice);
  }
  return work_.commit();
}

Done Editor::use_device(const UseDevice& change) {
  const cdl::Robot* robot = work_.model().robot(change.robot());
  if (robot == nullptr) return refusal(fmt::format("there is no robot `{}`", text::shown(change.robot())));
  const auto known = std::ranges::find_if(
      robot->choices, [&](const cdl::Choice& choice) { return choice.binding.text == change.binding(); });
  if (change.device().empty()) {
    if (known != robot->choices.end()) work_.changes().remove(*known);
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
    work_.changes().rename(known->device, change.device());
  } else {
    const cdl::Choice choice{{change.device(), {}}, {change.binding(), {}}};
    work_.changes().change<cdl::Robot>(*robot, [choice](cdl::Robot& now) { now.choices.push_back(choice); });
  }
  return work_.commit();
}

Done Editor::set_coordinator(const cdl::SocietyMember& caste, const std::string& by) {
  if (by == caste.by.text) return true;
  if (!by.empty() && !work_.model().configuration().operators.contains(by))
    return refusal(fmt::format("there is no operator `{}`", text::shown(by)));
  work_.changes().change<cdl::SocietyMember>(caste, [by](cdl::SocietyMember& now) { now.by.text = by; });
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
  return put_member(*society, change);
}

Done Editor::put_member(const cdl::Society& society, const SetMember& change) {
  using Member = cdl::SocietyMember;
  const Member member = member_of(change);
  const auto depth = static_cast<std::size_t>(change.path_size());
  const Member* group = depth == 0 ? nullptr : member_at(society.what, change.path(), depth - 1);
  const Member* old = member_at(society.what, change.path(), depth);
  if (old == nullptr && group == nullptr) return refusal("the member has gone");
  if (old != nullptr) {
    work_.changes().change<Member>(*old, [member](Member& now) { now = member; });
  } else if (group->kind == Member::Kind::kCaste) {
    work_.changes().change<Member>(*group, [member](Member& now) { now.members.push_back(member); });
  } else {  // one member becomes two
    work_.changes().change<Member>(*group, [member](Member& now) { now = caste_of({now, member}); });
  }
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
  work_.changes().remove(*gone);
  return work_.commit();
}

}  // namespace mlab::designer
