#include "mlab/console/session/bookmark_orders.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"

namespace mlab::console {
namespace {

constexpr double kTriedAgain = 5.0;  // after an error [s]
constexpr double kAhead = 1.0;       // so far a browser may see the run ahead of what it was told [s]

}  // namespace

void BookmarkOrders::open_recording() {
  const std::string& path = parts_.settings.recording.path;
  if (path.empty()) return;
  const history::History& history = *parts_.settings.recording.history;
  parts_.kept = history::read_bookmarks(path, history::RunExtent{history.last_cycle(), history.last_time()});
  if (!parts_.kept.problem.empty()) warn("not all bookmarks can be shown: " + clean(parts_.kept.problem));
  if (!parts_.kept.moved.empty()) warn("of the bookmarks " + clean(parts_.kept.moved));
  ++revision_;
}

void BookmarkOrders::warn(std::string text) {
  parts_.log.add(0.0, {Log::WARNING, std::move(text), 0, "", {}, true});
}

void BookmarkOrders::follow_run() {
  if (is_recording() || known_run_ == parts_.run.run_number()) return;
  if (!unwritten_.empty()) keep(true);
  known_run_ = parts_.run.run_number();
  parts_.kept = {};
  kept_in_.clear();
  not_kept_.clear();
  unwritten_.clear();
  ++revision_;
}

void BookmarkOrders::recall(const wire::JournalSession& session) {
  follow_run();
  if (why_not()) return;
  for (const wire::JournalBookmark& kept : session.bookmarks()) {
    history::Bookmark one{kept.id(), kept.cycle(), kept.time(), kept.note(), kept.by()};
    // The run may be on its way still.
    history::move_into_run(one, {});
    static_cast<void>(parts_.kept.bookmarks.put(std::move(one)));
  }
  // The recording may lack the last ones, or be a new one.
  for (const auto& [id, one] : parts_.kept.bookmarks.all()) write(id);
  ++revision_;
}

void BookmarkOrders::keep(bool is_last) {
  if (unwritten_.empty() || (!is_last && wall_time() < next_try_)) return;
  write_beside(std::string(unwritten_));
}

// ---- what is asked

Answered BookmarkOrders::why_not() const {
  if (is_recording()) return std::nullopt;
  const LiveRun* live = std::as_const(parts_.run).live();
  if (live == nullptr || live->run().cycle() == 0) return "nothing has run yet that could be marked";
  return std::nullopt;
}

Answered BookmarkOrders::set(const Sender& sender, const SetBookmark& wanted, Reply& reply) {
  if (auto why = why_not()) return why;
  if (wanted.id() == 0) return make(sender, wanted, reply);
  if (auto error = parts_.kept.bookmarks.set_note(wanted.id(), wanted.note())) return error;
  reply.set_bookmark(wanted.id());
  write(wanted.id());
  return std::nullopt;
}

Answered BookmarkOrders::make(const Sender& sender, const SetBookmark& wanted, Reply& reply) {
  const history::History* recording = parts_.settings.recording.history.get();
  const double end = recording != nullptr ? recording->last_time() : parts_.run.sim_time();
  const std::uint64_t last =
      recording != nullptr ? recording->last_cycle() : std::as_const(parts_.run).live()->run().cycle();
  if (!wanted.now() && !(wanted.time() >= 0.0 && wanted.time() <= end + kAhead))
    return fmt::format("{:g} s is no moment of the run, which {} {:.1f} s", wanted.time(),
                       recording != nullptr ? "ends at" : "has come to", end);
  history::Bookmark one;
  one.time = wanted.now() ? end : std::min(wanted.time(), end);
  one.cycle = wanted.now() ? last : wanted.cycle();
  // Of a moment that is still being computed only the time is known.
  if (one.cycle == 0 && one.time > 0.0) one.cycle = last + 1;
  history::move_into_run(one, history::RunExtent{last, end});
  one.note = wanted.note();
  one.by = sender.client.name;
  const auto made = parts_.kept.bookmarks.add(std::move(one));
  if (!made) return made.error();
  reply.set_bookmark(*made);
  write(*made);
  return std::nullopt;
}

Answered BookmarkOrders::remove(const RemoveBookmark& wanted) {
  if (auto why = why_not()) return why;
  history::Bookmarks& all = parts_.kept.bookmarks;
  if (auto error = wanted.take_back() ? all.take_back(wanted.id()) : all.remove(wanted.id())) return error;
  write(wanted.id());
  return std::nullopt;
}

// ---- where they are kept

// Into the recording while that is written, else beside it.
void BookmarkOrders::write(std::uint64_t changed) {
  ++revision_;
  if (is_recording()) {
    write_beside(parts_.settings.recording.path);
    return;
  }
  LiveRun* live = parts_.run.live();
  history::Recorder* recorder = live != nullptr ? live->recorder() : nullptr;
  const history::Bookmark* one = parts_.kept.bookmarks.find(changed);
  if (recorder != nullptr && recorder->put_metadata(one != nullptr ? history::bookmark_record(*one)
                                                                   : history::bookmark_record(changed))) {
    note(recorder->path(), "");
    return;
  }
  if (recorder == nullptr || recorder->path().empty())
    note("", "this run is not recorded: once another one takes its place its bookmarks are gone");
  else
    write_beside(recorder->path());
}

void BookmarkOrders::write_beside(const std::string& recording) {
  if (recording.empty()) {
    note("", "the recording has no file");
    return;
  }
  const auto written = history::write_bookmarks(recording, parts_.kept);
  unwritten_ = written ? "" : recording;
  next_try_ = wall_time() + kTriedAgain;
  if (written)
    note(history::bookmark_path(recording), "");
  else
    note("", clean(written.error()));
}

void BookmarkOrders::note(std::string kept_in, std::string not_kept) {
  if (kept_in == kept_in_ && not_kept == not_kept_) return;
  if (!not_kept.empty() && not_kept != not_kept_)
    parts_.log.add(parts_.run.sim_time(),
                   {Log::WARNING, fmt::format("bookmarks are not kept: {}", not_kept), 0, "", {}, true});
  if (not_kept.empty() && !not_kept_.empty())
    parts_.log.add(parts_.run.sim_time(), {Log::MESSAGE, "bookmarks are kept again", 0, "", {}, false});
  kept_in_ = std::move(kept_in);
  not_kept_ = std::move(not_kept);
  ++revision_;
}

// ---- what is told

void BookmarkOrders::encode(console::Bookmarks& out) const {
  for (const history::Bookmark& one : parts_.kept.bookmarks.in_order()) {
    console::Bookmark& told = *out.add_bookmarks();
    told.set_id(one.id);
    told.set_time(one.time);
    told.set_cycle(one.cycle);
    told.set_note(clean(one.note));
    told.set_by(clean(one.by));
  }
  out.set_kept_in(clean(kept_in_));
  out.set_not_kept(not_kept_);
}

}  // namespace mlab::console
