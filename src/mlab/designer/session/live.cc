// What is asked while robots run: where a page runs, what they would do elsewhere, and values for the text.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/session/parts.h"
#include "mlab/designer/trial/live_paths.h"
#include "mlab/designer/trial/movement_field.h"
#include "mlab/designer/trial/write_back.h"
#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/robot/program/brought_code.h"
#include "mlab/run/crew.h"
#include "mlab/simulated/run.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

constexpr std::uint32_t kMostPlaces = 100;  // of a field, to each side
constexpr double kFarthestEdge = 1e7;       // of a field [m]

std::unexpected<text::Diagnostic> not_known(std::string message) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, "not-live", std::move(message), {}, {}, {}, {}});
}

text::Result<FieldGrid> grid_of(const ReadField& request) {
  const console::Box& box = request.area();
  const FieldGrid out{box.x_min(),
                      box.y_min(),
                      box.x_max(),
                      box.y_max(),
                      std::clamp(request.columns(), 1U, kMostPlaces),
                      std::clamp(request.rows(), 1U, kMostPlaces),
                      request.heading()};
  for (const double edge : {out.x_min, out.y_min, out.x_max, out.y_max}) {
    if (!(std::abs(edge) <= kFarthestEdge)) return not_known("the field's area is no part of the map");
  }
  if (!std::isfinite(out.heading)) return not_known("the heading is no number");
  return out;
}

// The one of the trial's run that is meant (0: the first that runs); null: there is none.
const fleet::FleetRobot* body_in(const run::MissionRun* run, std::uint32_t robot,
                                 const std::string& mission) {
  const bool is_of_trial =
      run != nullptr && run->mission().source && run->mission().source->name() == mission;
  if (!is_of_trial) return nullptr;
  for (const fleet::FleetRobot& one : run->fleet().robots()) {
    const bool is_it = robot == 0 || one.id.value == robot;
    if (is_it && one.life == fleet::RobotLife::kRunning) return &one;
  }
  return nullptr;
}

// What the trial has added is in no text that somebody could change.
std::optional<std::vector<Hop>> own_way(const Model& trial, const std::string& robot, const std::string& page,
                                        const std::string& place, const OpenConfiguration& one) {
  std::optional<std::vector<Hop>> way = way_to(trial, robot, page, place);
  if (!way) return way;
  for (Hop& hop : *way) {
    if (one.drawn->page(hop.page).graph == nullptr) hop.page.clear();
  }
  return way;
}

using LookAtRun = std::function<void(console::RunLook look)>;

// On the session's thread, a few milliseconds at a time: robots go on meanwhile.
void read_in_pieces(const LookAtRun& look_at_run, const std::shared_ptr<FieldReading>& reading,
                    std::uint32_t robot, const std::string& mission, std::function<void(bool)> done) {
  constexpr double kPiece = 0.003;  // [s]
  look_at_run([=, done = std::move(done)](const run::MissionRun* run) {
    const fleet::FleetRobot* body = body_in(run, robot, mission);
    const bool is_whole = body != nullptr && reading->read(*run, *body, kPiece);
    if (body == nullptr || is_whole)
      done(is_whole);
    else
      read_in_pieces(look_at_run, reading, robot, mission, done);
  });
}

}  // namespace

void Designer::Parts::find_live(const FindLive& request, Answer& out) {
  const OpenConfiguration* one = opened(request.document(), out);
  if (one == nullptr) return;
  LivePaths& live = *out.mutable_live();
  if (request.is_planned()) {
    const text::Result<Planned> planned = plan(*one, request.page());
    if (!planned)
      fail(out, planned.error());
    else
      live.add_places()->set_path(planned->place);
    return;
  }
  if (!last_trial_.model) return;
  const bool was_tried = last_trial_.document == one->path;
  const std::string& source = (was_tried ? last_trial_.model : one->model)->source()->name();
  // A library's page is declared by the library, whichever document is tried.
  for (const auto& [robot, count] : last_trial_.configuration.robots) {
    const std::string program = last_trial_.file + '#' + robot;
    for (const std::string& path : live_paths(*last_trial_.model, robot, source, request.page())) {
      LivePaths::At& at = *live.add_places();
      at.set_program(program);
      at.set_path(path);
    }
  }
}

void Designer::Parts::set_mark(const SetMark& request, Answer& out) {
  constexpr std::size_t kLongest = 4000;  // bytes
  const OpenConfiguration* one = opened(request.document(), out);
  if (one == nullptr) return;
  if (const std::size_t size = request.mark().ByteSizeLong(); size > kLongest) {
    fail(out, not_known(fmt::format("the mark has {} bytes; at most {} are kept", size, kLongest)).error());
    return;
  }
  if (one->drawn->page(request.mark().page()).graph == nullptr) {
    fail(out, not_known(fmt::format("there is no page `{}`", text::shown(request.mark().page()))).error());
    return;
  }
  Marks& marks = marks_[one->path];
  if (marks.size() >= Marks::kMost) {
    fail(out, not_known(fmt::format("there are {} marks, and more are not kept", Marks::kMost)).error());
    return;
  }
  std::optional<std::vector<Hop>> way;
  if (last_trial_.model && last_trial_.document == one->path) {
    for (const auto& [robot, count] : last_trial_.configuration.robots) {
      if (!way) way = own_way(*last_trial_.model, robot, request.mark().page(), request.mark().place(), *one);
    }
  }
  out.set_text(fmt::format("{}", marks.add(request.mark(), one->drawn, std::move(way))));
  keep_marks(one->path, marks);
}

void Designer::Parts::remove_mark(const RemoveMark& request, Answer& out) {
  const auto marks = marks_.find(request.document());
  if (marks == marks_.end() || !marks->second.remove(request.id())) {
    fail(out, not_known("there is no such mark").error());
    return;
  }
  keep_marks(marks->first, marks->second);
}

void Designer::Parts::keep_marks(const std::string& document, const Marks& marks) {
  const std::string why = mark_store_.keep(document, marks);
  if (why.empty())
    unkept_marks_.erase(document);
  else
    unkept_marks_[document] = fmt::format("marks of `{}`: {}", text::shown(document, 200), why);
}

// What could not be kept is tried again, but not all the time.
void Designer::Parts::keep_marks_again() {
  constexpr double kPause = 1.0;  // [s]
  if (unkept_marks_.empty() || now() - marks_tried_ < kPause) return;
  marks_tried_ = now();
  for (const auto& [document, why] : std::map(unkept_marks_)) {
    const auto marks = marks_.find(document);
    if (marks != marks_.end()) keep_marks(document, marks->second);
  }
}

void Designer::Parts::drop_marks(const std::string& document) {
  marks_.erase(document);
  mark_store_.drop(document);
  unkept_marks_.erase(document);
}

void Designer::Parts::move_marks() {
  const auto marks = marks_.find(last_trial_.document);
  const OpenConfiguration* one = desk_.find(last_trial_.document);
  if (marks == marks_.end() || one == nullptr) return;
  marks->second.follow(one->drawn);
  const Model& model = *last_trial_.model;
  const bool is_changed = marks->second.move_to(
      *one->drawn, [&](const std::string& page, const std::string& place) -> std::optional<Marks::Run> {
        std::optional<Marks::Run> first;
        for (const auto& [robot, count] : last_trial_.configuration.robots) {
          for (const std::string& path : live_paths(model, robot, model.source()->name(), page)) {
            std::optional<std::vector<Hop>> way = own_way(model, robot, page, path, *one);
            if (path == place) return Marks::Run{path, std::move(way)};
            if (!first) first = Marks::Run{path, std::move(way)};
          }
        }
        return first;
      });
  if (!is_changed) return;
  keep_marks(marks->first, marks->second);
  publish();
}

void Designer::Parts::restore_marks(const OpenConfiguration& one) {
  if (marks_.contains(one.path)) return;
  std::optional<Marks> kept = mark_store_.find(one.path, desk_.environment());
  if (kept) marks_.emplace(one.path, *std::move(kept));
}

// As it runs, but of the text as it is now; where it was not tried, as it would.
text::Result<TrialConfiguration> Designer::Parts::tried_now(const OpenConfiguration& one) {
  const std::shared_ptr<const Model> model = model_to_try(one);
  const bool was_tried = last_trial_.document == one.path;
  if (was_tried) return complete_for_trial(model, desk_.environment(), last_trial_.wish);
  return complete_for_trial(model, desk_.environment(), {});
}

void Designer::Parts::write_back(const WriteBack& request, Answer& out) {
  OpenConfiguration* one = editable(request.document(), out);
  if (one == nullptr) return;
  if (one->is_outdated()) {
    fail(out, not_known("the text has a slip of grammar: mend it first").error());
    return;
  }
  const text::Result<TrialConfiguration> tried = tried_now(*one);
  if (!tried) {
    fail(out, tried.error());
    return;
  }
  text::Result<Edited> done =
      written_back(one->model, desk_.environment(), *tried, request.port(), request.value());
  if (!done) {
    fail(out, done.error());
    return;
  }
  desk_.store().change(*one, done->text, std::move(done->name), now(), false);
  desk_.changed(*one);
}

// As it is tried; where no robot uses the page then, by itself.
text::Result<Designer::Parts::Planned> Designer::Parts::plan(const OpenConfiguration& one,
                                                             const std::string& page, std::uint32_t robot) {
  const std::shared_ptr<const Model> author = model_to_try(one);
  std::string why;
  for (const TrialWish& wish : {last_trial_.document == one.path ? last_trial_.wish : TrialWish{},
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
  return not_known(why.empty() ? "no robot that runs uses this page" : why);
}

// Of the node of the page, or of its result.
text::Result<Designer::Parts::Planned> Designer::Parts::field_node(const OpenConfiguration& one,
                                                                   const ReadField& request) {
  const std::shared_ptr<const Model> author = model_to_try(one);
  const Model::Found found = author->page(request.page());
  if (found.graph == nullptr)
    return not_known(fmt::format("there is no page `{}`", text::shown(request.page())));
  const GraphPage& page = found.graph->pages[static_cast<std::size_t>(found.page)];
  const int at = request.node().empty() ? page.result : page.find(request.node());
  if (at < 0 && !(request.node().empty() && page.sequence != nullptr))
    return not_known(request.node().empty()
                         ? "the page gives no movement yet"
                         : fmt::format("there is no node `{}`", text::shown(request.node())));
  const std::string below = at < 0 ? page.base : page.nodes[static_cast<std::size_t>(at)].path;
  text::Result<Planned> planned = plan(one, std::string(owner_of(request.page())), request.robot());
  if (planned) planned->place = joined_path(planned->place, below);
  return planned;
}

text::Result<FieldProgram> Designer::Parts::program_of_field(const Planned& what) const {
  text::Diagnostics sink;
  robot::ProgramSources sources;
  sources.permission = settings_.permission;
  sources.folder = std::filesystem::path(what.completed.source->name()).parent_path().string();
  sources.include_root = settings_.include_root;
  sources.version = settings_.version;
  sources.limits = settings_.limits;
  sources.ends = jobs_end_.get_token();
  const auto& procedures = what.model->configuration().procedures;
  auto library = robot::describe_library(procedures);
  const auto robot = what.model->configuration().robots.find(what.robot);
  if (robot == what.model->configuration().robots.end() || what.model->problems().has_errors())
    return not_known("the text has errors: mend them first");
  cdl::Said said;
  cdl::LoweredRobot lowered =
      cdl::lower(what.model->configuration(), *robot->second, library->library, sink, said);
  if (sink.has_errors()) return not_known(sink.items().front().message);
  text::Result<FieldProgram> part = field_program(std::move(lowered.network), library->library, what.place);
  if (!part) return part;
  auto runnable =
      robot::make_runnable(part->program, part->network, procedures, std::move(library), {}, sources, sink);
  if (!runnable || runnable->is_described_only)
    return not_known(sink.items().empty() ? "its procedures may not run" : sink.items().front().message);
  part->program = std::move(runnable->program);
  part->hosted = std::move(runnable->hosted);
  return part;
}

// A run of its own, which nobody sees: the robots stand where a trial would start them.
text::Result<std::string> Designer::Parts::field_alone(const OpenConfiguration& one, const Planned& what,
                                                       const FieldProgram& part, const FieldGrid& grid) {
  std::string file;
  TrialConfiguration single = what.completed;
  single.robots = {{what.robot, 1}};
  console::Trial trial = trial_of(one, single, "", file);
  const text::Result<TrialField> field = field_of(Try(), trial);
  if (!field) return std::unexpected(field.error());
  const std::string name = desk_.project().disk_path(trial.path);
  const std::string folder = std::filesystem::path(name).parent_path().string();
  const std::string overlay = desk_.project().disk_path(trial.overlay_path);
  mdl::LoadOptions options;
  options.files.is_file = [&](const std::string& path) {
    return path == overlay || trial.files->is_file(path);
  };
  options.files.read = [&](const std::string& path) -> text::Result<text::SourcePtr> {
    if (path == overlay) return std::make_shared<const text::Source>(path, trial.overlay_text);
    return trial.files->read(path);
  };
  text::Diagnostics sink;
  const auto mission = mdl::check_mission(
      std::make_shared<const text::Source>(name, trial_mission(single, file, *field)), folder, sink, options);
  robot::ProgramSources sources = {settings_.permission, folder, settings_.include_root, settings_.version,
                                   trial.files.get()};
  sources.limits = settings_.limits;
  sources.ends = jobs_end_.get_token();
  const auto crew = mission == nullptr ? nullptr : run::make_crew(mission, sources, sink);
  if (!crew) return not_known(sink.items().empty() ? "it can't run" : sink.items().front().message);
  const auto simulated = simulated::make_run(crew, {});
  run::MissionRun& run = *simulated;
  run.post(mission::event::Execute{});
  const auto body = [&]() -> const fleet::FleetRobot& { return run.fleet().robots().front(); };
  const auto has_order = [&] {
    return body().life == fleet::RobotLife::kRunning && run.fleet().group(body()) != nullptr;
  };
  for (int i = 0; i < 20 && !has_order(); ++i) run.step();
  if (body().life != fleet::RobotLife::kRunning) return not_known("the robot can't be started");
  return field_arrows(run, body(), false, part, grid);
}

void Designer::Parts::read_field(console::ConnectionId from, std::uint32_t number, const ReadField& request,
                                 Answer& out) {
  const OpenConfiguration* one = opened(request.document(), out);
  if (one == nullptr) return;
  const text::Result<FieldGrid> grid = grid_of(request);
  if (!grid) {
    fail(out, grid.error());
    return;
  }
  const text::Result<Planned> what = field_node(*one, request);
  if (!what) {
    fail(out, what.error());
    return;
  }
  const text::Result<FieldProgram> part = program_of_field(*what);
  if (!part) {
    fail(out, part.error());
    return;
  }
  const bool may_run = settings_.look_at_run && last_trial_.document == one->path;
  if (!may_run) {
    if (request.robot() != 0) {
      fail(out, not_known("that robot does not run").error());
      return;
    }
    const text::Result<std::string> arrows = field_alone(*one, *what, *part, *grid);
    if (!arrows) {
      fail(out, arrows.error());
      return;
    }
    out.mutable_field()->set_arrows(*arrows);
    out.mutable_field()->set_note("a robot that has just started, on the field for trying");
    return;
  }
  is_deferred_ = true;
  const auto reading = std::make_shared<FieldReading>(*part, *grid, request.robot() != 0);
  read_in_pieces(settings_.look_at_run, reading, request.robot(),
                 desk_.project().disk_path(last_trial_.mission),
                 [this, inbox = inbox_, from, request, number, what = *what, part = *part, grid = *grid,
                  reading](bool was_read) {
                   const bool is_read = was_read && reading->problem().empty();
                   const auto arrows = is_read ? std::optional(reading->arrows()) : std::nullopt;
                   const bool is_as_is = reading->is_as_is();
                   inbox->post([this, from, number, request, what, part, grid, arrows, is_as_is] {
                     answer_field(from, number, request, what, part, grid, arrows, is_as_is);
                   });
                 });
}

void Designer::Parts::answer_field(console::ConnectionId from, std::uint32_t number, const ReadField& request,
                                   const Planned& what, const FieldProgram& part, const FieldGrid& grid,
                                   const std::optional<std::string>& arrows, bool is_as_is) {
  FromDesigner message;
  Answer& out = *message.mutable_answer();
  out.set_request(number);
  out.set_ok(true);
  const OpenConfiguration* one = desk_.find(request.document());
  if (arrows) {
    out.mutable_field()->set_arrows(*arrows);
    out.mutable_field()->set_note(is_as_is
                                      ? fmt::format("robot {} with its state as it is now", request.robot())
                                      : "a robot that has just started, among those that run");
  } else if (request.robot() != 0 || one == nullptr) {
    fail(out, not_known("that robot does not run").error());
  } else if (const text::Result<std::string> alone = field_alone(*one, what, part, grid); alone) {
    out.mutable_field()->set_arrows(*alone);
    out.mutable_field()->set_note("a robot that has just started, on the field for trying");
  } else {
    fail(out, alone.error());
  }
  if (number != 0 && clients_.contains(from)) send(from, message);
}

}  // namespace mlab::designer
