#include "mlab/comparison/report.h"

#include <algorithm>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/comparison/words.h"
#include "mlab/text/shown.h"
#include "mlab/text/utf8.h"

namespace mlab::comparison {
namespace {

constexpr std::size_t kMostRobotsListed = 20;
constexpr std::size_t kMostEventsListed = 20;
constexpr std::size_t kMostCommandsListed = 60;

using Rows = std::vector<std::vector<std::string>>;

// Columns as wide as what stands in them, the first `left` of them to the left.
std::string aligned(const Rows& rows, std::size_t left) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string out;
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i)
      line +=
          i < left ? fmt::format(" {:<{}} ", row[i], widths[i]) : fmt::format(" {:>{}} ", row[i], widths[i]);
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  }
  return out;
}

class Report {
 public:
  explicit Report(const Comparison& comparison) : is_(comparison) {}

  std::string make() {
    add_sides();
    add_beginning();
    add_parting();
    add_robots();
    add_commands();
    add_units();
    add_events();
    out_ += fmt::format("\n{}\n", verdict(is_));
    return std::move(out_);
  }

 private:
  void head(std::string_view text) { out_ += fmt::format("\n{}\n", text); }

  void add_sides() {
    for (const std::size_t side : kSides) {
      const Side& one = is_.sides[side];
      const char* const name = side == 0 ? "A" : "B";
      out_ += fmt::format("{}: {}: {}\n", name, text::shown(one.name, 200), words_of(one));
      if (!one.why_not_recomputed.empty())
        out_ += fmt::format("   it can't be computed again: {}\n", one.why_not_recomputed);
      for (const std::string& remark : one.remarks) out_ += fmt::format("   {}\n", remark);
    }
    if (const std::string compared = compared_words(is_); !compared.empty()) out_ += compared + "\n";
    if (!is_.is_whole) out_ += "It was interrupted: what comes later was not compared.\n";
  }

  void add_beginning() {
    head("At the start");
    const Beginning& beginning = is_.beginning;
    if (beginning.facts.empty() && beginning.texts.empty()) out_ += "  nothing differs\n";
    Rows rows;
    const auto shown = [](const std::string& value) { return value.empty() ? std::string("-") : value; };
    for (const Fact& fact : beginning.facts)
      rows.push_back({fact.what + ":", shown(fact.values[0]), shown(fact.values[1])});
    out_ += aligned(rows, 3);
    for (const TextDifference& text : beginning.texts) add_text(text);
  }

  void add_text(const TextDifference& text) {
    if (text.paths[0].empty() || text.paths[1].empty()) {
      const bool is_first = text.paths[1].empty();
      out_ += fmt::format("  text only in {}: {}\n", is_first ? "A" : "B",
                          text::shown(text.paths[is_first ? 0 : 1], 200));
      return;
    }
    out_ += fmt::format("  text {}{}\n", text::shown(text.paths[0], 200),
                        text.paths[0] == text.paths[1] ? "" : " and " + text::shown(text.paths[1], 200));
    for (const std::string& line : text.lines) out_ += fmt::format("    {}\n", line);
    if (text.left_out > 0) out_ += fmt::format("    and {} more\n", base::counted(text.left_out, "line"));
  }

  void add_parting() {
    head("Where they part");
    if (is_.input) {
      const InputDifference& input = *is_.input;
      out_ += fmt::format("  What came in differs from cycle {} ({:.1f} s) on: {} in A, {} in B\n",
                          input.cycle, input.time, input.inputs[0].empty() ? "nothing" : input.inputs[0],
                          input.inputs[1].empty() ? "nothing" : input.inputs[1]);
    }
    if (!is_.parting) {
      out_ += fmt::format("  nowhere: {}\n", same_words(is_));
      return;
    }
    const Parting& parting = *is_.parting;
    out_ += fmt::format("  Cycle {} ({:.1f} s): {}\n", parting.cycle, parting.time, words_of(parting));
    if (parting.same_until) out_ += fmt::format("  up to cycle {} they are the same\n", *parting.same_until);
    for (const std::string& cause : parting.causes) out_ += fmt::format("  - {}\n", cause);
    add_consequences(parting);
    if (parting.robots.size() > 1)
      out_ += fmt::format("  In that cycle {} part.\n", robots_words(parting.robots));
  }

  void add_consequences(const Parting& parting) {
    if (parting.consequences.empty()) return;
    out_ += fmt::format("  Of its values {} in that cycle; along the wires from there:\n",
                        parting.values == 1 ? "1 differs" : fmt::format("{} differ", parting.values));
    Rows rows;
    for (const Value& value : parting.consequences)
      rows.push_back({"  " + text::shown(value.path, 60), text::shown(value.values[0], 60),
                      text::shown(value.values[1], 60)});
    out_ += aligned(rows, 3);
  }

  void add_robots() {
    if (is_.robots.empty()) return;
    std::vector<const RobotRow*> listed;
    for (const RobotRow& row : is_.robots) listed.push_back(&row);
    const bool is_long = listed.size() > kMostRobotsListed;
    if (is_long) {
      std::ranges::stable_sort(listed, std::ranges::greater{},
                               [](const RobotRow* row) { return row->most_apart; });
      listed.resize(kMostRobotsListed);
    }
    head(is_long ? fmt::format("The same robots in both: the {} that are farthest apart, of {}",
                               kMostRobotsListed, is_.robots.size())
                 : "The same robots in both");
    Rows rows = {{"robot", "apart at most", "at", "at the end"}};
    if (is_.is_recomputed) rows[0].insert(rows[0].end(), {"drove A", "drove B", "contacts A", "contacts B"});
    for (const RobotRow* const row : listed) rows.push_back(cells_of(*row));
    out_ += aligned(rows, 1);
    for (const std::string& alone : alone_words(is_)) out_ += fmt::format("  {}\n", alone);
  }

  std::vector<std::string> cells_of(const RobotRow& row) const {
    if (std::string where = where_it_is(row); !where.empty())
      return {std::to_string(row.id), std::move(where)};
    std::vector<std::string> out = {std::to_string(row.id), fmt::format("{:.2f} m", row.most_apart),
                                    fmt::format("{:.1f} s", row.most_apart_at),
                                    fmt::format("{:.2f} m", row.apart_at_end)};
    if (!is_.is_recomputed) return out;
    for (const double driven : row.driven) out.push_back(fmt::format("{:.1f} m", driven));
    for (const std::uint32_t contacts : row.contacts) out.push_back(std::to_string(contacts));
    return out;
  }

  void add_commands() {
    if (is_.commands.empty()) return;
    head("The mission's steps");
    Rows rows = {{"", "A", "B"}};
    for (const CommandRow& row : is_.commands) {
      if (rows.size() > kMostCommandsListed) break;
      rows.push_back({row.what, words_of(row.times[0]), words_of(row.times[1])});
    }
    out_ += aligned(rows, 3);
    if (is_.commands.size() > kMostCommandsListed)
      out_ += fmt::format("  and {} more (--json has all)\n", is_.commands.size() - kMostCommandsListed);
  }

  void add_units() {
    if (is_.units.empty()) return;
    head("How formations were kept");
    Rows rows = {{"unit", "mean error A", "B", "at most A", "B", "out of formation A", "B"}};
    for (const UnitRow& unit : is_.units) {
      std::vector<std::string> cells = {text::shown(unit.name)};
      const auto add = [&](auto words) {
        for (const auto& error : unit.errors) cells.push_back(error ? words(*error) : "");
      };
      add([](const UnitRow::Error& error) { return fmt::format("{:.2f} m", error.mean); });
      add([](const UnitRow::Error& error) { return fmt::format("{:.1f} m", error.most); });
      add([](const UnitRow::Error& error) { return fmt::format("{:.1f} %", 100.0 * error.out_share); });
      rows.push_back(std::move(cells));
    }
    out_ += aligned(rows, 1);
  }

  void add_events() {
    std::vector<const EventRow*> alone;
    for (const EventRow& event : is_.events) {
      if (!event.times[0] || !event.times[1]) alone.push_back(&event);
    }
    if (alone.empty()) return;
    head("Told in one of them alone");
    for (std::size_t i = 0; i < std::min(alone.size(), kMostEventsListed); ++i) {
      const EventRow& event = *alone[i];
      out_ += fmt::format("  {} [{:9.1f} s] {}{}\n", event.times[0] ? "A" : "B",
                          event.times[0] ? *event.times[0] : *event.times[1],
                          event.is_warning ? "warning: " : "", event.text);
    }
    if (alone.size() > kMostEventsListed)
      out_ += fmt::format("  and {} more (--json has all)\n", alone.size() - kMostEventsListed);
  }

  const Comparison& is_;
  std::string out_;
};

}  // namespace

std::string report_of(const Comparison& comparison) {
  return Report(comparison).make();
}

}  // namespace mlab::comparison
