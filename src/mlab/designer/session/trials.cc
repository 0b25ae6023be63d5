#include "mlab/designer/session/trials.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/trial/live_paths.h"
#include "mlab/designer/trial/write_back.h"
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

text::Diagnostic not_live(std::string message) {
  return {text::Severity::kError, "not-live", std::move(message), {}, {}, {}, {}};
}

std::shared_ptr<const Model> Trials::model_to_try(const OpenConfiguration& document) {
  if (!document.path.starts_with("library:")) return document.model;
  const fs::path name = fs::path(desk_.project().folder()) / fs::path(document.path).filename();
  return std::make_shared<const Model>(
      std::make_shared<const text::Source>(name.string(), std::string(document.text.text())),
      desk_.environment());
}

// Where the mission's text would stand: beside the configuration, so that it means the same files.
console::Trial Trials::trial_of(const OpenConfiguration& document, const TrialConfiguration& completed,
                                const std::string& overlay, std::string& file) {
  const bool is_beside = desk_.project().name_of(completed.source->name()) == document.path;
  const std::string folder =
      is_beside ? fs::path(document.path.substr(document.path.rfind(':') + 1)).parent_path().string() : "";
  const std::string prefix = is_beside && document.path.starts_with(kExamplesPrefix) ? "examples:" : "";
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

text::Result<TrialField> Trials::field_of(const Try& request, const console::Trial& trial) {
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
void Trials::add_problems(const text::Diagnostics& problems, const TrialConfiguration& completed,
                          const OpenConfiguration& document, Answer& out) const {
  const DrawingContext context = desk_.context(document);
  for (text::Diagnostic d : problems.items()) {
    if (d.place.source && is_same_file(d.place.source->name(), completed.source->name())) {
      const auto back = [&](std::uint32_t byte) {
        return place_before_trial(document.model->text(), completed.source->text(), byte);
      };
      d.place = {document.model->source(), {back(d.place.span.begin), back(d.place.span.end)}};
    }
    *out.add_problems() = problem_of(d, *document.model, context);
  }
}

Answered Trials::try_out(const Sender& sender, const Try& request, Answer& out) {
  const OpenConfiguration* document = desk_.find(request.document());
  if (document == nullptr) {
    refuse(out, "the document is not open");
  } else if (!try_out_) {
    refuse(out, "this server has no simulator");
  } else if (request.count() > kMostRobots) {
    refuse(out, fmt::format("at most {} robots can be tried", kMostRobots));
  } else if (std::optional<Ready> ready = prepare(*document, request, out)) {
    before_execute_();
    try_out_(std::move(ready->trial), [this, inbox = inbox_, asker = sender.asker,
                                       ready = std::move(ready->tried)](const console::TrialResult& result) {
      inbox->post([this, asker, ready, result] { finish(asker, ready, result); });
    });
    return Answered::kLater;
  }
  return Answered::kNow;
}

std::optional<Trials::Ready> Trials::prepare(const OpenConfiguration& document, const Try& request,
                                             Answer& out) {
  const std::shared_ptr<const Model> model = model_to_try(document);
  const TrialWish wish = {request.robot(), static_cast<int>(std::max(1U, request.count()))};
  const text::Result<TrialConfiguration> completed = complete_for_trial(model, desk_.environment(), wish);
  if (!completed) {
    fail(out, completed.error());
    text::Diagnostics problems;
    problems.report(completed.error());
    out.clear_problems();
    add_problems(problems, {model->source(), {}, {}}, document, out);
    return std::nullopt;
  }
  const auto tried = std::make_shared<Model>(completed->source, desk_.environment());
  tried->check();
  if (tried->problems().has_errors()) {
    refuse(out, "it can't run: it has errors");
    add_problems(tried->problems(), *completed, document, out);
    return std::nullopt;
  }
  std::string file;
  console::Trial trial = trial_of(document, *completed, request.overlay(), file);
  const text::Result<TrialField> field = field_of(request, trial);
  if (!field) {
    fail(out, field.error());
    return std::nullopt;
  }
  if (file.contains('"') || field->overlay.contains('"')) {
    refuse(out, "a mission can't name a file with a quote in its name");
    return std::nullopt;
  }
  trial.text = trial_mission(*completed, file, *field);
  trial.execute = request.execute();
  trial.takes_over = request.take_over();
  Last last = {document.path, tried, *completed, file, trial.path, wish};
  return Ready{std::move(trial), std::move(last)};
}

void Trials::finish(const Asker& asker, const Last& trial, const console::TrialResult& result) {
  Answer out = answer_for(asker);
  if (!result.error.empty()) refuse(out, result.error);
  if (const OpenConfiguration* document = desk_.find(trial.document))
    add_problems(result.problems, trial.configuration, *document, out);
  if (result.error.empty()) {
    last_ = trial;
    ++number_;
    Trial& told = *out.mutable_trial();
    told.set_mission(trial.mission);
    for (const auto& [robot, count] : trial.configuration.robots) told.add_robots(robot);
    for (const std::string& note : trial.configuration.notes) told.add_notes(note);
    told.set_taken_over(result.taken_over);
  }
  answers_.add(asker, std::move(out));
}

const Trials::Last* Trials::last(const std::string& document) const {
  return last_.model && last_.document == document ? &last_ : nullptr;
}

void Trials::rename(const std::string& from, const std::string& to) {
  if (last_.document == from) last_.document = to;
}

void Trials::find_live(const FindLive& request, Answer& out) {
  const OpenConfiguration* document = opened(desk_, request.document(), out);
  if (document == nullptr) return;
  LivePaths& live = *out.mutable_live();
  if (request.is_planned()) {
    const text::Result<Planned> planned = plan(*document, request.page());
    if (!planned)
      fail(out, planned.error());
    else
      live.add_places()->set_path(planned->place);
    return;
  }
  if (!last_.model) {
    add_others(request, *document, live);
    return;
  }
  const bool was_tried = last_.document == document->path;
  const std::string& source = (was_tried ? last_.model : document->model)->source()->name();
  // A library's page is declared by the library, whichever document is tried.
  for (const auto& [robot, count] : last_.configuration.robots) {
    const std::string program = last_.file + '#' + robot;
    for (const std::string& path : live_paths(*last_.model, robot, source, request.page())) {
      LivePaths::At& at = *live.add_places();
      at.set_program(program);
      at.set_path(path);
    }
  }
}

// Robots of a mission's own, or of a recording, that this text declares, as far as a name tells: a mission
// names the file, and the robot where there are several.
void Trials::add_others(const FindLive& request, const OpenConfiguration& document, LivePaths& out) {
  const std::string file = fs::path(document.path).filename().string();
  const auto& robots = document.model->configuration().own_robots;
  for (const std::string& program : request.programs()) {
    const std::size_t hash = program.find('#');
    if (fs::path(program.substr(0, hash)).filename() != file) continue;
    if (hash == std::string::npos && robots.size() != 1) continue;
    for (const cdl::Robot* robot : robots) {
      const std::string& name = robot->name.text;
      if (hash != std::string::npos && program.substr(hash + 1) != name) continue;
      for (const std::string& path :
           live_paths(*document.model, name, document.model->source()->name(), request.page())) {
        LivePaths::At& at = *out.add_places();
        at.set_program(program);
        at.set_path(path);
      }
    }
  }
}

// As it runs, but of the text as it is now; where it was not tried, as it would.
text::Result<TrialConfiguration> Trials::as_it_is_tried(const OpenConfiguration& document) {
  const std::shared_ptr<const Model> model = model_to_try(document);
  const bool was_tried = last_.document == document.path;
  if (was_tried) return complete_for_trial(model, desk_.environment(), last_.wish);
  return complete_for_trial(model, desk_.environment(), {});
}

void Trials::write_back(const WriteBack& request, Answer& out) {
  OpenConfiguration* document = editable(desk_, request.document(), out);
  if (document == nullptr) return;
  if (document->is_outdated()) {
    fail(out, not_live("the text has a slip of grammar: mend it first"));
    return;
  }
  const text::Result<TrialConfiguration> tried = as_it_is_tried(*document);
  if (!tried) {
    fail(out, tried.error());
    return;
  }
  text::Result<Edited> done =
      written_back(document->model, desk_.environment(), *tried, request.port(), request.value());
  if (!done) {
    fail(out, done.error());
    return;
  }
  desk_.store().change(*document, done->text, std::move(done->name), wall_time(), false);
}

// As it is tried; where no robot uses the page then, by itself.
text::Result<Trials::Planned> Trials::plan(const OpenConfiguration& document, const std::string& page,
                                           std::uint32_t robot) {
  const std::shared_ptr<const Model> author = model_to_try(document);
  std::string why;
  for (const TrialWish& wish : {last_.document == document.path ? last_.wish : TrialWish{},
                                TrialWish{std::string(owner_of(page)), 1}}) {
    text::Result<TrialConfiguration> completed = complete_for_trial(author, desk_.environment(), wish);
    if (!completed) {
      why = completed.error().message;
      continue;
    }
    const auto model = std::make_shared<const Model>(completed->source, desk_.environment());
    std::uint32_t id = 1;
    for (const auto& [name, count] : completed->robots) {
      const bool is_wanted = robot == 0 || (robot >= id && robot < id + static_cast<std::uint32_t>(count));
      id += static_cast<std::uint32_t>(count);
      if (!is_wanted) continue;
      const std::vector<std::string> places = live_paths(*model, name, author->source()->name(), page);
      if (!places.empty()) return Planned{*completed, model, name, places.front()};
    }
  }
  return std::unexpected(not_live(why.empty() ? "no robot that runs uses this page" : why));
}

}  // namespace mlab::designer
