#include "mlab/comparison/causes.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/mission/wording.h"
#include "mlab/text/shown.h"

namespace mlab::comparison {
namespace {

using Runs = Both<const run::MissionRun*>;
using Robots = Both<const fleet::FleetRobot*>;

std::string quoted(const std::vector<std::string>& paths) {
  std::string out;
  for (const std::string& path : paths) out += fmt::format("{}`{}`", out.empty() ? "" : ", ", path);
  return out;
}

bool is_held(const robot::Workings& workings, const flow::Port& port) {
  return workings.interventions != nullptr &&
         std::ranges::any_of(workings.interventions->held(), [&](const flow::Interventions::Held& held) {
           return held.offset == port.offset;
         });
}

std::string order_of(const run::MissionRun& run, const fleet::FleetRobot& robot) {
  const fleet::Group* const group = run.fleet().group(robot);
  if (group == nullptr) return "none";
  const std::string text = group->command ? mission::command_text(run.mission(), *group->command) : "";
  return fmt::format("`{}` to ({:g}, {:g}), {}", text::shown(text, 120), group->order.goal.x,
                     group->order.goal.y, base::counted(group->members.size(), "robot"));
}

void add_order(const Runs& runs, const Robots& robots, std::vector<std::string>& out) {
  const geom::Pose& a = robots[0]->start;
  const geom::Pose& b = robots[1]->start;
  if (!(a.position.x == b.position.x && a.position.y == b.position.y && a.heading == b.heading))
    out.push_back(fmt::format("it was started at ({:g}, {:g}) in A and ({:g}, {:g}) in B", a.position.x,
                              a.position.y, b.position.x, b.position.y));
  const std::string one = order_of(*runs[0], *robots[0]);
  const std::string other = order_of(*runs[1], *robots[1]);
  if (one != other) out.push_back(fmt::format("its order is {} in A and {} in B", one, other));
}

// Where the first of them stand that are not the same; nothing: all are.
template <class Thing, class Place>
std::optional<std::string> difference_of(const char* what, std::span<const Thing> a, std::span<const Thing> b,
                                         Place place) {
  const auto [one, other] =
      std::ranges::mismatch(a, b, [&](const Thing& x, const Thing& y) { return place(x) == place(y); });
  if (one == a.end() && other == b.end()) return std::nullopt;
  std::string out = fmt::format("the world has {} {} in A and {} in B", a.size(), what, b.size());
  if (one != a.end() && other != b.end())
    out += fmt::format("; the first that differs is {} and {}", place(*one), place(*other));
  return out;
}

void add_world(const Runs& runs, std::vector<std::string>& out) {
  const binding::WorldView& a = runs[0]->world();
  const binding::WorldView& b = runs[1]->world();
  const auto add = [&](std::optional<std::string> difference) {
    if (difference) out.push_back(std::move(*difference));
  };
  add(difference_of("obstacles", a.discs(), b.discs(), [](const binding::Disc& disc) {
    return fmt::format("at ({:g}, {:g}) of radius {:g} m", disc.center.x, disc.center.y, disc.radius);
  }));
  add(difference_of("walls", a.walls(), b.walls(), [](const binding::Wall& wall) {
    return fmt::format("from ({:g}, {:g}) to ({:g}, {:g})", wall.segment.a.x, wall.segment.a.y,
                       wall.segment.b.x, wall.segment.b.y);
  }));
  add(difference_of("objects", a.objects(), b.objects(), [](const binding::Object& object) {
    return fmt::format("at ({:g}, {:g})", object.center.x, object.center.y);
  }));
}

std::string said(const InputDifference& input) {
  if (!input.inputs[0].empty() && !input.inputs[1].empty())
    return fmt::format("{} in A and {} in B", input.inputs[0], input.inputs[1]);
  const std::size_t side = input.inputs[0].empty() ? 1 : 0;
  return fmt::format("{} in {} alone", input.inputs[side], side == 0 ? "A" : "B");
}

const Fact* seeds_of(const Comparison& comparison) {
  const auto found = std::ranges::find(comparison.beginning.facts, "seed", &Fact::what);
  return found == comparison.beginning.facts.end() ? nullptr : &*found;
}

void add_seed(const Fact& seeds, const Parting& parting, std::vector<std::string>& out) {
  out.push_back(parting.what == Parting::What::kPort
                    ? fmt::format("the seeds are {} and {}: what is drawn at random differs", seeds.values[0],
                                  seeds.values[1])
                    : fmt::format("the seeds are {} and {}", seeds.values[0], seeds.values[1]));
}

// What the runs were made from, as far as it differs.
void add_beginning(const Beginning& beginning, std::vector<std::string>& out) {
  for (const Fact& fact : beginning.facts) {
    if (fact.what.starts_with("set ") || fact.what.starts_with("missionlab") ||
        fact.what.starts_with("arithmetic"))
      out.push_back(fmt::format("{}: {} in A and {} in B", fact.what,
                                fact.values[0].empty() ? "nothing" : fact.values[0],
                                fact.values[1].empty() ? "nothing" : fact.values[1]));
  }
  std::string names;
  for (const TextDifference& text : beginning.texts) {
    const std::string& path = text.paths[0].empty() ? text.paths[1] : text.paths[0];
    names += (names.empty() ? "" : ", ") + std::filesystem::path(path).filename().string();
  }
  if (!names.empty())
    out.push_back(fmt::format("they were made from different texts: {}", text::shown(names, 200)));
}

}  // namespace

std::vector<std::string> causes_at(const WireWalk& walk, const Both<robot::Workings>& workings,
                                   const ProgramPair::PortPair& first) {
  std::vector<std::string> out;
  const Both<bool> held = {is_held(workings[0], *first.ports[0]), is_held(workings[1], *first.ports[1])};
  if (held[0] || held[1])
    out.push_back(fmt::format("somebody holds it {}", held[0] && held[1] ? "in both"
                                                      : held[0]          ? "in A"
                                                                         : "in B"));
  out.insert(out.end(), walk.causes.begin(), walk.causes.end());
  if (!out.empty()) return out;
  out.push_back(fmt::format("no value that comes into `{}` differs", first.ports[0]->path));
  if (!walk.senses.empty()) out.push_back(fmt::format("it senses {}", walk.senses));
  if (!walk.lists.empty())
    out.push_back(
        fmt::format("of {} only the number is compared, not what stands in it", quoted(walk.lists)));
  return out;
}

void add_causes(const Runs& runs, const Robots& robots, const Comparison& comparison, Parting& parting) {
  std::vector<std::string>& out = parting.causes;
  if (robots[0] != nullptr && robots[1] != nullptr) add_order(runs, robots, out);
  add_world(runs, out);
  // What came in after the cycle before is there by now.
  if (comparison.input && comparison.input->cycle < parting.cycle)
    out.push_back(fmt::format("before, after cycle {}, this came in: {}", comparison.input->cycle,
                              said(*comparison.input)));
  if (const Fact* const seeds = seeds_of(comparison)) add_seed(*seeds, parting, out);
  add_beginning(comparison.beginning, out);
  if (out.empty()) out.emplace_back("nothing that is known of them differs before");
}

}  // namespace mlab::comparison
