#include "mlab/console/session/run_maker.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"
#include "mlab/console/run/targets.h"
#include "mlab/simulated/run.h"

namespace mlab::console {
namespace {

bool is_in(const std::filesystem::path& path, const std::string& folder) {
  if (folder.empty()) return false;
  std::error_code failure;
  const std::filesystem::path root = std::filesystem::weakly_canonical(folder, failure);
  return !failure && std::ranges::mismatch(root, path).in1 == root.end();
}

// The folder that a mission's programs come from: the project, or the examples; of a mission that the command
// line named elsewhere, its own.
std::string root_of(const std::string& mission_folder, const SessionSettings& settings) {
  std::error_code failure;
  const std::filesystem::path folder = std::filesystem::weakly_canonical(mission_folder, failure);
  for (const std::string& root : {settings.project_folder, settings.example_folder}) {
    if (is_in(folder, root)) return root;
  }
  return mission_folder;
}

bool is_value_of_option(const std::vector<mission::Command>& commands) {
  return commands.size() == 1 && (std::holds_alternative<mission::SetBoolean>(commands[0]) ||
                                  std::holds_alternative<mission::SetNumber>(commands[0]));
}

}  // namespace

RunMaker::RunMaker(const Parts& parts, std::function<bool()> meanwhile)
    : settings_(parts.settings),
      documents_(parts.documents),
      run_(parts.run),
      parameters_(parts.parameters),
      log_(parts.log),
      inbox_(parts.inbox),
      chronicle_(parts.chronicle),
      meanwhile_(std::move(meanwhile)),
      seed_(parts.settings.run.seed),
      run_settings_(parts.settings.run),
      workshop_(std::make_unique<Workshop>()) {}

RunMaker::~RunMaker() {
  end();
}

void RunMaker::end() {
  jobs_end_.request_stop();
  workshop_.reset();
}

robot::ProgramSources RunMaker::program_sources() const {
  return program_sources_with(trial_files_.get());
}

robot::ProgramSources RunMaker::program_sources_with(const text::Files* trial_files) const {
  robot::ProgramSources out = {settings_.permission, documents_.mission_folder(), settings_.include_root,
                               settings_.version, documents_.is_trial() ? trial_files : nullptr};
  // What is tried reads through the project by itself.
  if (out.files == nullptr) out.project = root_of(documents_.mission_folder(), settings_);
  out.limits = settings_.limits;
  out.in_own_processes = settings_.in_own_processes;
  out.is_vehicle = settings_.run.is_vehicle;
  out.ends = jobs_end_.get_token();
  return out;
}

// ---- another run

Answered RunMaker::restart(const Sender& sender, const Control& control) {
  if (!documents_.mission()) return "there is no mission that could run";
  run_.note(sender.client.name, "restart");
  chronicle_.give_up();
  load(control.has_seed() ? control.seed() : seed_);
  return std::nullopt;
}

void RunMaker::follow_other_mission() {
  parameters_.clear();
  from_documents_.reset();
  take_notices();
  load(seed_);
}

void RunMaker::start_trial(const Trial& trial, TrialDone done) {
  if (trial.takes_over) {
    take_over(trial, done);
    return;
  }
  const auto files_before = std::exchange(trial_files_, trial.files);  // the text names programs among them
  if (const text::Result<bool> opened = documents_.open_trial(trial, wall_time()); !opened) {
    trial_files_ = files_before;
    done({opened.error().message, "", {}});
    return;
  }
  run_.note(trial.who, fmt::format("try {}", trial.path));
  follow_other_mission();
  trial_done_ = std::move(done);
  executes_trial_ = trial.execute;
  if (!run_.is_expected()) answer_trial("the mission of the trial has errors", documents_.problems());
}

// ---- the same run, with other programs

Answered RunMaker::why_not_taken_over(const Trial& trial) const {
  if (auto refused = run_.why_not_now()) return refused;
  if (!documents_.is_trial() || !plain_ || plain_ != run_.live()->crew()->mission)
    return "another mission runs";
  if (!plain_->source || plain_->source->text() != trial.text)
    return "what runs, how many or where has changed";
  if (!run_.live()->was_started()) return "no robot has started yet";
  return std::nullopt;
}

// The run goes on as it was until the programs are made.
void RunMaker::take_over(const Trial& trial, const TrialDone& done) {
  if (const Answered refused = why_not_taken_over(trial)) {
    done({*refused, "", {}});
    return;
  }
  const std::uint64_t number = ++number_;
  workshop_->start([this, number, mission = plain_, sources = program_sources_with(trial.files.get()),
                    files = trial.files, done] {
    const auto problems = std::make_shared<text::Diagnostics>();
    const CrewPtr crew = number == number_ ? run::make_crew(mission, sources, *problems) : nullptr;
    inbox_.post([this, number, crew, problems, files, done] {
      if (number == number_ && run_.live() != nullptr)
        finish_takeover(crew, files, *problems, done);
      else
        done({"another run has taken its place", "", {}});
    });
  });
}

void RunMaker::finish_takeover(const CrewPtr& crew, const FilesPtr& files, const text::Diagnostics& problems,
                               const TrialDone& done) {
  if (!crew) {
    done({"it can't run: it has errors", "", problems});
    return;
  }
  // It may have been stopped, or have quit, while the programs were made.
  if (const Answered refused = run_.why_not_now()) {
    done({*refused, "", {}});
    return;
  }
  const auto taken = run_.take_over(crew);
  if (!taken) {
    done({taken.error(), "", problems});
    return;
  }
  trial_files_ = files;
  report_problems(problems);
  done({"", run::text_of(*taken), problems});
}

// At most once.
void RunMaker::answer_trial(const std::string& error, const text::Diagnostics& problems) {
  const TrialDone done = std::exchange(trial_done_, nullptr);
  if (done) done({error, "", problems});
}

void RunMaker::load(std::uint64_t seed, const CrewPtr& known) {
  const std::uint64_t number = ++number_;
  answer_trial("another run has taken its place", {});
  seed_ = seed;
  log_.begin_run();
  from_documents_ = plain_ = documents_.mission();
  typed_edits_.clear();
  if (!plain_) {
    run_.adopt(nullptr, nullptr);
    return;
  }
  run_.expect();
  run::RunSettings run_settings = run_settings_;
  run_settings.seed = seed;
  if (documents_.is_trial()) run_settings.executive.patience = 0.0;  // what is tried need not get anywhere
  workshop_->start([this, number, mission = plain_, run_settings, made_of = files_,
                    known = are_programs_old() ? nullptr : known, sources = program_sources(),
                    files = trial_files_] {
    if (number != number_) return;
    const auto problems = std::make_shared<text::Diagnostics>();
    const CrewPtr crew = run::make_crew(mission, sources, *problems, known.get());
    const auto run = std::make_shared<std::unique_ptr<run::MissionRun>>();
    if (crew) *run = simulated::make_run(crew, run_settings);
    inbox_.post([this, number, made_of, crew, run, problems] {
      if (number != number_) return;
      if (crew) made_of_ = made_of;
      adopt(crew, std::move(*run), *problems);
    });
  });
}

void RunMaker::adopt(const CrewPtr& crew, std::unique_ptr<run::MissionRun> run,
                     const text::Diagnostics& problems) {
  report_problems(problems);
  std::unique_ptr<history::Recorder> recorder;
  if (run) {
    run->set_meanwhile(meanwhile_);
    recorder = chronicle_.begin(*run);
  }
  run_.adopt(crew, std::move(run), std::move(recorder));
  parameters_.apply_all();
  if (trial_done_ && executes_trial_ && !run_.why_not_now()) {
    if (const Answered refused = run_.why_not_start())
      log_.add(run_.sim_time(), {Log::WARNING, *refused, 0, "", {}, true});
    else
      run_.post(mission::event::Execute{});
  }
  answer_trial(run_.live() != nullptr ? "" : "it can't run: it has errors", problems);
}

// ---- a run that was cut off

void RunMaker::resume(const std::shared_ptr<const journal::Kept>& kept, std::function<void()> done) {
  const std::uint64_t number = ++number_;
  answer_trial("another run has taken its place", {});
  parameters_.recall(kept->history->inputs());
  seed_ = kept->history->beginning().seed();
  from_documents_ = plain_ = documents_.mission();
  typed_edits_.clear();
  run_.expect();
  const std::shared_ptr<RunJournal> journal = chronicle_.held_journal();
  ResumeParts parts;
  parts.tools = {settings_.permission, settings_.include_root, settings_.version,
                 settings_.limits,     settings_.run.threads,  settings_.in_own_processes};
  parts.version = settings_.version;
  parts.place = chronicle_.place_anew(kept->history->beginning().mission().path());
  const auto entries = std::make_shared<HistoryEntries>();
  parts.hear = Chronicle::listener_of(journal, entries);
  workshop_->start([this, number, kept, journal, entries, parts = std::move(parts), done = std::move(done)] {
    const auto resumed =
        std::make_shared<ResumedRun>(resume_run(*kept, parts, [&] { return number != number_; }));
    inbox_.post([this, number, kept, journal, entries, resumed, done] {
      if (number != number_) return;
      finish_resumption(std::move(*resumed), kept, journal, entries, done);
    });
  });
}

void RunMaker::finish_resumption(ResumedRun resumed, const std::shared_ptr<const journal::Kept>& kept,
                                 std::shared_ptr<RunJournal> journal, std::shared_ptr<HistoryEntries> entries,
                                 const std::function<void()>& done) {
  if (!resumed.live) {
    take_notices();
    load(seed_);
    done();
    log_.add(0.0,
             {Log::WARNING, fmt::format("the run can't be gone on with: {}", resumed.why), 0, "", {}, true});
    return;
  }
  run::MissionRun& run = resumed.live->run();
  run.set_meanwhile(meanwhile_);
  resumed.live->go_on_in(log_);
  for (Log::Entry& one : resumed.told) log_.add_told(std::move(one));
  plain_ = run.crew()->mission;
  typed_edits_ = plain_->typed;
  made_of_ = files_;
  run_settings_.environment = run.settings().environment;
  run_settings_.executive = run.settings().executive;
  chronicle_.go_on(std::move(journal), run, kept, std::move(entries));
  const double time = run.time();
  run_.adopt(std::move(resumed.live));
  take_notices();  // which are of the moment at which it stands
  log_.add(time,
           {Log::MESSAGE, fmt::format("the run goes on as it stood at {:.1f} s", time), 0, "", {}, false});
  done();  // what it brings back is written before the journal that it came from goes
  follow_changes_since();
  chronicle_.keep_now();
}

void RunMaker::follow_changes_since() {
  // Of a text with errors what runs is the last one without: that is what the run was left with.
  if (!from_documents_ || documents_.runs_older_text()) return;
  const auto texts_of = [](const mission::Mission& mission) {
    std::vector<std::string_view> out = {mission.source->text()};
    for (const text::SourcePtr& one : mission.texts) out.push_back(one->text());
    return out;
  };
  if (!from_documents_->source || texts_of(*from_documents_) == texts_of(*plain_)) return;
  log_.add(run_.sim_time(), {Log::EDIT,
                             "the mission was changed meanwhile: the run goes on with what it is now",
                             0,
                             "",
                             {},
                             false});
  follow_edited_mission();
}

void RunMaker::report_problems(const text::Diagnostics& problems) {
  for (const text::Diagnostic& problem : problems.items()) {
    const bool is_error = problem.severity == text::Severity::kError;
    const DocumentPlace place = documents_.place(problem.place);
    const std::string where =
        place.document.empty() ? "" : fmt::format("{}:{}: ", place.document, place.line);
    log_.add(run_.sim_time(), {Log::WARNING, where + problem.message, 0, "", {}, is_error});
  }
}

// ---- the same run, of a mission that has changed

void RunMaker::take_notices() {
  for (std::string& notice : documents_.take_notices())
    log_.add(run_.sim_time(), {Log::EDIT, std::move(notice), 0, "", {}, false});
}

void RunMaker::follow_documents() {
  take_notices();
  const LiveRun* live = run_.live();
  const bool is_same = documents_.mission() == from_documents_;
  if (is_same && (live != nullptr || run_.is_expected() || !from_documents_)) return;
  if (run_.is_expected() || live == nullptr || !live->was_started())
    load(seed_, live != nullptr ? live->crew() : nullptr);
  else
    follow_edited_mission();
}

void RunMaker::follow_edited_mission() {
  from_documents_ = documents_.mission();
  MissionPtr plain = from_documents_;
  std::erase_if(typed_edits_, [&](const std::string& line) {
    text::Diagnostics problems;
    const auto read = mdl::parse_immediate(line, *plain, problems, documents_.load_options());
    if (read && read->edited) {
      plain = read->edited;
      return false;
    }
    log_.add(run_.sim_time(), {Log::WARNING, fmt::format("no longer in force: {}", line), 0, "", {}, true});
    return true;
  });
  change_mission(std::move(plain));
}

bool RunMaker::change_mission(MissionPtr plain) {
  plain_ = std::move(plain);
  const std::uint64_t number = ++number_;
  const CrewPtr before = are_programs_old() ? nullptr : run_.live()->crew();
  const bool is_quick = before && std::ranges::all_of(plain_->types, [&](const mission::RobotType& type) {
                          return std::ranges::find(before->programs, type.program,
                                                   &robot::RobotProgram::name) != before->programs.end();
                        });
  if (is_quick) {
    text::Diagnostics problems;
    const CrewPtr crew = run::make_crew(plain_, program_sources(), problems, before.get());
    exchange(number, crew, problems);
    return true;
  }
  // Something has to be built, perhaps compiled: the run goes on meanwhile as it was.
  workshop_->start([this, number, made_of = files_, mission = plain_, before, sources = program_sources(),
                    files = trial_files_] {
    if (number != number_) return;
    const auto problems = std::make_shared<text::Diagnostics>();
    const CrewPtr crew = run::make_crew(mission, sources, *problems, before.get());
    inbox_.post([this, number, made_of, crew, problems] {
      if (crew && number == number_) made_of_ = made_of;
      exchange(number, crew, *problems);
    });
  });
  return false;
}

void RunMaker::exchange(std::uint64_t number, const CrewPtr& crew, const text::Diagnostics& problems) {
  if (number != number_ || run_.live() == nullptr) return;
  if (crew)
    run_.exchange(crew);
  else
    report_problems(problems);
}

// ---- what is typed

Answered RunMaker::typed(const Sender& sender, const Typed& typed, Reply& reply) {
  if (run_.live() == nullptr) return run_.why_not_now();
  text::Diagnostics problems;
  const auto read = mdl::parse_immediate(typed.line(), *plain_, problems, documents_.load_options());
  for (const text::Diagnostic& problem : problems.items())
    *reply.add_diagnostics() = documents_.message(problem);
  if (!read)
    return problems.items().empty() ? "this can't be understood" : clean(problems.items().front().message);
  const mission::Mission& mission = read->edited ? *read->edited : *plain_;
  encode_targets(run_.live()->run(), mission, read->commands, *reply.mutable_targets());
  if (typed.preview()) return std::nullopt;
  if (auto refused = run_.why_not_now()) return refused;
  if (!read->commands.empty()) {
    if (auto refused = run_.why_not_start()) return refused;
  }
  log_.add(run_.sim_time(),
           {Log::OPERATOR, fmt::format("{} typed: {}", sender.client.name, typed.line()), 0, "", {}, false});
  if (read->edited) {
    if (!change_mission(read->edited)) return "the mission is still being made ready";
    typed_edits_.push_back(typed.line());
  }
  if (!read->commands.empty()) run_.post(mission::event::Typed{read->commands, typed.line()});
  return std::nullopt;
}

Answered RunMaker::set_option(const Sender& sender, const SetOption& option) {
  if (run_.live() == nullptr) return run_.why_not_now();
  const std::string line = fmt::format("SET {} {}", option.option(), option.value());
  text::Diagnostics problems;
  const auto read = mdl::parse_immediate(line, *plain_, problems, documents_.load_options());
  if (!read && !problems.items().empty()) return clean(problems.items().front().message);
  if (!read || !is_value_of_option(read->commands))
    return fmt::format("`{}` is no option with a value", clean(line));
  if (read->edited) {
    if (!change_mission(read->edited)) return "the mission is still being made ready";
    typed_edits_.push_back(line);
  }
  run_.post(mission::event::Typed{read->commands, line});
  run_.note(sender.client.name, line);
  return std::nullopt;
}

}  // namespace mlab::console
