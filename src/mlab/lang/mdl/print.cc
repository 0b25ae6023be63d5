#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/mission/maneuver.h"
#include "mlab/mission/tasks.h"

namespace mlab::mdl {
namespace {

constexpr std::size_t kMaxColumns = 100;
constexpr std::size_t kMaxLabelColumns = 6;

std::string text_of(const Name& name) {
  return name.quoted ? "\"" + name.text + "\"" : name.text;
}

std::string text_of(const Location& location) {
  return location.name ? text_of(*location.name) : location.x.text + " " + location.y.text;
}

std::string text_of(const Moment& moment) {
  std::string out = moment.is_timeout ? "TIMEOUT" : "";
  const auto add = [&](const std::string& word) { out += (out.empty() ? "" : " ") + word; };
  if (moment.time) add(moment.time->text);
  if (moment.date) add(moment.date->text);
  if (moment.number) add(moment.number->text);
  return out;
}

std::string_view text_of(mission::Technique technique) {
  switch (technique) {
    case mission::Technique::kTravelingOverwatch:
      return "Traveling-Overwatch";
    case mission::Technique::kBoundingOverwatch:
      return "Bounding-Overwatch";
    default:
      return "Traveling";
  }
}

std::string_view text_of(mission::BooleanOption option) {
  switch (option) {
    case mission::BooleanOption::kUseMilitaryStyle:
      return "USE-MILITARY-STYLE";
    case mission::BooleanOption::kShowTrails:
      return "SHOW-TRAILS";
    case mission::BooleanOption::kHighlightRepellingObstacles:
      return "HIGHLIGHT-REPELLING-OBSTACLES";
    case mission::BooleanOption::kShowMovementVectors:
      return "SHOW-MOVEMENT-VECTORS";
    case mission::BooleanOption::kShowColormap:
      return "SHOW-COLORMAP";
    case mission::BooleanOption::kDebugRobots:
      return "DEBUG-ROBOTS";
    case mission::BooleanOption::kDebugSimulator:
      return "DEBUG-SIMULATOR";
    case mission::BooleanOption::kDebugScheduler:
      return "DEBUG-SCHEDULER";
    case mission::BooleanOption::kPlanWays:
    case mission::BooleanOption::kAssignStations:
      return mission::maneuver(option)->word;
    default:
      return "SCALE-ROBOTS";
  }
}

std::string_view text_of(mission::NumberOption option) {
  switch (option) {
    case mission::NumberOption::kSeed:
      return "SEED";
    case mission::NumberOption::kRobotLength:
      return "ROBOT-LENGTH";
    case mission::NumberOption::kObstacleCoverage:
      return "OBSTACLE-COVERAGE";
    case mission::NumberOption::kMinObstacleRadius:
      return "MIN-OBSTACLE-RADIUS";
    case mission::NumberOption::kMaxObstacleRadius:
      return "MAX-OBSTACLE-RADIUS";
    case mission::NumberOption::kZoomFactor:
      return "ZOOM-FACTOR";
    case mission::NumberOption::kFailingRobots:
      return "FAILING-ROBOTS";
    case mission::NumberOption::kFailuresWithin:
      return "FAILURES-WITHIN";
    case mission::NumberOption::kCohesion:
      return mission::maneuver(option)->word;
    default:
      return "CYCLE-DURATION";
  }
}

std::string_view text_of(mission::Task task) {
  return mission::info(task).word;
}

struct ClausePrinter {
  std::string operator()(const clause::Formation& c) const {
    return fmt::format("FORMATION {}", percept::name(c.formation));
  }
  std::string operator()(const clause::Technique& c) const {
    return fmt::format("TECHNIQUE {}", text_of(c.technique));
  }
  std::string operator()(const clause::Speed& c) const { return "SPEED " + c.speed.text; }
  std::string operator()(const clause::Heading& c) const { return "HEADING " + c.degrees.text; }
  std::string operator()(const clause::PhaseLine& c) const {
    std::string out = "PHASE-LINE " + text_of(c.line);
    if (c.moment) out += " " + text_of(*c.moment);
    if (c.acknowledge) out += " ACKNOWLEDGE " + text_of(*c.acknowledge);
    return c.waits ? out + " WAIT" : out;
  }
  std::string operator()(const clause::OnCompletion& c) const {
    return "ON-COMPLETION MESSAGE " + text_of(c.message);
  }
  std::string operator()(const clause::Until& c) const { return "UNTIL " + text_of(c.moment); }
  std::string operator()(const clause::Swath& c) const { return "SWATH " + c.width.text; }
};

// The parameters on the statement's own line where they are few, else one per line.
std::string text_of(const statement::NewRobot& robot) {
  std::string out = fmt::format("NEW-ROBOT {} {}", text_of(robot.name), text_of(robot.program));
  if (robot.color) out += " " + text_of(*robot.color);
  if (robot.host) out += " " + text_of(*robot.host);
  if (robot.parameters.empty()) return out;
  std::string on_line = out + " (";
  bool is_plain = robot.parameters.size() <= 2 && robot.comments_below.empty();
  for (const Parameter& p : robot.parameters) {
    is_plain = is_plain && p.comments.above.empty() && p.comments.after.empty();
    if (&p != &robot.parameters.front()) on_line += ", ";
    on_line += text_of(p.key) + " = " + p.written;
  }
  if (is_plain && on_line.size() < kMaxColumns) return on_line + ")";
  out += " (\n";
  for (const Parameter& p : robot.parameters) {
    const bool is_last = &p == &robot.parameters.back();
    for (const std::string& line : p.comments.above) {
      const bool opens = &p == &robot.parameters.front() && &line == &p.comments.above.front();
      if (!line.empty()) out += "    " + line + "\n";
      if (line.empty() && !opens && !out.ends_with("\n\n")) out += "\n";
    }
    out += "    " + text_of(p.key) + " = " + p.written + (is_last ? "" : ",");
    out += (p.comments.after.empty() ? "" : "  " + p.comments.after) + "\n";
  }
  for (const std::string& line : robot.comments_below) out += "    " + line + "\n";
  return out + ")";
}

// Walks the groups with a stack of its own: what is open, and which part of it comes next.
std::string text_of(const statement::UnitDefinition& unit) {
  struct Open {
    std::size_t group = 0;
    std::size_t next_part = 0;
  };
  const auto head = [&](std::size_t index) {
    const Group& group = unit.groups[index];
    std::string out = group.name ? "<" + text_of(*group.name) + ">" : "";
    for (const Name& robot : group.robots) out += (out.empty() ? "" : " ") + text_of(robot);
    return out;
  };
  std::string out = "UNIT " + head(0);
  std::vector<Open> open = {{0, 0}};
  while (!open.empty()) {
    Open& top = open.back();
    const Group& group = unit.groups[top.group];
    if (top.next_part == group.parts.size()) {
      open.pop_back();
      if (!open.empty()) out += ")";
      continue;
    }
    const std::size_t part = group.parts[top.next_part++];
    out += " (" + head(part);
    open.push_back({part, 0});
  }
  return out;
}

// Between them a line may end: up to the first place, each of the others, and the rest.
std::vector<std::string> pieces_of(const statement::UnitAction& s) {
  std::string begin = s.robots.empty() ? "UNIT " + text_of(s.unit) : s.says_robots ? "ROBOTS" : "ROBOT";
  for (const Number& robot : s.robots) begin += " " + robot.text;
  begin += fmt::format(" {}", text_of(s.task));
  if (s.location) begin += " " + text_of(*s.location);
  std::vector<std::string> out{std::move(begin)};
  for (const Location& place : s.more) out.push_back(text_of(place));
  if (s.step) out.back() += fmt::format(" {} {}", s.step->x.text, s.step->y.text);
  for (const Clause& c : s.clauses) out.back() += " " + std::visit(ClausePrinter{}, c.what);
  return out;
}

struct StatementPrinter {
  std::string operator()(const statement::MissionName& s) const { return "MISSION NAME " + text_of(s.name); }
  std::string operator()(const statement::Scenario& s) const { return "SCENARIO " + text_of(s.name); }
  std::string operator()(const statement::OverlayFile& s) const { return "OVERLAY " + text_of(s.file); }
  std::string operator()(const statement::MissionArea& s) const {
    return fmt::format("MISSION-AREA {} {}", s.width.text, s.height.text);
  }
  std::string operator()(const statement::LoadMap& s) const { return "LOAD-MAP " + text_of(s.file); }
  std::string operator()(const statement::StartPlace& s) const {
    return fmt::format("SP {} {} {}", text_of(s.name), s.x.text, s.y.text);
  }
  std::string operator()(const statement::Obstacle& s) const {
    return fmt::format("OBSTACLE {} {} {}", s.x.text, s.y.text, s.radius.text);
  }
  std::string operator()(const statement::CreateObstacles&) const { return "CREATE-OBSTACLES"; }
  std::string operator()(const statement::NewRobot& s) const { return text_of(s); }
  std::string operator()(const statement::UnitDefinition& s) const { return text_of(s); }
  std::string operator()(const statement::Set& s) const {
    std::string out =
        fmt::format("SET {}", std::visit([](auto option) { return text_of(option); }, s.option));
    const mission::ManeuverInfo* const named = mission::maneuver(s.option);
    if (s.flag && named != nullptr)
      out += fmt::format(" {}", *s.flag ? named->on : named->off);
    else if (s.flag)
      out += *s.flag ? " ON" : " OFF";
    if (s.number) out += " " + s.number->text;
    return out;
  }
  std::string operator()(const statement::Print& s) const {
    return s.robot_info ? "PRINT ROBOT-INFO" : "PRINT CONSOLE-DATABASE";
  }
  std::string operator()(const statement::Failsafe& s) const {
    std::string out = s.type ? "FAILSAFE FOR " + text_of(*s.type) + " " : "FAILSAFE ";
    out += mission::info(s.condition).word;
    if (s.fence) out += " " + text_of(*s.fence);
    if (s.share) out += " BELOW " + s.share->text + "%";
    if (s.seconds) out += " AFTER " + s.seconds->text;
    return out + fmt::format(" {}", mission::info(s.action).word);
  }
  std::string operator()(const statement::Quit&) const { return "QUIT"; }
  std::string operator()(const statement::InjectTrack& s) const {
    return s.is_red ? "INJECTTRACK RED" : "INJECTTRACK YELLOW";
  }
  std::string operator()(const statement::UnitAction& s) const {
    return fmt::format("{}", fmt::join(pieces_of(s), " "));
  }
};

class Printer {
 public:
  std::string mission(const Tree& tree) {
    if (tree.is_immediate) return typed(tree);
    for (const Statement& s : tree.preamble) {
      above(s.comments, "");
      line(std::visit(StatementPrinter{}, s.what), s.comments.after);
    }
    above(tree.header, "");
    blank_line();
    line("COMMAND LIST:", tree.header.after);
    blank_line();
    std::size_t label_columns = 2;  // so that most missions are written alike
    for (const LabelledStep& s : tree.steps) {
      label_columns = std::max(label_columns, std::min(s.label.text.size(), kMaxLabelColumns));
    }
    for (const LabelledStep& s : tree.steps) step(s, label_columns);
    below(tree);
    return std::move(out_);
  }

 private:
  std::string typed(const Tree& tree) {
    above(tree.header, "");
    // A comment behind the header would swallow the first command.
    if (!tree.header.after.empty()) line(tree.header.after, "");
    std::string begin = "IMMEDIATE COMMAND: ";
    for (const Statement& s : tree.typed) {
      above(s.comments, "", false);
      line(begin + std::visit(StatementPrinter{}, s.what) + (&s == &tree.typed.back() ? "" : " AND"),
           s.comments.after);
      begin = "    ";
    }
    below(tree);
    return std::move(out_);
  }

  void step(const LabelledStep& step, std::size_t label_columns) {
    above(step.comments, "  ");
    const std::string label = fmt::format(" {:>{}}. ", step.label.text, label_columns);
    const std::string indent(label.size(), ' ');
    for (const Statement& command : step.commands) {
      const bool is_first = &command == &step.commands.front();
      if (!is_first) above(command.comments, indent, false);
      line((is_first ? label : indent) + folded(command, indent + "    ") +
               (&command == &step.commands.back() ? "" : " AND"),
           command.comments.after);
    }
  }

  // Many places take several lines.
  static std::string folded(const Statement& command, const std::string& indent) {
    const auto* action = std::get_if<statement::UnitAction>(&command.what);
    if (action == nullptr) return std::visit(StatementPrinter{}, command.what);
    std::string out;
    std::size_t columns = indent.size();
    for (const std::string& piece : pieces_of(*action)) {
      if (out.empty() || columns + piece.size() < kMaxColumns) {
        columns += piece.size() + 1;
        out += out.empty() ? piece : " " + piece;
      } else {
        columns = indent.size() + piece.size();
        out += "\n" + indent + piece;
      }
    }
    return out;
  }

  void line(const std::string& text, const std::string& comment) {
    out_ += text;
    if (!comment.empty()) out_ += "  " + comment;
    out_ += '\n';
  }

  // One blank line, but none at the top and never two.
  void blank_line() {
    if (!out_.empty() && !out_.ends_with("\n\n")) out_ += '\n';
  }

  void above(const Comments& comments, const std::string& indent, bool keeps_blank_lines = true) {
    for (const std::string& comment : comments.above) {
      if (!comment.empty()) line(indent + comment, "");
      if (comment.empty() && keeps_blank_lines) blank_line();
    }
  }

  void below(const Tree& tree) {
    for (const std::string& comment : tree.comments_below) {
      if (comment.empty()) {
        blank_line();
      } else {
        line(comment, "");
      }
    }
    while (out_.ends_with("\n\n")) out_.pop_back();
  }

  std::string out_;
};

}  // namespace

std::string print(const Statement& statement) {
  return std::visit(StatementPrinter{}, statement.what);
}

std::string print(const Tree& tree) {
  return Printer().mission(tree);
}

}  // namespace mlab::mdl
