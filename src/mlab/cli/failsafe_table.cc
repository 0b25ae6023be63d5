#include "mlab/cli/failsafe_table.h"

#include <filesystem>

#include <fmt/core.h>

#include "mlab/cli/permission.h"
#include "mlab/cli/places.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/mission/mission.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::cli {
namespace {

std::string place_of(const text::Place& place) {
  const text::LineColumn begin = place.source->line_column(place.span.begin);
  return fmt::format("{}:{}", begin.line, begin.column);
}

}  // namespace

std::vector<FailsafeRow> failsafe_rows(const text::SourcePtr& source) {
  text::Diagnostics unsaid;
  mdl::LoadOptions options;
  const std::string folder = std::filesystem::path(source->name()).parent_path().string();
  options.societies = robot::society_reader(program_sources(folder, permission_to_check(true, false)));
  const auto mission = mdl::check_mission(source, folder, unsaid, options);
  if (mission == nullptr) return {};
  std::vector<FailsafeRow> out = {{0, "", "emergency stop", "", "stands", "always"}};
  for (const mission::Failsafe& one : mission->failsafes) {
    const mission::FailsafeConditionInfo& condition = mission::info(one.condition);
    out.push_back({out.size(), one.type_name,
                   fmt::format("{}{}{}{}", condition.word, condition.has_fence ? " " : "", one.fence_name,
                               condition.has_share ? fmt::format(" BELOW {:g}%", 100.0 * one.share) : ""),
                   condition.may_last ? fmt::format("{:g} s", one.seconds) : "",
                   std::string(mission::info(one.action).word), place_of(one.place)});
  }
  out.push_back({0, "", "program fails", "", "stands", "always"});
  out.push_back({0, "", "LINK-LOST", "0.5 s", "stands", "always, with --real-time"});
  out.push_back({0, "", "PERCEPTS-STALE", "0.5 s", "stands", "always, with --real-time"});
  out.push_back({0, "", "OPERATOR-ABSENT", "0.5 s", "stick let go", "always, under teleoperation"});
  return out;
}

std::string table_of(const std::vector<FailsafeRow>& rows) {
  if (rows.empty()) return "";
  std::string out;
  const auto add = [&](std::string_view rank, const auto&... cells) {
    std::string line = fmt::format("  {:<5} {:<12} {:<24} {:<7} {:<15} {}", rank, cells...);
    out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  };
  add("rank", "robots", "condition", "after", "action", "stated");
  for (const FailsafeRow& row : rows)
    add(row.rank == 0 ? "-" : std::to_string(row.rank), row.robots.empty() ? "all" : row.robots,
        row.condition, row.after, row.action, row.stated);
  return out;
}

}  // namespace mlab::cli
