#include "mlab/designer/edit/change/societies.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

using Member = cdl::SocietyMember;

// Null: there is none.
template <class AnyMember>
AnyMember* member_at(AnyMember& top, const auto& path, std::size_t depth) {
  AnyMember* out = &top;
  for (std::size_t i = 0; i < depth; ++i) {
    const auto at = static_cast<std::size_t>(path[static_cast<int>(i)]);
    if (at >= out->members.size()) return nullptr;
    out = &out->members[at];
  }
  return out;
}

std::size_t depth_of(const auto& path) {
  return static_cast<std::size_t>(path.size());
}

Member caste_of(std::vector<Member> members) {
  Member out;
  out.kind = Member::Kind::kCaste;
  out.members = std::move(members);
  return out;
}

Member member_of(const SetMember& change) {
  Member out;
  out.name.text = change.name();
  if (change.count() > 1) {
    out.kind = Member::Kind::kTeam;
    out.count = static_cast<int>(change.count());
  }
  if (change.is_caste()) {
    out.count = 1;
    out = caste_of(change.name().empty() ? std::vector<Member>() : std::vector{out});
  }
  out.by.text = change.by();
  return out;
}

bool is_in(const cdl::Configuration& configuration, const Member& member, std::string_view society,
           std::set<std::string>& seen) {
  if (member.name.text == society) return true;
  for (const Member& one : member.members) {
    if (is_in(configuration, one, society, seen)) return true;
  }
  const auto found = configuration.societies.find(member.name.text);
  return found != configuration.societies.end() && seen.insert(member.name.text).second &&
         is_in(configuration, found->second->what, society, seen);
}

// A robot or society, none of which the society itself is a part.
std::string why_no_member(const cdl::Configuration& configuration, const std::string& name,
                          const std::string& society) {
  if (configuration.robots.contains(name)) return "";
  const auto other = configuration.societies.find(name);
  if (other == configuration.societies.end())
    return fmt::format("`{}` is neither a robot nor another society", text::shown(name));
  std::set<std::string> seen;
  if (name != society && !is_in(configuration, other->second->what, society, seen)) return "";
  return fmt::format("`{}` would be a part of itself", society);
}

// What `move_member` has marked as moved.
bool is_marked(const Member& member) {
  return member.count < 0;
}

void remove_marked(Member& group) {
  std::erase_if(group.members, is_marked);
  for (Member& member : group.members) remove_marked(member);
}

// Whether the one path leads to the other, or into it.
bool leads_into(const auto& path, const auto& into) {
  return path.size() <= into.size() && std::equal(path.begin(), path.end(), into.begin());
}

text::Result<const cdl::Society*> find_society(const Workspace& work, const std::string& name) {
  const cdl::Society* society = work.model().society(name);
  if (society == nullptr) return refusal(fmt::format("there is no society `{}`", text::shown(name)));
  return society;
}

Done set_coordinator(Workspace& work, const cdl::SocietyMember& member, const std::string& by) {
  if (by == member.by.text) return true;
  if (!by.empty() && !work.model().configuration().operators.contains(by))
    return refusal(fmt::format("there is no operator `{}`", text::shown(by)));
  work.changes().change<Member>(member, [by](Member& now) { now.by.text = by; });
  return work.commit();
}

Done put_member(Workspace& work, const cdl::Society& society, const SetMember& change) {
  const Member member = member_of(change);
  const std::size_t depth = depth_of(change.path());
  const Member* group = depth == 0 ? nullptr : member_at(society.what, change.path(), depth - 1);
  const Member* old = member_at(society.what, change.path(), depth);
  if (old == nullptr && group == nullptr) return refusal("the member has gone");
  if (old != nullptr) {
    work.changes().change<Member>(*old, [member](Member& now) { now = member; });
  } else if (group->kind == Member::Kind::kCaste) {
    work.changes().change<Member>(*group, [member](Member& now) { now.members.push_back(member); });
  } else {  // one member becomes two
    work.changes().change<Member>(*group, [member](Member& now) { now = caste_of({now, member}); });
  }
  return work.commit();
}

}  // namespace

Done set_member(Workspace& work, const SetMember& change) {
  const text::Result<const cdl::Society*> found = find_society(work, change.society());
  if (!found) return std::unexpected(found.error());
  const auto& configuration = work.model().configuration();
  const Member* there = member_at((*found)->what, change.path(), depth_of(change.path()));
  // A caste is called by nobody: what changes of one that is there is who coordinates it.
  if (change.is_caste() && there != nullptr && there->kind == Member::Kind::kCaste)
    return set_coordinator(work, *there, change.by());
  if (!change.is_caste() || !change.name().empty()) {
    const std::string reason = why_no_member(configuration, change.name(), change.society());
    if (!reason.empty()) return refusal(reason);
  }
  if (!change.by().empty() && !configuration.operators.contains(change.by()))
    return refusal(fmt::format("there is no operator `{}`", text::shown(change.by())));
  if (change.count() > static_cast<std::uint32_t>(cdl::kMostRobotsOfASociety))
    return refusal(fmt::format("a team has no more than {} robots", cdl::kMostRobotsOfASociety));
  return put_member(work, **found, change);
}

// A caste of which nothing is left goes as well; the society itself stays, without members.
Done remove_member(Workspace& work, const RemoveMember& change) {
  const text::Result<const cdl::Society*> found = find_society(work, change.society());
  if (!found) return std::unexpected(found.error());
  const Member& top = (*found)->what;
  std::size_t depth = depth_of(change.path());
  if (member_at(top, change.path(), depth) == nullptr) return refusal("the member has gone");
  while (depth > 1 && member_at(top, change.path(), depth - 1)->members.size() == 1) --depth;
  if (depth == 0) {
    if (top.kind == Member::Kind::kCaste && top.members.empty())
      return refusal("the society has no members: remove the society itself");
    work.changes().change<Member>(top, [](Member& now) { now = caste_of({}); });
  } else {
    work.changes().remove(*member_at(top, change.path(), depth));
  }
  return work.commit();
}

Done group_members(Workspace& work, const GroupMembers& change) {
  const text::Result<const cdl::Society*> found = find_society(work, change.society());
  if (!found) return std::unexpected(found.error());
  const Member* caste = member_at((*found)->what, change.path(), depth_of(change.path()));
  if (caste == nullptr || caste->kind != Member::Kind::kCaste)
    return refusal("only members of one caste can be grouped");
  const std::set<std::uint32_t> chosen(change.members().begin(), change.members().end());
  if (chosen.empty()) return refusal("nothing is chosen");
  if (*chosen.rbegin() >= caste->members.size()) return refusal("the member has gone");
  work.changes().change<Member>(*caste, [chosen](Member& now) {
    std::vector<Member> inner;
    std::vector<Member> outer;
    for (std::uint32_t i = 0; i < now.members.size(); ++i)
      (chosen.contains(i) ? inner : outer).push_back(now.members[i]);
    const auto first = static_cast<std::ptrdiff_t>(*chosen.begin());
    outer.insert(outer.begin() + first, caste_of(std::move(inner)));
    now.members = std::move(outer);
  });
  return work.commit();
}

// Its operator coordinates what has none of its own.
Done ungroup_members(Workspace& work, const UngroupMembers& change) {
  const text::Result<const cdl::Society*> found = find_society(work, change.society());
  if (!found) return std::unexpected(found.error());
  const Member& top = (*found)->what;
  const std::size_t depth = depth_of(change.path());
  const Member* caste = member_at(top, change.path(), depth);
  if (caste == nullptr || caste->kind != Member::Kind::kCaste)
    return refusal("only a caste can be taken apart");
  if (depth == 0 && caste->members.size() != 1)
    return refusal("a society of several members is a caste: take one of its members apart");
  std::vector<Member> members = caste->members;
  for (Member& member : members) {
    if (caste->by.text.empty()) break;
    if (!member.by.text.empty())
      return refusal(
          fmt::format("`{}` coordinates the caste, and `{}` a part of it: only one of them could stay",
                      caste->by.text, member.by.text));
    member.by.text = caste->by.text;
  }
  if (depth == 0) {
    work.changes().change<Member>(top, [members](Member& now) { now = members.front(); });
    return work.commit();
  }
  const Member* group = member_at(top, change.path(), depth - 1);
  const auto at = static_cast<std::ptrdiff_t>(change.path(static_cast<int>(depth) - 1));
  work.changes().change<Member>(*group, [members, at](Member& now) {
    const auto gone = now.members.erase(now.members.begin() + at);
    now.members.insert(gone, members.begin(), members.end());
  });
  return work.commit();
}

Done move_member(Workspace& work, const MoveMember& change) {
  const text::Result<const cdl::Society*> found = find_society(work, change.society());
  if (!found) return std::unexpected(found.error());
  if (change.path().empty()) return refusal("a society stands in nothing");
  if (leads_into(change.path(), change.into())) return refusal("a caste can't be a part of itself");
  Member top = (*found)->what;
  const std::size_t depth = depth_of(change.path());
  Member* from = member_at(top, change.path(), depth - 1);
  Member* into = member_at(top, change.into(), depth_of(change.into()));
  const std::size_t at = change.path(static_cast<int>(depth) - 1);
  if (from == nullptr || at >= from->members.size()) return refusal("the member has gone");
  if (into == nullptr || into->kind != Member::Kind::kCaste) return refusal("only a caste has members");
  const Member moved = from->members[at];
  const std::size_t place = std::min<std::size_t>(change.index(), into->members.size());
  if (from != into && from->members.size() == 1 && depth > 1)
    return refusal("a caste has one member at least: take the caste itself apart");
  if (from == into && (place == at || place == at + 1)) return true;
  // What is put in may move what `from` points to: a mark stands where it was.
  from->members[at].count = -1;
  into->members.insert(into->members.begin() + static_cast<std::ptrdiff_t>(place), moved);
  remove_marked(top);
  work.changes().change<cdl::Society>(**found, [top](cdl::Society& now) { now.what = top; });
  return work.commit();
}

}  // namespace mlab::designer
