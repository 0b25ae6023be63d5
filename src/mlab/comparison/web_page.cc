#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/comparison/report.h"
#include "mlab/comparison/words.h"
#include "mlab/page/charts.h"
#include "mlab/page/document.h"
#include "mlab/page/numbers.h"
#include "mlab/text/escape.h"
#include "mlab/text/shown.h"

namespace mlab::comparison {
namespace {

constexpr std::size_t kMostRowsDrawn = 30;
constexpr std::size_t kMostWaysDrawn = 30;  // robots
constexpr std::size_t kMostRowsInTable = 500;

using TableRows = std::vector<std::vector<std::string>>;

class PageOfTwo {
 public:
  PageOfTwo(const Comparison& comparison, const std::string& version) : is_(comparison), version_(version) {
    for (const RobotRow& row : is_.robots) farthest_.push_back(&row);
    std::ranges::stable_sort(farthest_, std::ranges::greater{},
                             [](const RobotRow* row) { return row->most_apart; });
  }

  std::string make() {
    add_sides();
    add_beginning();
    add_parting();
    add_distances();
    add_ways();
    add_robots();
    add_commands();
    add_formations();
    add_events();
    out_ += fmt::format("<p class=\"faint\">mlab {}</p>\n", text::markup(version_));
    return page::document(fmt::format("{} and {}", short_name(0), short_name(1)), out_);
  }

 private:
  std::string short_name(std::size_t side) const {
    return text::shown(std::filesystem::path(is_.sides[side].name).filename().string(), 80);
  }
  void head(std::string_view text) { out_ += fmt::format("<h2>{}</h2>\n", text::markup(text)); }
  void paragraph(std::string_view text) { out_ += fmt::format("<p>{}</p>\n", page::prose(text)); }
  void add_table(std::string_view caption, TableRows rows, std::size_t left) {
    const std::size_t all = rows.size() - 1;
    if (rows.size() > kMostRowsInTable + 1) rows.resize(kMostRowsInTable + 1);
    out_ += page::table(caption, rows, left);
    if (all > kMostRowsInTable)
      out_ += fmt::format("<p class=\"faint\">The first {} of {}.</p>\n", kMostRowsInTable, all);
  }

  void add_sides() {
    out_ += fmt::format("<p><strong>{}</strong></p>\n", text::markup(verdict(is_)));
    for (const std::size_t side : kSides) {
      const Side& one = is_.sides[side];
      out_ += fmt::format("<p><span class=\"key{}\">{}</span> {}: {}</p>\n", side == 0 ? "" : " two",
                          side == 0 ? "A" : "B", text::markup(text::shown(one.name, 200)),
                          text::markup(words_of(one)));
      if (!one.why_not_recomputed.empty()) paragraph("It can't be computed again: " + one.why_not_recomputed);
      for (const std::string& remark : one.remarks) paragraph(remark);
    }
    if (const std::string compared = compared_words(is_); !compared.empty()) paragraph(compared);
    if (!is_.is_whole) paragraph("It was interrupted: what comes later was not compared.");
  }

  void add_beginning() {
    head("At the start");
    const Beginning& beginning = is_.beginning;
    if (beginning.facts.empty() && beginning.texts.empty()) paragraph("Nothing differs.");
    if (!beginning.facts.empty()) {
      TableRows rows = {{"", "A", "B"}};
      for (const Fact& fact : beginning.facts) rows.push_back({fact.what, fact.values[0], fact.values[1]});
      add_table("What both were made with", std::move(rows), 3);
    }
    for (const TextDifference& text : beginning.texts) {
      const bool is_alone = text.paths[0].empty() || text.paths[1].empty();
      const std::string& path = text.paths[0].empty() ? text.paths[1] : text.paths[0];
      out_ += fmt::format("<h3>{}{}</h3>\n", text::markup(text::shown(path, 200)),
                          !is_alone               ? ""
                          : text.paths[1].empty() ? ": only in A"
                                                  : ": only in B");
      if (is_alone) continue;
      std::string lines;
      for (const std::string& line : text.lines) lines += line + "\n";
      if (text.left_out > 0) lines += fmt::format("and {} more\n", base::counted(text.left_out, "line"));
      out_ += fmt::format("<code>{}</code>\n", text::markup(lines));
    }
  }

  void add_parting() {
    head("Where they part");
    if (const auto& input = is_.input)
      paragraph(fmt::format("What came in differs from cycle {} ({:.1f} s) on: {} in A, {} in B.",
                            input->cycle, input->time,
                            input->inputs[0].empty() ? "nothing" : input->inputs[0],
                            input->inputs[1].empty() ? "nothing" : input->inputs[1]));
    if (!is_.parting) {
      paragraph(fmt::format("Nowhere: {}.", same_words(is_)));
      return;
    }
    const Parting& parting = *is_.parting;
    paragraph(fmt::format("Cycle {} ({:.1f} s): {}", parting.cycle, parting.time, words_of(parting)));
    if (parting.same_until) paragraph(fmt::format("Up to cycle {} they are the same.", *parting.same_until));
    if (!parting.causes.empty()) {
      out_ += "<ul>\n";
      for (const std::string& cause : parting.causes)
        out_ += fmt::format("<li>{}</li>\n", page::prose(cause));
      out_ += "</ul>\n";
    }
    if (!parting.consequences.empty()) {
      TableRows rows = {{"value", "A", "B"}};
      for (const Value& value : parting.consequences)
        rows.push_back({value.path, text::shown(value.values[0], 80), text::shown(value.values[1], 80)});
      add_table("Along the wires from there, in the same cycle", std::move(rows), 3);
    }
    if (parting.robots.size() > 1)
      paragraph(fmt::format("In that cycle {} part.", robots_words(parting.robots)));
  }

  std::optional<double> mark() const { return is_.parting ? std::optional(is_.parting->time) : std::nullopt; }

  void add_distances() {
    if (is_.times.empty() || farthest_.empty()) return;
    head("How far apart the same robots are");
    out_ +=
        "<p class=\"faint\">Over time [s]; the line across is where the runs part. All rows in one "
        "scale.</p>\n";
    const page::Axis axis = page::number_axis(is_.times.front(), is_.times.back());
    const double top = farthest_.front()->most_apart;
    for (std::size_t i = 0; i < std::min(farthest_.size(), kMostRowsDrawn); ++i) {
      const RobotRow& row = *farthest_[i];
      page::Line line;
      for (std::size_t k = 0; k < std::min(row.apart.size(), is_.times.size()); ++k)
        line.points.emplace_back(is_.times[k], static_cast<double>(row.apart[k]));
      std::string figure = where_it_is(row);
      if (figure.empty())
        figure = fmt::format("at most {:.1f} m, at last {:.1f} m", row.most_apart, row.apart_at_end);
      out_ += page::line_row(
          {fmt::format("robot {}", row.id), {std::move(line)}, top, std::move(figure), mark()}, axis);
    }
    out_ += page::axis_row(axis);
    if (farthest_.size() > kMostRowsDrawn)
      out_ += fmt::format("<p class=\"faint\">The {} that are farthest apart, of {}.</p>\n", kMostRowsDrawn,
                          farthest_.size());
  }

  void add_ways() {
    std::vector<page::Line> lines;
    for (std::size_t i = 0; i < std::min(farthest_.size(), kMostWaysDrawn); ++i) {
      for (const std::size_t side : kSides) {
        page::Line line{{}, side == 1};
        for (const auto& [x, y] : farthest_[i]->ways[side])
          line.points.emplace_back(static_cast<double>(x), static_cast<double>(y));
        lines.push_back(std::move(line));
      }
    }
    const std::string drawing = page::ways(lines, "the ways of the robots in both runs, seen from above");
    if (drawing.empty()) return;
    head("Their ways");
    out_ +=
        "<p class=\"faint\">Seen from above: <span class=\"key\">A</span>, "
        "<span class=\"key two\">B</span>.</p>\n" +
        drawing;
  }

  void add_robots() {
    if (is_.robots.empty()) return;
    head("Robots");
    for (const std::string& alone : alone_words(is_)) paragraph(alone + ".");
    TableRows rows = {{"robot", "", "apart at most [m]", "at [s]", "at the end [m]"}};
    if (is_.is_recomputed)
      rows[0].insert(rows[0].end(), {"drove A [m]", "drove B [m]", "contacts A", "contacts B",
                                     "first contact A [s]", "first contact B [s]"});
    for (const RobotRow& row : is_.robots) rows.push_back(cells_of(row));
    add_table("The same robots in both", std::move(rows), 2);
  }

  // Of who is in one of them alone nothing is said of the other.
  std::vector<std::string> cells_of(const RobotRow& row) const {
    std::vector<std::string> out = {std::to_string(row.id), where_it_is(row), "", "", ""};
    if (out[1].empty()) {
      out[2] = fmt::format("{:.2f}", row.most_apart);
      out[3] = fmt::format("{:.1f}", row.most_apart_at);
      out[4] = fmt::format("{:.2f}", row.apart_at_end);
    }
    if (!is_.is_recomputed) return out;
    const auto add = [&](auto words) {
      for (const std::size_t side : kSides) out.push_back(row.is_there[side] ? words(side) : "");
    };
    add([&](std::size_t side) { return fmt::format("{:.1f}", row.driven[side]); });
    add([&](std::size_t side) { return std::to_string(row.contacts[side]); });
    add([&](std::size_t side) { return seconds(row.first_contact[side]); });
    return out;
  }

  void add_commands() {
    if (is_.commands.empty()) return;
    head("The mission's steps");
    TableRows rows = {{"", "A", "B", "longer in B [s]"}};
    for (const CommandRow& row : is_.commands) {
      std::string longer;
      if (row.times[0] && row.times[1] && row.times[0]->has_ended && row.times[1]->has_ended)
        longer = page::signed_number(std::round(1e3 * (row.times[1]->end - row.times[1]->start -
                                                       (row.times[0]->end - row.times[0]->start))) /
                                     1e3);
      rows.push_back({row.what, words_of(row.times[0]), words_of(row.times[1]), longer});
    }
    add_table("When each command ran", std::move(rows), 3);
  }

  void add_formations() {
    if (is_.units.empty()) return;
    head("How formations were kept");
    double top = 0.0;
    page::LineRow row{"error [m]", {}, 1.0, "", mark()};
    for (const std::size_t side : kSides) {
      page::Line line{{}, side == 1};
      for (std::size_t k = 0; k < std::min(is_.formation_errors[side].size(), is_.times.size()); ++k) {
        const auto error = static_cast<double>(is_.formation_errors[side][k]);
        if (std::isfinite(error)) top = std::max(top, error);
        line.points.emplace_back(is_.times[k], error);
      }
      row.lines.push_back(std::move(line));
    }
    if (top > 0.0) {
      row.top = top;
      row.figure = fmt::format("mean of all robots, up to {} m", page::brief(top));
      const page::Axis axis = page::number_axis(is_.times.front(), is_.times.back());
      out_ += page::line_row(row, axis) + page::axis_row(axis);
    }
    TableRows rows = {
        {"unit", "mean error A [m]", "B [m]", "at most A [m]", "B [m]", "out of formation A", "B"}};
    for (const UnitRow& unit : is_.units) {
      std::vector<std::string> cells = {unit.name};
      for (const auto& error : unit.errors) cells.push_back(error ? fmt::format("{:.2f}", error->mean) : "");
      for (const auto& error : unit.errors) cells.push_back(error ? fmt::format("{:.1f}", error->most) : "");
      for (const auto& error : unit.errors) cells.push_back(error ? page::percent(error->out_share) : "");
      rows.push_back(std::move(cells));
    }
    add_table("By unit", std::move(rows), 1);
  }

  void add_events() {
    if (is_.events.empty()) return;
    head("What was told");
    TableRows rows = {{"", "A [s]", "B [s]"}};
    for (const EventRow& event : is_.events)
      rows.push_back({(event.is_warning ? "warning: " : "") + event.text, seconds(event.times[0]),
                      seconds(event.times[1])});
    add_table("The same words are the same event", std::move(rows), 1);
  }

  const Comparison& is_;
  const std::string& version_;
  std::vector<const RobotRow*> farthest_;
  std::string out_;
};

}  // namespace

std::string page_of(const Comparison& comparison, const std::string& program_version) {
  return PageOfTwo(comparison, program_version).make();
}

}  // namespace mlab::comparison
