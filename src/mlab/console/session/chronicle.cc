#include "mlab/console/session/chronicle.h"

#include <chrono>
#include <expected>
#include <filesystem>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/published/status_encoder.h"
#include "mlab/documents/project_folder.h"
#include "mlab/text/shown.h"

namespace mlab::console {
namespace {

constexpr double kApart = 0.5;  // how far the run has come is written so often, at most [s]

// Seconds since 1970-01-01 00:00 UTC.
double system_time() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

// A program that is in one; empty: none is.
std::string first_executable(const run::Crew& crew) {
  for (const robot::RobotProgram& program : crew.programs) {
    if (program.is_in_executable()) return program.name;
  }
  return "";
}

}  // namespace

Chronicle::Chronicle(const Parts& parts)
    : settings_(parts.settings),
      documents_(parts.documents),
      run_(parts.run),
      people_(parts.people),
      log_(parts.log),
      bookmarks_(parts.bookmarks),
      shelf_(settings_.record.folder),
      folder_(settings_.journal_folder),
      project_(documents::ProjectFolder({settings_.project_folder, ""}).folder()) {}

Chronicle::~Chronicle() {
  if (journal_) journal_->leave();
}

// Empty: runs are not recorded.
history::Recorder::Place Chronicle::place_of(const run::MissionRun& run) {
  if (!settings_.record.is_on) return {};
  return [this, mission = run.mission().source ? run.mission().source->name()
                                               : std::string()]() -> std::expected<std::string, std::string> {
    if (!settings_.record.file.empty() && !std::exchange(has_named_recording_, true))
      return settings_.record.file;
    return shelf_.place_for(mission, system_time());
  };
}

history::Recorder::Place Chronicle::place_anew(const std::string& mission) const {
  if (!settings_.record.is_on) return {};
  return [shelf = shelf_, mission] { return shelf.place_for(mission, system_time()); };
}

std::unique_ptr<history::Recorder> Chronicle::begin(run::MissionRun& run) {
  keep_now();
  if (journal_) journal_->leave();
  // What is tried in the designer is part of a drawing, and has no file to come back to.
  journal_ = documents_.is_trial() ? nullptr : held_journal();
  if (journal_) {
    follow(run);
    journal_->go_on(nullptr);
  }
  entries_ = std::make_shared<HistoryEntries>();
  return std::make_unique<history::Recorder>(
      place_of(run), run,
      history::Circumstances{settings_.version, settings_.overlay_folders, documents_.load_options().seed,
                             system_time()},
      listener_of(journal_, entries_));
}

// The run may outlive who is told here, so these go with it.
history::Recorder::Listener Chronicle::listener_of(std::shared_ptr<RunJournal> journal,
                                                   std::shared_ptr<HistoryEntries> entries) {
  return [journal = std::move(journal), entries = std::move(entries)](const wire::HistoryEntry& entry) {
    if (journal) journal->hear(entry);
    if (!entry.has_poses()) entries->push_back(entry);
  };
}

HistoryEntries Chronicle::take_entries() {
  return entries_ ? std::exchange(*entries_, {}) : HistoryEntries();
}

// ---- journals

std::shared_ptr<RunJournal> Chronicle::held_journal() const {
  if (folder_.folder().empty()) return nullptr;
  auto out = std::make_shared<RunJournal>(folder_, log_);
  out->hold();
  return out;
}

void Chronicle::go_on(std::shared_ptr<RunJournal> journal, const run::MissionRun& run,
                      std::shared_ptr<const journal::Kept> before, std::shared_ptr<HistoryEntries> entries) {
  entries_ = std::move(entries);
  if (journal_) journal_->leave();
  journal_ = std::move(journal);
  if (!journal_) return;
  follow(run);
  journal_->go_on(std::move(before));
}

// The name of its mission is that of now: another one may be open when it ends.
void Chronicle::follow(const run::MissionRun& run) {
  journal_->follow(
      [this, of = &run, mission = documents_.mission_path()]() -> std::optional<RunJournal::Standing> {
        const LiveRun* live = run_.live();
        if (live == nullptr || &live->run() != of) return std::nullopt;
        return standing_of(*live, mission);
      });
}

RunJournal::Standing Chronicle::standing_of(const LiveRun& live, const std::string& mission) const {
  RunJournal::Standing out;
  const run::MissionRun& run = live.run();
  out.progress.set_cycle(run.cycle());
  out.progress.set_time(run.time());
  out.progress.set_has_looked(run.moment().has_looked);
  out.progress.set_told(live.told());
  out.progress.set_is_over(mode_of(run) == Status::ENDED);
  wire::JournalSession session;
  session.set_project(project_);
  session.set_mission(mission);
  session.set_speed(std::as_const(run_).pace().speed());
  session.set_operator_(people_.roles().operator_id());
  for (const Roles::Client& one : people_.roles().clients()) {
    wire::JournalSession::Person& person = *session.add_people();
    person.set_id(one.id);
    person.set_name(one.name);
    person.set_key(one.key);
  }
  Breakpoints breakpoints;
  run_.breakpoints().encode(breakpoints);
  for (const Breakpoint& one : breakpoints.breakpoints()) session.add_breakpoints(one.SerializeAsString());
  session.set_alerts_after(log_.alerts_after());
  session.set_why_not_gone_on(
      history::History::why_not_gone_on(run.settings().is_in_real_time, first_executable(*run.crew())));
  session.set_recording(live.recording());
  for (const auto& [id, one] : bookmarks_.all()) {
    wire::JournalBookmark& kept = *session.add_bookmarks();
    kept.set_id(id);
    kept.set_cycle(one.cycle);
    kept.set_time(one.time);
    kept.set_note(one.note);
    kept.set_by(one.by);
  }
  out.session = session.SerializeAsString();
  return out;
}

void Chronicle::keep() {
  // Where no time passes, what people are shown next is what is gone on with.
  if (!journal_ || (run_.time_runs() && wall_time() < next_)) return;
  keep_now();
}

void Chronicle::keep_now(journal::Reach reach) {
  if (!journal_) return;
  next_ = wall_time() + kApart;
  journal_->keep(reach);
  tell_problem();
}

void Chronicle::tell_problem() {
  const std::string& problem = journal_->problem();
  if (problem.empty() == told_problem_.empty()) return;
  told_problem_ = problem;
  log_.add(run_.sim_time(),
           {problem.empty() ? Log::MESSAGE : Log::WARNING,
            problem.empty() ? "what is done is saved again"
                            : fmt::format("what is done from now on is not saved: {}", problem),
            0,
            "",
            {},
            !problem.empty()});
}

void Chronicle::give_up() {
  if (journal_) journal_->give_up();
  journal_.reset();
}

std::string Chronicle::not_saved() const {
  return journal_ ? journal_->problem() : "";
}

const Journal& Chronicle::message() {
  message_.set_not_saved(not_saved());
  return message_;
}

std::string Chronicle::path_of(const std::string& name) const {
  for (const Journal::Unfinished& one : message_.unfinished()) {
    if (one.name() == name) return (std::filesystem::path(folder_.folder()) / name).string();
  }
  return "";
}

void Chronicle::look() {
  const journal::JournalFolder::Found found = folder_.look();
  for (const std::string& sentence : found.set_aside)
    log_.add(run_.sim_time(), {Log::WARNING, sentence, 0, "", {}, true});
  message_.clear_unfinished();
  for (const journal::Unfinished& one : found.runs) {
    Journal::Unfinished& told = *message_.add_unfinished();
    told.set_name(std::filesystem::path(one.path).filename().string());
    told.set_mission(text::shown(one.stand.session.mission()));
    told.set_time(one.stand.progress.time());
    told.set_left_at(one.stand.progress.written_at());
    told.set_mission_is_gone(!documents_.is_there(one.stand.session.mission()));
    told.set_why_not(told.mission_is_gone() ? fmt::format("`{}` is not there", told.mission())
                                            : text::shown(one.stand.session.why_not_gone_on(), 400));
  }
}

}  // namespace mlab::console
