// What is drawn is seen running: the configuration goes to a session as a mission that nobody wrote.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/session/parts.h"
#include "mlab/designer/trial/trial.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kMostRobots = 1000;
constexpr std::string_view kExamplesPrefix = "examples:";

std::string field_name(const std::string& configuration) {
  return fs::path(configuration).stem().string() + ".trial";
}

geom::Point first_of(const overlay::Overlay& map, std::initializer_list<overlay::MeasureKind> kinds) {
  for (const overlay::MeasureKind kind : kinds) {
    const auto found = std::ranges::find(map.measures, kind, &overlay::ControlMeasure::kind);
    if (found != map.measures.end()) return found->center();
  }
  const overlay::Area area = map.mission_area();
  return {area.width / 2.0, area.height / 2.0};
}

bool is_same_file(const std::string& a, const std::string& b) {
  return fs::path(a).lexically_normal() == fs::path(b).lexically_normal();
}

bool is_point(const console::Point& point) {
  return std::abs(point.x()) < 1e7 && std::abs(point.y()) < 1e7;  // no NaN either
}

}  // namespace

std::shared_ptr<const Model> Designer::Parts::model_to_try(const OpenConfiguration& one) {
  if (!one.path.starts_with("library:")) return one.model;
  const fs::path name = fs::path(desk_.project().folder()) / fs::path(one.path).filename();
  return std::make_shared<const Model>(
      std::make_shared<const text::Source>(name.string(), std::string(one.text.text())), desk_.environment());
}

// Where the mission's text would stand: beside the configuration, so that it means the same files.
console::Trial Designer::Parts::trial_of(const OpenConfiguration& one, const TrialConfiguration& completed,
                                         const std::string& overlay, std::string& file) {
  const bool is_beside = desk_.project().name_of(completed.source->name()) == one.path;
  const std::string folder =
      is_beside ? fs::path(one.path.substr(one.path.rfind(':') + 1)).parent_path().string() : "";
  const std::string prefix = is_beside && one.path.starts_with(kExamplesPrefix) ? "examples:" : "";
  const auto beside = [&](const std::string& name) {
    return prefix + (folder.empty() ? name : folder + '/' + name);
  };
  console::Trial out;
  out.who = "designer";
  const std::string stem = field_name(completed.source->name());
  out.path = beside(stem + ".mdl");
  const fs::path here = fs::path(desk_.project().disk_path(out.path)).parent_path();
  file = fs::path(completed.source->name()).lexically_relative(here).string();
  if (file.empty()) file = completed.source->name();
  if (overlay.empty()) {
    out.overlay_path = beside(stem + ".odl");
    out.overlay_text = kTrialOverlay;
  }
  out.files = desk_.store().snapshot({completed.source});
  return out;
}

text::Result<TrialField> Designer::Parts::field_of(const Try& request, const console::Trial& trial) {
  TrialField out;
  overlay::Overlay map;
  if (request.overlay().empty()) {
    out.overlay = fs::path(trial.overlay_path).filename().string();
    map.area = kTrialArea;
    out.goal = kTrialGoal;
    out.starts = {kTrialStart};
  } else {
    const std::string disk = desk_.project().disk_path(request.overlay());
    if (disk.empty() || !desk_.project().is_file(request.overlay()))
      return std::unexpected(
          text::Diagnostic{text::Severity::kError,
                           "cannot-read",
                           fmt::format("there is no overlay `{}`", text::shown(request.overlay(), 200)),
                           {},
                           {},
                           {},
                           {}});
    const fs::path here = fs::path(desk_.project().disk_path(trial.path)).parent_path();
    out.overlay = fs::path(disk).lexically_relative(here).string();
    const auto asks = std::make_shared<const text::Source>(
        trial.path, fmt::format("OVERLAY \"{}\"\nCOMMAND LIST:\n", out.overlay));
    mdl::LoadOptions options;
    options.files = *trial.files;
    text::Diagnostics unsaid;  // the session says it
    map = mdl::check_map(asks, here.string(), unsaid, options);
    using Kind = overlay::MeasureKind;
    out.goal = first_of(map, {Kind::kObjective, Kind::kPassagePoint, Kind::kAttackPosition});
    out.starts = {first_of(map, {Kind::kStartPoint, Kind::kAssemblyArea})};
  }
  out.origin = {map.origin.x, map.origin.y};
  if (request.starts_size() > 0) out.starts.clear();
  for (const console::Point& start : request.starts()) {
    if (!is_point(start))
      return std::unexpected(text::Diagnostic{
          text::Severity::kError, "no-such-place", "a start place is no point of the map", {}, {}, {}, {}});
    out.starts.push_back({start.x(), start.y()});
  }
  return out;
}

// The problems as they are drawn: the completed text differs from the author's only by what was put in.
void Designer::Parts::add_problems(const text::Diagnostics& problems, const TrialConfiguration& completed,
                                   const OpenConfiguration& one, Answer& out) const {
  const DrawingContext context = desk_.context(one);
  for (text::Diagnostic d : problems.items()) {
    if (d.place.source && is_same_file(d.place.source->name(), completed.source->name())) {
      const auto back = [&](std::uint32_t byte) {
        return place_before_trial(one.model->text(), completed.source->text(), byte);
      };
      d.place = {one.model->source(), {back(d.place.span.begin), back(d.place.span.end)}};
    }
    *out.add_problems() = problem_of(d, *one.model, context);
  }
}

void Designer::Parts::try_out(console::ConnectionId from, std::uint32_t number, const Try& request,
                              Answer& out) {
  const OpenConfiguration* one = desk_.find(request.document());
  const auto refuse = [&](const std::string& why) {
    out.set_ok(false);
    out.set_error(why);
  };
  if (one == nullptr) {
    refuse("the document is not open");
    return;
  }
  if (!settings_.try_out) {
    refuse("this server has no simulator");
    return;
  }
  if (request.count() > kMostRobots) {
    refuse(fmt::format("at most {} robots can be tried", kMostRobots));
    return;
  }
  const std::shared_ptr<const Model> model = model_to_try(*one);
  const TrialWish wish = {request.robot(), static_cast<int>(std::max(1U, request.count()))};
  const text::Result<TrialConfiguration> completed = complete_for_trial(model, desk_.environment(), wish);
  if (!completed) {
    fail(out, completed.error());
    text::Diagnostics said;
    said.report(completed.error());
    out.clear_problems();
    add_problems(said, {model->source(), {}, {}}, *one, out);
    return;
  }
  const auto tried = std::make_shared<Model>(completed->source, desk_.environment());
  tried->check();
  if (tried->problems().has_errors()) {
    refuse("it can't run: it has errors");
    add_problems(tried->problems(), *completed, *one, out);
    return;
  }
  std::string file;
  console::Trial trial = trial_of(*one, *completed, request.overlay(), file);
  const text::Result<TrialField> field = field_of(request, trial);
  if (!field) {
    fail(out, field.error());
    return;
  }
  if (file.contains('"') || field->overlay.contains('"')) {
    refuse("a mission can't name a file with a quote in its name");
    return;
  }
  trial.text = trial_mission(*completed, file, *field);
  trial.execute = request.execute();
  trial.takes_over = request.take_over();
  desk_.store().sync_drafts(now());  // so that it stays known what was executed
  tell_not_kept();
  const LastTrial last = {one->path, tried, *completed, file, trial.path, wish};
  is_deferred_ = true;
  settings_.try_out(
      std::move(trial), [this, inbox = inbox_, from, number, last](const console::TrialResult& result) {
        inbox->post([this, from, number, last, result] { tried_out(from, number, last, result); });
      });
}

void Designer::Parts::tried_out(console::ConnectionId from, std::uint32_t number, const LastTrial& trial,
                                const console::TrialResult& result) {
  FromDesigner message;
  Answer& out = *message.mutable_answer();
  out.set_request(number);
  out.set_ok(result.error.empty());
  out.set_error(result.error);
  if (const OpenConfiguration* one = desk_.find(trial.document))
    add_problems(result.problems, trial.configuration, *one, out);
  if (result.error.empty()) {
    last_trial_ = trial;
    move_marks();
    Trial& told = *out.mutable_trial();
    told.set_mission(trial.mission);
    for (const auto& [robot, count] : trial.configuration.robots) told.add_robots(robot);
    for (const std::string& note : trial.configuration.notes) told.add_notes(note);
    told.set_taken_over(result.taken_over);
  }
  if (number != 0 && clients_.contains(from)) send(from, message);
}

}  // namespace mlab::designer
