#include "mlab/history/remaker.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/history/recorded_failures.h"
#include "mlab/history/recorded_names.h"
#include "mlab/history/recorded_runner.h"
#include "mlab/history/wire.h"
#include "mlab/lang/envchange/envchange.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/simulated/run.h"
#include "mlab/text/shown.h"
#include "mlab/vehicle/bodies.h"

namespace mlab::history {
namespace {

// The files of a version, and no others.
text::Files files_of(const History& history, const wire::HistoryMission& version) {
  auto sources = std::make_shared<RecordedSources>();
  for (const std::uint32_t id : version.texts()) sources->add(history.text(id));
  text::Files out;
  out.is_file = [sources](const std::string& path) { return sources->find(path) != nullptr; };
  out.read = [sources](const std::string& path) -> text::Result<text::SourcePtr> {
    if (text::SourcePtr found = sources->find(path)) return found;
    text::Diagnostic missing;
    missing.kind = "cannot-read";
    missing.message = fmt::format("cannot read `{}`: it is not part of the recording", text::shown(path));
    return std::unexpected(missing);
  };
  return out;
}

std::shared_ptr<const robot::RecordedProgram> recorded_of(const wire::HistoryExecutable& program) {
  auto out = std::make_shared<robot::RecordedProgram>();
  out->build = program.build();
  out->is_open = program.is_open();
  out->reports = program.reports();
  for (const wire::HistoryNumber& one : program.numbers()) out->numbers[one.name()] = one.value();
  for (const wire::HistoryNumber& one : program.body()) out->body[one.name()] = one.value();
  return out;
}

bool has_same_texts(const wire::HistoryMission& a, const wire::HistoryMission& b) {
  return std::ranges::equal(a.texts(), b.texts());
}

}  // namespace

std::unique_ptr<run::MissionRun> Remaker::begin(text::Diagnostics& sink) {
  const wire::HistoryBeginning& beginning = history_.beginning();
  crew_ = make(beginning.mission(), nullptr, sink);
  if (!crew_) return nullptr;
  run::RunSettings& settings = settings_;
  settings.seed = beginning.seed();
  settings.threads = tools_.threads;
  settings.executive = from_wire(beginning.executive());
  settings.stands_still_for_operator = beginning.stands_still_for_operator();
  settings.goes_on_when_done = beginning.goes_on_when_done();
  if (beginning.environment() != 0) {
    auto changes =
        envchange::parse(history_.text(beginning.environment()), crew_->mission->overlay.origin, sink);
    if (!changes) return nullptr;
    settings.environment = std::move(*changes);
  }
  settings.recorded = recorded();
  if (!beginning.vehicles().empty()) {
    settings.vehicles =
        [recorded = std::vector<std::string>(beginning.vehicles().begin(), beginning.vehicles().end())](
            const mission::Mission& mission, std::unique_ptr<binding::Binding> simulated) {
          return vehicle::recorded_bodies(std::move(simulated), recorded, mission.overlay.projection);
        };
  }
  first_ = crew_;
  return begin_again();
}

std::unique_ptr<run::MissionRun> Remaker::begin_again() const {
  return simulated::make_run(first_, settings_);
}

run::RunSettings::Recorded Remaker::recorded() const {
  return {[history = all_](std::function<std::uint64_t()> cycle) {
            return std::make_unique<RecordedRunner>(history, std::move(cycle));
          },
          history_.beginning().is_in_real_time(),
          [history = all_](std::function<std::uint64_t()> cycle) {
            return std::make_unique<RecordedFailures>(history, std::move(cycle));
          }};
}

void Remaker::take_up(const Remaker& from, std::shared_ptr<const run::Crew> crew, std::size_t inputs) {
  first_ = from.first_;
  settings_ = from.settings_;
  settings_.recorded = recorded();
  crew_ = crew ? std::move(crew) : first_;
  std::size_t next = inputs;
  while (next > 0 && !history_.inputs()[next - 1].input.has_exchanged()) --next;
  version_ =
      next > 0 ? history_.inputs()[next - 1].input.exchanged().mission() : history_.beginning().mission();
  text::Diagnostics known;  // it was read without errors before
  static_cast<void>(read(version_, known));
  for (; next < inputs; ++next) {
    const wire::HistoryPosted& posted = history_.inputs()[next].input.posted();
    if (posted.kind() == wire::HistoryPosted::TYPED && typed_ && typed_->first == posted.line())
      typed_.reset();
  }
}

// What texts are read with from now on.
robot::ProgramSources Remaker::prepare(const wire::HistoryMission& version) {
  files_ = files_of(history_, version);
  robot::ProgramSources sources{tools_.permission, version.program_folder(), tools_.include_root,
                                tools_.version, &files_};
  sources.came_from_elsewhere = true;
  sources.limits = tools_.limits;
  sources.in_own_processes = tools_.in_own_processes;
  sources.is_vehicle = [names = vehicle::recorded_names({history_.beginning().vehicles().begin(),
                                                         history_.beginning().vehicles().end()})](
                           const std::string& host) { return names.contains(host); };
  if (!version.programs().empty()) {
    sources.recorded = [version](const std::string& name,
                                 std::string_view type) -> std::shared_ptr<const robot::RecordedProgram> {
      for (const wire::HistoryExecutable& one : version.programs()) {
        if (one.name() == name && one.type() == type) return recorded_of(one);
      }
      return nullptr;
    };
  }
  options_ = {};
  options_.seed = history_.beginning().obstacle_seed();
  options_.overlay_folders = {history_.beginning().overlay_folders().begin(),
                              history_.beginning().overlay_folders().end()};
  options_.files = files_;
  options_.societies = robot::society_reader(sources);
  for (const wire::HistorySetting& one : version.set())
    options_.settings.push_back({one.name(), one.value(), {}, {}});
  return sources;
}

std::shared_ptr<const mission::Mission> Remaker::read(const wire::HistoryMission& version,
                                                      text::Diagnostics& sink) {
  prepare(version);
  return mission_of(version, sink);
}

std::shared_ptr<const run::Crew> Remaker::make(const wire::HistoryMission& version, const run::Crew* before,
                                               text::Diagnostics& sink) {
  const robot::ProgramSources sources = prepare(version);
  const MissionPtr mission = mission_of(version, sink);
  if (!mission) return nullptr;
  version_ = version;
  return run::make_crew(mission, sources, sink, before);
}

Remaker::MissionPtr Remaker::mission_of(const wire::HistoryMission& version, text::Diagnostics& sink) {
  MissionPtr mission;
  typed_.reset();
  if (const auto source = files_.read(version.path()))
    mission = mdl::check_mission(*source, version.folder(), sink, options_);
  for (const std::string& line : version.typed()) {
    if (!mission) return nullptr;
    const auto read = mdl::parse_immediate(line, *mission, sink, options_);
    if (!read || !read->edited) return nullptr;
    mission = read->edited;
    typed_ = std::pair(line, read->commands);
  }
  return mission;
}

std::optional<run::Input> Remaker::understand(const wire::HistoryInput& input, text::Diagnostics& sink) {
  if (input.has_posted() && input.posted().kind() == wire::HistoryPosted::TYPED)
    return typed(input.posted().line(), sink);
  if (!input.has_exchanged()) {
    std::optional<run::Input> out = decode(input);
    if (!out) sink.error("nonsense", {}, "what came in is nothing that this program knows");
    return out;
  }
  const wire::HistoryMission& version = input.exchanged().mission();
  // Programs are made anew where their files have changed, and where they are taken over.
  const bool keeps = !input.exchanged().takes_over() && has_same_texts(version, version_);
  std::shared_ptr<const run::Crew> crew = make(version, keeps ? crew_.get() : nullptr, sink);
  if (!crew) return std::nullopt;
  crew_ = crew;
  return run::input::Exchanged{std::move(crew), input.exchanged().takes_over()};
}

std::optional<run::Input> Remaker::typed(const std::string& line, text::Diagnostics& sink) {
  if (typed_ && typed_->first == line) {
    const auto known = std::exchange(typed_, std::nullopt);
    return run::input::Posted{mission::event::Typed{known->second, line}};
  }
  const auto read = mdl::parse_immediate(line, *crew_->mission, sink, options_);
  if (!read) return std::nullopt;
  return run::input::Posted{mission::event::Typed{read->commands, line}};
}

}  // namespace mlab::history
