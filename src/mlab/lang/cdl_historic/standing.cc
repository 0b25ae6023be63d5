#include "mlab/lang/cdl_historic/standing.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace mlab::cdl_historic {
namespace {

using cdl::Expression;
using cdl::ExpressionPtr;

constexpr int kMaxDepth = 200;

/// What becomes of a robot that is driven so.
struct Motion {
  bool moves = false;
  std::set<std::string> missing;
  std::vector<std::string> states;  // in which it stands while it moves in others
};

class Observer {
 public:
  explicit Observer(const cdl::Tree& tree) {
    for (const cdl::Item& item : tree.items) {
      if (const auto* one = std::get_if<cdl::Assemblage>(&item)) assemblages_[one->name.text] = one;
    }
  }

  std::optional<Standing> see(const cdl::Robot& robot) {
    Lets lets;
    for (const cdl::Let& let : robot.lets) lets[let.name.text] = let.value.get();
    std::vector<Motion> all;
    for (const cdl::Drive& drive : robot.drives) {
      if (drive.value) all.push_back(motion(*drive.value, lets, 0));
    }
    Motion whole = together(std::move(all));
    if (whole.missing.empty()) return std::nullopt;
    if (!whole.moves) return Standing{robot.name.text, {}, std::move(whole.missing)};
    if (whole.states.empty()) return std::nullopt;
    return Standing{robot.name.text, std::move(whole.states), std::move(whole.missing)};
  }

 private:
  using Lets = std::map<std::string, const Expression*>;

  // Members of which one that moves is enough.
  static Motion together(std::vector<Motion> members) {
    Motion out;
    for (Motion& one : members) {
      out.moves |= one.moves;
      // What stands beside something that moves is not missed.
      if (one.moves && one.states.empty()) continue;
      out.missing.merge(one.missing);
      out.states.insert(out.states.end(), one.states.begin(), one.states.end());
    }
    const bool has_whole_mover =
        std::ranges::any_of(members, [](const Motion& m) { return m.moves && m.states.empty(); });
    if (has_whole_mover) out.states.clear();
    return out;
  }

  Motion motion(const Expression& expression, const Lets& lets, int depth) {
    if (depth > kMaxDepth) return {true, {}, {}};
    if (const auto* name = std::get_if<cdl::Name>(&expression.what)) {
      const auto let = lets.find(name->name.text);
      return let == lets.end() ? Motion{true, {}, {}} : motion(*let->second, lets, depth + 1);
    }
    if (const auto* call = std::get_if<cdl::Call>(&expression.what)) return motion(*call, depth);
    if (const auto* one = std::get_if<cdl::Cooperate>(&expression.what))
      return motion(one->members, lets, depth);
    if (const auto* one = std::get_if<cdl::Compete>(&expression.what))
      return motion(one->members, lets, depth);
    if (const auto* one = std::get_if<cdl::Coordinate>(&expression.what))
      return motion(one->members, lets, depth);
    if (const auto* one = std::get_if<cdl::Sequence>(&expression.what)) return motion(*one, lets, depth);
    if (const auto* one = std::get_if<cdl::Select>(&expression.what)) {
      std::vector<Motion> cases;
      for (const cdl::Case& each : one->cases) cases.push_back(part(each.member, lets, depth));
      return together(std::move(cases));
    }
    return {true, {}, {}};
  }

  Motion part(const ExpressionPtr& expression, const Lets& lets, int depth) {
    return expression ? motion(*expression, lets, depth + 1) : Motion{};
  }

  Motion motion(const std::vector<cdl::Member>& members, const Lets& lets, int depth) {
    std::vector<Motion> all;
    for (const cdl::Member& member : members) all.push_back(part(member.value, lets, depth));
    return together(std::move(all));
  }

  Motion motion(const cdl::Sequence& sequence, const Lets& lets, int depth) {
    Motion out;
    for (const cdl::State& state : sequence.states) {
      Motion inside = part(state.member, lets, depth);
      out.moves |= inside.moves;
      for (const std::string& name : inside.states) out.states.push_back(state.name.text + "." + name);
      if (!inside.moves && !inside.missing.empty()) out.states.push_back(state.name.text);
      out.missing.merge(inside.missing);
    }
    return out;
  }

  Motion motion(const cdl::Call& call, int depth) {
    const auto found = assemblages_.find(call.callee.text);
    if (found == assemblages_.end()) return {call.callee.text != "Stand", {}, {}};
    const cdl::Assemblage& assemblage = *found->second;
    if (!assemblage.body) return {false, {assemblage.name.text}, {}};
    const auto [known, is_new] = known_.try_emplace(&assemblage, Motion{true, {}, {}});
    if (!is_new) return known->second;
    Lets lets;
    for (const cdl::Let& let : assemblage.lets) lets[let.name.text] = let.value.get();
    Motion out = motion(*assemblage.body, lets, depth + 1);
    known_[&assemblage] = out;
    return out;
  }

  std::map<std::string, const cdl::Assemblage*, std::less<>> assemblages_;
  std::map<const cdl::Assemblage*, Motion> known_;
};

}  // namespace

std::vector<Standing> standing_robots(const cdl::Tree& imported) {
  Observer observer(imported);
  std::vector<Standing> out;
  for (const cdl::Item& item : imported.items) {
    const auto* robot = std::get_if<cdl::Robot>(&item);
    if (robot == nullptr) continue;
    if (std::optional<Standing> one = observer.see(*robot)) out.push_back(std::move(*one));
  }
  return out;
}

std::string said_of(const std::vector<Standing>& robots) {
  std::string out;
  for (const Standing& one : robots) {
    const std::string where = one.states.empty()
                                  ? ""
                                  : fmt::format(" in the state{} {}", one.states.size() == 1 ? "" : "s",
                                                fmt::join(one.states, ", "));
    out += fmt::format("{}{}{} (no {})", out.empty() ? "" : "; ", one.robot, where,
                       fmt::join(one.missing, ", "));
  }
  return out;
}

}  // namespace mlab::cdl_historic
