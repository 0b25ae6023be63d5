#include "mlab/designer/trial/trial.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/core.h>

#include "mlab/designer/edit/edit.h"
#include "mlab/flow/value_types.h"
#include "mlab/lang/cdl/lower/lower.h"

namespace mlab::designer {

const char* const kTrialOverlay =
    R"(-- A field for trying things out: some obstacles, objects to fetch, and a basket to bring them to. As large as the ranges
-- and distances that the library assumes.

SCENARIO "Trial"
SITE Field
MISSION-AREA 160 120

CONTROL MEASURES:

AA Start 80 48 4
PP Goal 136 96 4
BASKET 80 64 1.5

ATTRACTOR  66  40
ATTRACTOR  94  54
ATTRACTOR  56  28
ATTRACTOR  36 100
ATTRACTOR 104 104
ATTRACTOR 120  24
ATTRACTOR 144  56
ATTRACTOR  16  16

OBSTACLE  58 56 3
OBSTACLE 104 46 3
OBSTACLE  96 80 4
OBSTACLE  66 76 2
OBSTACLE 124 76 3
OBSTACLE  40 34 4
OBSTACLE  30 88 4
OBSTACLE 138 32 3
)";

namespace {

constexpr double kStartsApart = 1.5;  // robots that no place was said for [m]

// A body that can all that the library's binding points ask for. It knows of obstacles as far as it is asked,
// not only as far as its ring of range sensors reaches.
constexpr const char* kTrialBody = R"(class {} {{
  body {{
    radius = 0.25 m;
    drive = holonomic;
    ring_count = 36;
    ring_range = 8 m;
  }}
  sensor location: GetPose() binds sense_location;
  sensor eyes: DetectObstacles() binds sense_obstacles;
  sensor scanner: DetectRanges() binds sense_ranges;
  sensor radio: DetectRobots() binds sense_robots;
  sensor camera: DetectObjects() binds sense_objects;
  sensor choice: ClosestObject() binds choose_target;
  actuator base: DriveAndSpin(base_velocity = 2 m/s, max_velocity = 3 m/s, cautious_velocity = 0.2 m/s) binds movement;
  actuator camera_mount: PanTilt() binds pantilt;
}}
)";

std::unexpected<text::Diagnostic> not_tried(std::string message) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, "cannot-try", std::move(message), {}, {}, {}, {}});
}

bool is_taken(const Model& model, std::string_view name) {
  const cdl::Configuration& all = model.configuration();
  return all.assemblages.contains(name) || all.robots.contains(name) || all.classes.contains(name) ||
         all.societies.contains(name) || all.operators.contains(name) || all.bindings.contains(name);
}

std::string free_name(const Model& model, const std::string& wanted) {
  std::string out = wanted;
  for (int n = 2; is_taken(model, out); ++n) out = fmt::format("{}{}", wanted, n);
  return out;
}

text::SourcePtr with(const Model& model, const std::string& added) {
  std::string text(model.text());
  if (!text.empty() && !text.ends_with('\n')) text += '\n';
  return std::make_shared<const text::Source>(model.source()->name(), text + added);
}

struct TrialSubject {
  const cdl::Society* society = nullptr;
  const cdl::Robot* robot = nullptr;
  const cdl::Assemblage* assemblage = nullptr;
};

template <class Kind>
const Kind* only(const std::vector<const Kind*>& all) {
  return all.size() == 1 ? all.front() : nullptr;
}

text::Result<TrialSubject> meant(const Model& model, const std::string& wanted) {
  const cdl::Configuration& all = model.configuration();
  TrialSubject out;
  if (!wanted.empty()) {
    const auto find = [&](const auto& table) {
      const auto found = table.find(wanted);
      return found == table.end() ? nullptr : found->second;
    };
    out = {find(all.societies), find(all.robots), find(all.assemblages)};
  } else if (!all.own_societies.empty()) {
    out.society = only(all.own_societies);
  } else if (!all.own_robots.empty()) {
    out.robot = only(all.own_robots);
  } else {
    out.assemblage = only(all.own_assemblages);
  }
  if (out.society != nullptr || out.robot != nullptr || out.assemblage != nullptr) return out;
  if (!wanted.empty()) return not_tried(fmt::format("there is no assemblage, robot or society `{}`", wanted));
  const bool is_empty = all.own_assemblages.empty() && all.own_robots.empty() && all.own_societies.empty();
  return not_tried(is_empty ? "there is nothing to run yet: make an assemblage first"
                            : "several things could run: open the one that you mean");
}

// `Wander(goal = ...)` with something for each parameter that has to be given.
text::Result<std::string> call_of(const cdl::Assemblage& assemblage, std::vector<std::string>& notes) {
  std::string arguments;
  for (const cdl::Parameter& parameter : assemblage.parameters) {
    if (parameter.initial) continue;
    const std::string value = stand_in(parameter);
    if (value.empty()) {
      text::Diagnostic out = not_tried(fmt::format("nothing can be assumed for the parameter `{}` of `{}`",
                                                   parameter.name.text, assemblage.name.text))
                                 .error();
      out.place = parameter.name.place;
      out.hints.emplace_back("give it a default, or make a robot that says its value");
      return std::unexpected(std::move(out));
    }
    arguments += fmt::format("{}{} = {}", arguments.empty() ? "" : ", ", parameter.name.text, value);
    notes.push_back(
        fmt::format("the parameter `{}` has no default: `{}` is assumed", parameter.name.text, value));
  }
  return fmt::format("{}({})", assemblage.name.text, arguments);
}

// A body for the robots of this text that have none: the first that serves all that they ask for. Own classes
// come after the standard body, since what is tried is to move at least.
class Bodies {
 public:
  Bodies(const Model& model, const cdl::Environment& environment)
      : model_(model), environment_(environment), standard_(free_name(model, "TrialBody")) {}

  /// @param make  the text with a class given
  text::Result<text::SourcePtr> first_that_fits(
      const std::function<text::Result<text::SourcePtr>(const std::string& class_name,
                                                        const std::string& declared)>& make,
      const std::string& robot, std::vector<std::string>& notes) const {
    text::Result<text::SourcePtr> standard = make(standard_, fmt::format(kTrialBody, standard_));
    if (!standard || serves(*standard, robot)) {
      notes.emplace_back("a standard body is assumed: it moves to all sides and senses everything around");
      return standard;
    }
    for (const cdl::RobotClass* own : model_.configuration().own_classes) {
      text::Result<text::SourcePtr> made = make(own->name.text, "");
      if (!made || !serves(*made, robot)) continue;
      notes.push_back(fmt::format("a robot of class `{}` is assumed", own->name.text));
      return made;
    }
    return standard;  // and what is wrong will be said of it
  }

 private:
  bool serves(const text::SourcePtr& source, const std::string& name) const {
    const Model tried(source, environment_);
    const auto robot = tried.configuration().robots.find(name);
    if (tried.problems().has_errors() || robot == tried.configuration().robots.end()) return false;
    text::Diagnostics sink;
    cdl::EarlierFindings said;
    cdl::lower(tried.configuration(), *robot->second, tried.library(), sink, said);
    return !sink.has_errors();
  }

  const Model& model_;
  const cdl::Environment& environment_;
  std::string standard_;
};

text::Result<TrialConfiguration> of_assemblage(const Model& model, const cdl::Environment& environment,
                                               const cdl::Assemblage& assemblage, int count) {
  TrialConfiguration out;
  const text::Result<std::string> call = call_of(assemblage, out.notes);
  if (!call) return std::unexpected(call.error());
  const std::string robot = free_name(model, "Trial" + assemblage.name.text);
  const auto make = [&](const std::string& class_name,
                        const std::string& declared) -> text::Result<text::SourcePtr> {
    return with(model,
                declared + fmt::format("robot {} is {} {{ movement = {}; }}\n", robot, class_name, *call));
  };
  text::Result<text::SourcePtr> made = Bodies(model, environment).first_that_fits(make, robot, out.notes);
  if (!made) return std::unexpected(made.error());
  out.source = std::move(*made);
  out.robots = {{robot, count}};
  return out;
}

// The text with a class for a robot of it that has none.
text::Result<text::SourcePtr> classed(const Model& model, const cdl::Environment& environment,
                                      const cdl::Robot& robot, std::vector<std::string>& notes) {
  const auto make = [&](const std::string& class_name,
                        const std::string& declared) -> text::Result<text::SourcePtr> {
    const auto longer = std::make_shared<const Model>(with(model, declared), environment);
    Edit edit;
    SetClass& set = *edit.add_changes()->mutable_set_class();
    set.set_robot(robot.name.text);
    set.set_class_name(class_name);
    text::Result<Edited> done = edited(longer, environment, edit);
    if (!done) return std::unexpected(done.error());
    return std::make_shared<const text::Source>(model.source()->name(), std::move(done->text));
  };
  return Bodies(model, environment).first_that_fits(make, robot.name.text, notes);
}

text::Result<TrialConfiguration> of_robots(const std::shared_ptr<const Model>& model,
                                           const cdl::Environment& environment,
                                           std::vector<std::pair<std::string, int>> robots) {
  TrialConfiguration out;
  out.source = model->source();
  out.robots = std::move(robots);
  std::shared_ptr<const Model> now = model;
  for (const auto& [name, count] : out.robots) {
    const cdl::Robot* robot = now->robot(name);
    if (robot == nullptr || !robot->class_name.text.empty()) continue;
    text::Result<text::SourcePtr> made = classed(*now, environment, *robot, out.notes);
    if (!made) return std::unexpected(made.error());
    out.source = *made;
    now = std::make_shared<const Model>(out.source, environment);
  }
  return out;
}

// A name for a robot type that MDL knows by no other meaning.
std::string type_name(const std::string& robot, std::set<std::string>& taken) {
  const auto lower = [](std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
  };
  std::string out = robot;
  for (int n = 2; !taken.insert(lower(out)).second; ++n) out = fmt::format("{}-{}", robot, n);
  return out;
}

}  // namespace

std::string stand_in(const cdl::Parameter& parameter) {
  const std::string& type = parameter.type.text;
  if (const flow::QuantityInfo* quantity = flow::quantity_named(type)) return std::string(quantity->sample);
  const flow::ValueTypeInfo* const known = flow::value_type_named(type);
  const bool is_number =
      known != nullptr && (known->kind == flow::TypeKind::kReal || known->kind == flow::TypeKind::kInteger);
  if (!is_number) return std::string(known == nullptr ? "" : known->sample);
  const std::string unit = parameter.unit.text.empty() ? "" : " " + parameter.unit.text;
  if (!parameter.low && !parameter.high) return std::string(known->sample) + unit;
  const cdl::Number& bound = parameter.low ? *parameter.low : *parameter.high;
  return fmt::format("{}{}", bound.value, bound.unit.text.empty() ? unit : " " + bound.unit.text);
}

text::Result<TrialConfiguration> complete_for_trial(const std::shared_ptr<const Model>& model,
                                                    const cdl::Environment& environment,
                                                    const TrialWish& wish) {
  const text::Result<TrialSubject> what = meant(*model, wish.declaration);
  if (!what) return std::unexpected(what.error());
  if (what->society != nullptr) {
    constexpr int kMost = 1000;
    const auto all = cdl::members_of(model->configuration(), *what->society);
    if (!all)
      return not_tried(fmt::format("the society `{}` has more than {} robots: from 1 to {} can be tried",
                                   what->society->name.text, cdl::kMostRobotsOfASociety, kMost));
    std::vector<std::pair<std::string, int>> robots;
    int count = 0;
    for (const auto& [robot, members] : *all) {
      robots.emplace_back(robot->name.text, members);
      count += members;
    }
    if (count == 0 || count > kMost)
      return not_tried(fmt::format("the society `{}` has {} robots: from 1 to {} can be tried",
                                   what->society->name.text, count, kMost));
    return of_robots(model, environment, std::move(robots));
  }
  if (what->robot != nullptr) return of_robots(model, environment, {{what->robot->name.text, wish.count}});
  return of_assemblage(*model, environment, *what->assemblage, wish.count);
}

std::uint32_t place_before_trial(std::string_view author, std::string_view completed, std::uint32_t byte) {
  const auto [left, right] = std::ranges::mismatch(author, completed);
  const auto same = static_cast<std::uint32_t>(left - author.begin());
  if (byte < same || author == completed) return byte;
  const auto size = static_cast<std::uint32_t>(author.size());
  if (same == size) return size;
  // Something was put in at `same`; it ends where the author's next words go on.
  const std::string_view rest = author.substr(same);
  const std::size_t goes_on = completed.find(rest, same);
  if (goes_on == std::string_view::npos) return same;
  const auto begin = static_cast<std::uint32_t>(goes_on);
  return byte < begin ? same : std::min(size, byte - begin + same);
}

std::string trial_mission(const TrialConfiguration& configuration, const std::string& file,
                          const TrialField& field) {
  std::set<std::string> taken = {"robot"};
  std::string types;
  std::string units;
  std::string starts;
  std::size_t number = 0;
  for (const auto& [robot, count] : configuration.robots) {
    const std::string type = type_name(robot, taken);
    types += fmt::format("NEW-ROBOT \"{}\" \"{}#{}\"\n", type, file, robot);
    for (int i = 0; i < count; ++i, ++number) {
      geom::Point at = field.starts[std::min(number, field.starts.size() - 1)];
      if (number >= field.starts.size())
        at.x += kStartsApart * static_cast<double>(number - field.starts.size() + 1);
      units += fmt::format(" (<r{}> \"{}\")", number + 1, type);
      starts += fmt::format("{}UNIT r{} START {:.3f} {:.3f}", number == 0 ? "" : " AND\n     ", number + 1,
                            at.x - field.origin.x, at.y - field.origin.y);
    }
  }
  return fmt::format(
      "-- Made to try a configuration out.\n"
      "MISSION NAME \"Trial\"\n"
      "OVERLAY \"{}\"\n\n{}"
      "UNIT <all>{}\n\n"
      "COMMAND LIST:\n\n"
      "  0. {}\n"
      "  1. UNIT all MOVETO {:.3f} {:.3f}\n",
      field.overlay, types, units, starts, field.goal.x - field.origin.x, field.goal.y - field.origin.y);
}

}  // namespace mlab::designer
