#include "mlab/designer/session/fields.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/trial/live_paths.h"
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

std::unexpected<text::Diagnostic> no_field(std::string why) {
  return std::unexpected(not_live(std::move(why)));
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
    if (!(std::abs(edge) <= kFarthestEdge)) return no_field("the field's area is no part of the map");
  }
  if (!std::isfinite(out.heading)) return no_field("the heading is no number");
  return out;
}

// The one of the trial's run that is meant (0: the first that runs); null: there is none.
const fleet::FleetRobot* body_in(const run::MissionRun* run, std::uint32_t robot,
                                 const std::string& mission) {
  const bool is_of_trial =
      run != nullptr && run->mission().source && run->mission().source->name() == mission;
  if (!is_of_trial) return nullptr;
  for (const fleet::FleetRobot& body : run->fleet().robots()) {
    const bool is_meant = robot == 0 || body.id.value == robot;
    if (is_meant && body.life == fleet::RobotLife::kRunning) return &body;
  }
  return nullptr;
}

// On the session's thread, a few milliseconds at a time: robots go on meanwhile.
void read_in_pieces(const Fields::LookAtRun& look_at_run, const std::shared_ptr<FieldReading>& reading,
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

text::Result<Trials::Planned> Fields::node_of(const OpenConfiguration& document, const ReadField& request) {
  const std::shared_ptr<const Model> author = trials_.model_to_try(document);
  const Model::FoundPage found = author->page(request.page());
  if (found.graph == nullptr)
    return no_field(fmt::format("there is no page `{}`", text::shown(request.page())));
  const GraphPage& page = found.graph->pages[static_cast<std::size_t>(found.page)];
  const int at = request.node().empty() ? page.result : page.find(request.node());
  if (at < 0 && !(request.node().empty() && page.sequence != nullptr))
    return no_field(request.node().empty()
                        ? "the page gives no movement yet"
                        : fmt::format("there is no node `{}`", text::shown(request.node())));
  const std::string below = at < 0 ? page.base : page.nodes[static_cast<std::size_t>(at)].path;
  text::Result<Trials::Planned> planned =
      trials_.plan(document, std::string(owner_of(request.page())), request.robot());
  if (planned) planned->place = joined_path(planned->place, below);
  return planned;
}

robot::ProgramSources Fields::programs_in(const std::string& folder) const {
  robot::ProgramSources out = programs_;
  out.folder = folder;
  return out;
}

text::Result<FieldProgram> Fields::program_of(const Trials::Planned& node) const {
  text::Diagnostics sink;
  const robot::ProgramSources sources =
      programs_in(std::filesystem::path(node.completed.source->name()).parent_path().string());
  const auto& procedures = node.model->configuration().procedures;
  auto library = robot::describe_library(procedures);
  const auto robot = node.model->configuration().robots.find(node.robot);
  if (robot == node.model->configuration().robots.end() || node.model->problems().has_errors())
    return no_field("the text has errors: mend them first");
  cdl::EarlierFindings said;
  cdl::LoweredRobot lowered =
      cdl::lower(node.model->configuration(), *robot->second, library->library, sink, said);
  if (sink.has_errors()) return no_field(sink.items().front().message);
  text::Result<FieldProgram> part = field_program(std::move(lowered.network), library->library, node.place);
  if (!part) return part;
  auto runnable =
      robot::make_runnable(part->program, part->network, procedures, std::move(library), {}, sources, sink);
  if (!runnable || runnable->is_described_only)
    return no_field(sink.items().empty() ? "its procedures may not run" : sink.items().front().message);
  part->program = std::move(runnable->program);
  part->hosted = std::move(runnable->hosted);
  return part;
}

text::Result<std::string> Fields::read_alone(const OpenConfiguration& document, const Question& question) {
  std::string file;
  TrialConfiguration single = question.node.completed;
  single.robots = {{question.node.robot, 1}};
  console::Trial trial = trials_.trial_of(document, single, "", file);
  const text::Result<TrialField> field = trials_.field_of(Try(), trial);
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
  robot::ProgramSources sources = programs_in(folder);
  sources.files = trial.files.get();
  const auto crew = mission == nullptr ? nullptr : run::make_crew(mission, sources, sink);
  if (!crew) return no_field(sink.items().empty() ? "it can't run" : sink.items().front().message);
  const auto simulated = simulated::make_run(crew, {});
  run::MissionRun& run = *simulated;
  run.post(mission::event::Execute{});
  const auto body = [&]() -> const fleet::FleetRobot& { return run.fleet().robots().front(); };
  const auto has_order = [&] {
    return body().life == fleet::RobotLife::kRunning && run.fleet().group(body()) != nullptr;
  };
  for (int i = 0; i < 20 && !has_order(); ++i) run.step();
  if (body().life != fleet::RobotLife::kRunning) return no_field("the robot can't be started");
  return field_arrows(run, body(), false, question.part, question.grid);
}

text::Result<Fields::Question> Fields::question_of(const OpenConfiguration& document,
                                                   const ReadField& request) {
  const text::Result<FieldGrid> grid = grid_of(request);
  if (!grid) return std::unexpected(grid.error());
  text::Result<Trials::Planned> node = node_of(document, request);
  if (!node) return std::unexpected(node.error());
  text::Result<FieldProgram> part = program_of(*node);
  if (!part) return std::unexpected(part.error());
  return Question{std::move(*node), std::move(*part), *grid};
}

Answered Fields::read(const Sender& sender, const ReadField& request, Answer& out) {
  const OpenConfiguration* document = opened(desk_, request.document(), out);
  if (document == nullptr) return Answered::kNow;
  const text::Result<Question> question = question_of(*document, request);
  if (!question) {
    fail(out, question.error());
    return Answered::kNow;
  }
  const Trials::Last* last = trials_.last(document->path);
  if (!look_at_run_ || last == nullptr) {
    if (request.robot() != 0)
      fail(out, not_live("that robot does not run"));
    else
      answer_alone(*document, *question, out);
    return Answered::kNow;
  }
  const auto reading = std::make_shared<FieldReading>(question->part, question->grid, request.robot() != 0);
  read_in_pieces(
      look_at_run_, reading, request.robot(), desk_.project().disk_path(last->mission),
      [this, inbox = inbox_, asker = sender.asker, request, question = *question, reading](bool was_read) {
        std::optional<Arrows> arrows;
        if (was_read && reading->problem().empty()) arrows = {reading->arrows(), reading->is_as_is()};
        inbox->post([this, asker, request, question, arrows] { answer(asker, request, question, arrows); });
      });
  return Answered::kLater;
}

void Fields::answer_alone(const OpenConfiguration& document, const Question& question, Answer& out) {
  const text::Result<std::string> arrows = read_alone(document, question);
  if (!arrows) {
    fail(out, arrows.error());
    return;
  }
  out.mutable_field()->set_arrows(*arrows);
  out.mutable_field()->set_note("a robot that has just started, on the field for trying");
}

void Fields::answer(const Asker& asker, const ReadField& request, const Question& question,
                    const std::optional<Arrows>& arrows) {
  Answer out = answer_for(asker);
  const OpenConfiguration* document = desk_.find(request.document());
  if (arrows) {
    out.mutable_field()->set_arrows(arrows->bytes);
    out.mutable_field()->set_note(arrows->is_as_is
                                      ? fmt::format("robot {} with its state as it is now", request.robot())
                                      : "a robot that has just started, among those that run");
  } else if (request.robot() != 0 || document == nullptr) {
    fail(out, not_live("that robot does not run"));
  } else {
    answer_alone(*document, question, out);
  }
  answers_.add(asker, std::move(out));
}

}  // namespace mlab::designer
