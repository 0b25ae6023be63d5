#include "mlab/comparison/words.h"

#include <filesystem>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/text/shown.h"

namespace mlab::comparison {
namespace {

constexpr std::size_t kMostSpans = 12;
constexpr std::size_t kMostOfValue = 120;

std::string in_one(const std::string& value, const char* side) {
  return fmt::format("{} in {}", value.empty() ? "nothing" : text::shown(value, kMostOfValue), side);
}

std::string subject_of(const Parting& parting) {
  const std::string robot = parting.robot == 0 ? "" : fmt::format("robot {}, ", parting.robot);
  switch (parting.what) {
    case Parting::What::kPort:
      return fmt::format("{}`{}`", robot, parting.value.path);
    case Parting::What::kState:
      return fmt::format("{}state of `{}`", robot, parting.value.path);
    default:
      return robot + parting.value.path;
  }
}

bool is_in_both(const RobotRow& row) {
  return row.is_there[0] && row.is_there[1];
}

// Robots that both have, of which values were compared or not.
std::vector<std::uint32_t> compared_robots(const Comparison& comparison, bool has_values) {
  std::vector<std::uint32_t> out;
  for (const RobotRow& row : comparison.robots) {
    if (is_in_both(row) && row.has_values == has_values) out.push_back(row.id);
  }
  return out;
}

}  // namespace

std::string compared_words(const Comparison& comparison) {
  if (!comparison.is_recomputed)
    return "Only what was recorded is compared: where robots were once a second, what was told, how it "
           "ended.";
  const std::vector<std::uint32_t> unseen = compared_robots(comparison, false);
  if (unseen.empty()) return "";
  return fmt::format(
      "Of {} only what was answered and where they were is compared: what went on inside of their programs "
      "was not recorded.",
      compared_robots(comparison, true).empty() ? "all robots" : robots_words(unseen));
}

std::string same_words(const Comparison& comparison) {
  if (!comparison.is_recomputed) return "what was recorded is the same: where robots were once a second";
  const std::vector<std::uint32_t> unseen = compared_robots(comparison, false);
  const std::vector<std::uint32_t> seen = compared_robots(comparison, true);
  if (unseen.empty()) return "all values of all robots are the same in all cycles";
  if (seen.empty()) return "what all robots answered and where they were is the same in all cycles";
  return fmt::format(
      "all values of {} are the same in all cycles, and of {} what was answered and where they were",
      robots_words(seen), robots_words(unseen));
}

std::vector<std::string> alone_words(const Comparison& comparison) {
  std::vector<std::string> out;
  for (const std::size_t side : kSides) {
    std::vector<std::uint32_t> alone;
    for (const RobotRow& row : comparison.robots) {
      if (row.is_there[side] && !row.is_there[1 - side]) alone.push_back(row.id);
    }
    if (alone.empty()) continue;
    out.push_back(fmt::format("{} {} in {} alone", robots_words(alone), alone.size() == 1 ? "is" : "are",
                              side == 0 ? "A" : "B"));
  }
  return out;
}

std::string where_it_is(const RobotRow& row) {
  if (is_in_both(row)) return "";
  return row.is_there[0] ? "only in A" : row.is_there[1] ? "only in B" : "not started";
}

std::string verdict(const Comparison& comparison) {
  if (!comparison.parting) {
    const std::string as_far = !comparison.is_recomputed ? ", as far as they were recorded"
                               : compared_robots(comparison, false).empty()
                                   ? ""
                                   : ", as far as robots' programs can be seen into";
    if (!comparison.is_whole) return "the same as far as they were compared" + as_far;
    if (comparison.is_same()) return "the same run" + as_far;
    return "they never part, though they were not made from the same" + as_far;
  }
  const Parting& parting = *comparison.parting;
  if (!comparison.is_recomputed)
    return fmt::format("by cycle {} ({:.1f} s) they have parted", parting.cycle, parting.time);
  return fmt::format("they part {} cycle {} ({:.1f} s)", parting.what == Parting::What::kEnd ? "after" : "in",
                     parting.cycle, parting.time);
}

std::string words_of(const Side& side) {
  return fmt::format("{}, seed {}, {} ({:.1f} s), {}",
                     text::shown(std::filesystem::path(side.mission).filename().string(), 80), side.seed,
                     base::counted(side.cycles, "cycle"), side.length,
                     side.outcome.empty() ? "cut off" : text::shown(side.outcome));
}

std::string words_of(const Parting& parting) {
  return fmt::format("{}: {}, {}", subject_of(parting), in_one(parting.value.values[0], "A"),
                     in_one(parting.value.values[1], "B"));
}

std::string robots_words(const std::vector<std::uint32_t>& robots) {
  std::string out;
  std::size_t spans = 0;
  for (std::size_t i = 0; i < robots.size();) {
    std::size_t end = i + 1;
    while (end < robots.size() && robots[end] == robots[end - 1] + 1) ++end;
    if (++spans > kMostSpans) return fmt::format("{} and {} more", out, robots.size() - i);
    out += fmt::format("{}{}", out.empty() ? "" : ", ", robots[i]);
    if (end - i > 1) out += fmt::format(" to {}", robots[end - 1]);
    i = end;
  }
  return (robots.size() == 1 ? "robot " : "robots ") + out;
}

std::string words_of(const std::optional<CommandRow::Times>& times) {
  if (!times) return "";
  if (!times->has_ended) return fmt::format("{:.1f} s on", times->start);
  return fmt::format("{:.1f} to {:.1f} s, {}", times->start, times->end, times->outcome);
}

std::string seconds(const std::optional<double>& time) {
  return time ? fmt::format("{:.1f}", *time) : "";
}

}  // namespace mlab::comparison
