#include "mlab/comparison/rows.h"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include "mlab/text/kept_lines.h"
#include "mlab/text/shown.h"

namespace mlab::comparison {
namespace {

constexpr std::size_t kMostEvents = 2000;
constexpr std::size_t kMostEventCharacters = 300;  // of an event

// Goes through both lists, in their order: what belongs together at once, else what the first has alone
// before what the second has alone.
template <class Take>
void align(const Both<std::vector<std::string>>& keys, Take take) {
  const std::vector<std::string_view> a(keys[0].begin(), keys[0].end());
  const std::vector<std::string_view> b(keys[1].begin(), keys[1].end());
  const std::vector<int> kept = text::kept_lines(a, b);
  int next = 0;
  const auto alone = [&](int end) {
    for (; next < end; ++next) take(-1, next);
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (kept[i] >= 0) alone(kept[i]);
    take(static_cast<int>(i), kept[i]);
    if (kept[i] >= 0) ++next;
  }
  alone(static_cast<int>(b.size()));
}

struct Command {
  std::string what;
  CommandRow::Times times;
};

std::vector<Command> commands_of(const mission::State& state) {
  std::vector<Command> out;
  for (const mission::StepRecord& step : state.steps) {
    for (std::uint32_t i = 0; i < step.command_count; ++i) {
      const mission::CommandRecord& record = state.commands[step.first_command + i];
      const std::string text = text::shown(record.text, 200);
      out.push_back({step.label.empty() ? text : fmt::format("step {}: {}", text::shown(step.label), text),
                     {record.start, record.end, record.outcome != mission::Outcome::kRunning,
                      std::string(mission::name(record.outcome))}});
    }
  }
  return out;
}

}  // namespace

void add_events(const Both<const history::History*>& histories, Comparison& out) {
  Both<std::vector<std::string>> keys;
  for (const std::size_t side : kSides) {
    const std::vector<history::EventEntry>& events = histories[side]->events();
    const std::size_t count = std::min(events.size(), kMostEvents);
    out.events_left_out += events.size() - count;
    for (std::size_t i = 0; i < count; ++i) keys[side].push_back(events[i].text);
  }
  align(keys, [&](int a, int b) {
    EventRow row;
    for (const std::size_t side : kSides) {
      const int index = side == 0 ? a : b;
      if (index < 0) continue;
      const history::EventEntry& event = histories[side]->events()[static_cast<std::size_t>(index)];
      row.text = text::shown(event.text, kMostEventCharacters);
      row.is_warning = event.is_warning;
      row.times[side] = event.time;
    }
    out.events.push_back(std::move(row));
  });
}

void add_commands(const Both<const run::MissionRun*>& runs, Comparison& out) {
  const Both<std::vector<Command>> commands = {commands_of(runs[0]->state()), commands_of(runs[1]->state())};
  Both<std::vector<std::string>> keys;
  for (const std::size_t side : kSides) {
    for (const Command& command : commands[side]) keys[side].push_back(command.what);
  }
  align(keys, [&](int a, int b) {
    CommandRow row;
    for (const std::size_t side : kSides) {
      const int index = side == 0 ? a : b;
      if (index < 0) continue;
      const Command& command = commands[side][static_cast<std::size_t>(index)];
      row.what = command.what;
      row.times[side] = command.times;
    }
    out.commands.push_back(std::move(row));
  });
}

void add_units(const Both<const run::MissionRun*>& runs, Comparison& out) {
  for (const std::size_t side : kSides) {
    const run::MissionRun& run = *runs[side];
    for (std::size_t i = 0; i < run.mission().units.size() && i < run.unit_metrics().size(); ++i) {
      const run::UnitMetrics& metrics = run.unit_metrics()[i];
      const std::string& name = run.mission().units[i].name;
      if (name.empty() || metrics.samples == 0) continue;
      auto row = std::ranges::find(out.units, name, &UnitRow::name);
      if (row == out.units.end()) row = out.units.insert(row, {name, {}});
      row->errors[side] = {metrics.mean_error(), metrics.max_error, metrics.out_share()};
    }
  }
}

}  // namespace mlab::comparison
