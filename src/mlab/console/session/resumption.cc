#include "mlab/console/session/resumption.h"

#include <memory>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"
#include "mlab/journal/journal.h"

namespace mlab::console {
namespace {

std::vector<Breakpoint> breakpoints_of(const journal::Kept& kept) {
  std::vector<Breakpoint> out;
  Breakpoint one;
  for (const std::string& bytes : kept.stand.session.breakpoints()) {
    if (one.ParseFromString(bytes)) out.push_back(one);
  }
  return out;
}

}  // namespace

Answered Resumption::resume(const std::string& path) {
  auto read = journal::read_journal(path);
  if (!read && read.error().kind == journal::Unreadable::Kind::kForeign)
    return journal::JournalFolder::set_aside(path, read.error().why);
  if (!read) return read.error().why;
  const auto kept = std::make_shared<const journal::Kept>(std::move(*read));
  if (kept->stand.progress.is_over()) return "the run is over: there is nothing to go on with";
  if (auto error = open_mission(*kept)) return error;
  recall(*kept);
  if (!kept->cut.empty())
    parts_.log.add(0.0, {Log::WARNING,
                         fmt::format("the journal of the run is damaged: {}", clean(kept->cut)),
                         0,
                         "",
                         {},
                         true});
  parts_.maker.resume(kept, [this, kept] {
    parts_.run.breakpoints().recall(breakpoints_of(*kept));
    parts_.bookmarks.recall(kept->stand.session);
  });
  return std::nullopt;
}

Answered Resumption::open_mission(const journal::Kept& kept) {
  const wire::HistoryBeginning& beginning = kept.history->beginning();
  const std::string& path = kept.stand.session.mission();
  parts_.documents.set_seed(beginning.obstacle_seed());
  const double now = wall_time();
  text::Result<bool> opened = parts_.documents.open(path, now);
  if (!opened && !path.starts_with("examples:"))
    opened = parts_.documents.open_on_disk(beginning.mission().path(), now);
  if (opened) return std::nullopt;
  return fmt::format("the run can't be gone on with: {}", clean(opened.error().message));
}

void Resumption::recall(const journal::Kept& kept) {
  const wire::JournalSession& session = kept.stand.session;
  std::vector<Log::Entry> entries;
  Log::Entry entry;
  for (const journal::Note& note : kept.notes) {
    if (entry.ParseFromString(note.bytes)) entries.push_back(entry);
  }
  parts_.log.put_before(std::move(entries), session.alerts_after());
  std::vector<Roles::Client> people;
  for (const wire::JournalSession::Person& one : session.people())
    people.push_back({one.id(), clean(one.name()), one.key(), {}, 0.0});
  parts_.people.recall(std::move(people), session.operator_());
  const double speed = session.speed();
  if (speed == 0.0 || (speed >= run::Pace::kSlowest && speed <= run::Pace::kFastest))
    parts_.run.set_speed(speed);
  parts_.run.breakpoints().recall(breakpoints_of(kept));
}

Answered Resumption::continue_run(const Sender& sender, const ContinueRun& wanted) {
  const std::string path = parts_.chronicle.path_of(wanted.name());
  if (path.empty()) return "there is no such run";
  parts_.chronicle.keep_now();
  auto error = resume(path);
  if (!error) parts_.run.note(sender.client.name, "continue the run");
  parts_.chronicle.look();
  return error;
}

}  // namespace mlab::console
