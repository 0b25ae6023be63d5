#include "mlab/console/session/publisher.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "mlab/base/hash.h"
#include "mlab/console/published/failsafe_encoder.h"
#include "mlab/console/published/frame_encoder.h"
#include "mlab/console/published/overview.h"
#include "mlab/console/published/status_encoder.h"
#include "mlab/console/published/vehicle_encoder.h"
#include "mlab/console/run/held_values.h"

namespace mlab::console {
namespace {

constexpr double kStatusApart = 0.05;  // two that tell of something that happened [s]
constexpr double kStatusEvery = 0.25;  // while time passes [s]

std::uint32_t count_of(std::size_t size) {
  return static_cast<std::uint32_t>(size);
}

}  // namespace

Publisher::Publisher(const Parts& parts)
    : people_(parts.people),
      documents_(parts.documents),
      run_(parts.run),
      maker_(parts.maker),
      frames_(parts.frames),
      log_(parts.log),
      look_backs_(parts.look_backs),
      chronicle_(parts.chronicle),
      bookmarks_(parts.bookmarks),
      preflight_(parts.preflight),
      machines_(parts.machines),
      topics_(topics()) {
  if (!machines_.is_there()) return;
  const auto look = [this] {
    const LiveRun* live = std::as_const(run_).live();
    return machines_.look(wall_time(), live != nullptr ? &live->run() : nullptr);
  };
  topics_.push_back({[this, look](ToBrowser& out) {
                       look();
                       *out.mutable_machines() = machines_.told();
                     },
                     [this, look] {
                       // Nobody is asked for who does not look.
                       return people_.channels().empty() ? 0 : look();
                     }});
}

// In the order in which whoever comes is told of them.
// NOLINTNEXTLINE(readability-function-size): a row for each topic
std::vector<Publisher::Topic> Publisher::topics() {
  const auto plan_revision = [this] { return run_.plan_revision(); };
  const auto live = [this] { return std::as_const(run_).live(); };
  return {
      {[this](ToBrowser& out) { *out.mutable_project() = documents_.project_message(); },
       [this] { return documents_.files_revision(); }},
      {[this](ToBrowser& out) { *out.mutable_documents() = documents_.documents_message(); },
       [this] { return documents_.revision(); }},
      {[this](ToBrowser& out) { tell_scene(out); }, [this] { return scene_revision(); }, true},
      {[live](ToBrowser& out) {
         Roster& roster = *out.mutable_roster();
         if (live() != nullptr) encode_roster(live()->run(), roster);
       },
       plan_revision, true},
      {[this](ToBrowser& out) {
         Starts& starts = *out.mutable_starts();
         if (run_.live() != nullptr) encode_starts(run_.live()->run(), *starts.mutable_robots());
       },
       [this, live] {
         // Who has been started is no longer shown where it will be.
         const std::uint64_t not_started = live() != nullptr ? count_not_started(live()->run()) : 0;
         return base::combine_bits(base::combine_bits(run_.plan_revision(), world_changes_), not_started);
       },
       true},
      {[this, live](ToBrowser& out) {
         out.mutable_plan()->set_revision(run_.plan_revision());
         if (live() == nullptr) return;
         encode_plan(
             live()->run().mission(), run_.plan_revision(),
             [this](const text::Place& place) { return documents_.place(place); }, *out.mutable_plan());
       },
       plan_revision, true},
      {[this, live](ToBrowser& out) {
         Failsafes& failsafes = *out.mutable_failsafes();
         if (live() == nullptr) return;
         encode_failsafes(
             live()->run().mission(), [this](const text::Place& place) { return documents_.place(place); },
             failsafes);
       },
       plan_revision, true},
      {[this](ToBrowser& out) { preflight_.encode(*out.mutable_preflight()); },
       [this] { return preflight_.revision(); }},
      {[this](ToBrowser& out) { tell_status(out); }, [this] { return news_revision(); }, true},
      {[live](ToBrowser& out) {
         Questions& questions = *out.mutable_questions();
         if (live() != nullptr)
           encode_questions(live()->run().state(), live()->notes().asked(), live()->notes().question_texts(),
                            questions);
       },
       {},
       true},
      {[this](ToBrowser& out) { people_.roles().encode(*out.mutable_clients()); }, {}},
      {[this](ToBrowser& out) { *out.mutable_edits() = documents_.edit_state(); }, {}},
      {[live](ToBrowser& out) {
         Trails& trails = *out.mutable_trails();
         if (live() != nullptr) live()->notes().trails().encode(trails);
       },
       [this] { return run_.trails_revision(); }, true},
      {[this](ToBrowser& out) { std::as_const(run_).breakpoints().encode(*out.mutable_breakpoints()); }, {}},
      {[this](ToBrowser& out) { *out.mutable_halted() = run_.halted(); }, {}},
      {[live](ToBrowser& out) {
         HeldValues& held = *out.mutable_held_values();
         if (live() != nullptr) encode_held(live()->run(), held);
       },
       [this] { return run_.held_revision(); }, true},
      {[this](ToBrowser& out) { look_backs_.encode(*out.mutable_time_line()); },
       [this] { return look_backs_.line_revision(); }},
      {[this](ToBrowser& out) { bookmarks_.encode(*out.mutable_bookmarks()); },
       [this] { return bookmarks_.revision(); }},
      {[this](ToBrowser& out) { *out.mutable_journal() = chronicle_.message(); }, {}},
  };
}

void Publisher::greet(ConnectionId to) {
  people_.welcome(to);
  people_.send_log(people_.channels().at(to), log_);
  tell(to, false);
  if (look_backs_.is_recording()) return;
  ToBrowser out;
  out.mutable_moment()->set_is_now(true);
  people_.send(to, out);
}

void Publisher::tell(ConnectionId to, bool of_run_only) {
  people_.channels().at(to).status_seen = status_number_;
  for (const Topic& topic : topics_) {
    if (of_run_only && !topic.is_of_run) continue;
    // In a recording all that is of the run is of a moment, and LookBacks tells it.
    if (topic.is_of_run && look_backs_.is_recording()) continue;
    ToBrowser out;
    topic.tell(out);
    people_.send(to, out);
  }
}

void Publisher::publish() {
  for (const ConnectionId id : look_backs_.take_returned()) {
    if (people_.channels().contains(id)) tell(id, true);
  }
  look_backs_.publish();
  for (Topic& topic : topics_) publish(topic);
  publish_time();
  for (auto& [id, channel] : people_.channels()) people_.send_log(channel, log_);
  frames_.publish();
  people_.send_beats();
}

void Publisher::publish(Topic& topic) {
  ToBrowser out;
  if (topic.revision) {
    const std::uint64_t revision = topic.revision();
    if (topic.told == revision) return;
    topic.told = revision;
    if (people_.channels().empty()) return;
    topic.tell(out);
  } else {
    if (people_.channels().empty()) return;
    topic.tell(out);
    std::string bytes = out.SerializeAsString();
    if (topic.told_bytes == bytes) return;
    topic.told_bytes = std::move(bytes);
  }
  people_.broadcast(out, topic.is_of_run);
}

double Publisher::next() const {
  const bool is_held_back = run_.state_revision() != told_state_;
  return std::min(look_backs_.next(),
                  is_held_back ? last_status_ + kStatusApart : std::numeric_limits<double>::infinity());
}

// ---- the status

std::uint64_t Publisher::news_revision() {
  const double wall = wall_time();
  run_.look_at_machines();
  const std::uint64_t state = run_.state_revision();
  if (state == told_state_ || wall < last_status_ + kStatusApart) return told_state_;
  told_state_ = state;
  begin_status(wall);
  for (auto& [id, channel] : people_.channels()) channel.status_seen = status_number_;
  return told_state_;
}

void Publisher::publish_time() {
  const double wall = wall_time();
  if (run_.time_runs() && wall >= last_status_ + kStatusEvery) begin_status(wall);
  ToBrowser out;
  for (auto& [id, channel] : people_.channels()) {
    if (channel.looks_back || channel.status_seen == status_number_ || !channel.has_room()) continue;
    channel.status_seen = status_number_;
    if (!out.has_status()) tell_status(out);
    people_.send(id, out);
  }
}

void Publisher::begin_status(double wall) {
  ++status_number_;
  last_status_ = wall;
  look_at_world();
  frames_.update_watches();
}

void Publisher::tell_status(ToBrowser& out) const {
  Status& status = *out.mutable_status();
  const double wall = wall_time();
  if (const LiveRun* live = run_.live()) {
    encode_run(live->run(), live->notes().estimates(), status);
    encode_options(live->notes().options(), status);
  } else {
    status.set_seed(maker_.seed());
  }
  status.set_is_being_made(run_.is_expected());
  run_.vehicle_silence().add(wall, status);
  if (const preflight::Gate* gate = run_.gate()) encode_held_back(*gate, status);
  run_.teleoperations().encode(status);
  if (run_.is_stopped()) {
    const LiveRun* live = run_.live();
    status.set_mode(Status::STOPPED);
    status.mutable_stop()->set_robots(live != nullptr ? count_of(live->run().robots_in_world()) : 0);
    status.mutable_stop()->set_standing(live != nullptr ? count_of(live->run().robots_stopped()) : 0);
    for (std::string& name : run_.not_known_to_stand()) status.mutable_stop()->add_unreached(std::move(name));
  }
  for (const robot::SilentMachine& one : run_.silent_machines()) {
    Status::SilentMachine& told = *status.add_silent_machines();
    told.set_name(one.name);
    told.set_silent(one.silent);
    told.set_patience(one.patience);
    told.set_is_waited_for(one.is_waited_for);
    for (const base::RobotId robot : one.robots) told.add_robots(robot.value);
  }
  status.set_speed(run_.pace().speed());
  status.set_speed_reached(run_.meter().speed(wall));
  if (run_.time_runs()) status.set_behind(run_.pace().behind(wall, run_.sim_time()));
}

// ---- the scene

void Publisher::look_at_world() {
  const LiveRun* live = run_.live();
  const std::uint64_t key = live == nullptr ? 0 : obstacles_key(live->run().world());
  if (key == world_key_) return;
  world_key_ = key;
  ++world_changes_;
}

std::uint64_t Publisher::scene_revision() const {
  constexpr std::uint64_t kRoom = 1U << 20U;
  return documents_.scene().revision() * kRoom + world_changes_ % kRoom;
}

// What came into the world without standing in a text is shown after the rest.
void Publisher::tell_scene(ToBrowser& out) const {
  Scene& scene = *out.mutable_scene();
  scene = documents_.scene();
  scene.set_revision(scene_revision());
  if (run_.live() != nullptr) add_other_obstacles(run_.live()->run().world(), scene);
}

}  // namespace mlab::console
