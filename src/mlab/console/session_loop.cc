#include <algorithm>
#include <chrono>
#include <ctime>
#include <future>
#include <random>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/session_parts.h"
#include "mlab/console/status_encoder.h"
#include "mlab/fleet/report.h"
#include "mlab/robot/configuration_file.h"

namespace mlab::console {
namespace {

// The loop looks around at least so often while cycles run [s].
constexpr double kSlice = 0.008;
// And so often while nothing happens.
constexpr double kIdle = 0.25;

std::chrono::steady_clock::time_point moment(double seconds) {
  using std::chrono::duration;
  using Clock = std::chrono::steady_clock;
  return Clock::time_point(std::chrono::duration_cast<Clock::duration>(duration<double>(seconds)));
}

double cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

// How long a person waits for a cycle that some robot's own process does not come to an end with [s].
constexpr double kCyclePatience = 3.0;
constexpr double kPublishing = 0.05;  // [s]

Inbox::Kind kind_of(const ToServer& message) {
  switch (message.body_case()) {
    case ToServer::kAcknowledge:
    case ToServer::kBeat:
    case ToServer::kEmergencyStop:
      return Inbox::Kind::kAtOnce;
    case ToServer::kSaveDocuments:
    case ToServer::kReadSeries:
    case ToServer::kComplete:
    case ToServer::kCheck:
    case ToServer::kListFiles:
    case ToServer::kTakeOperator:
    case ToServer::kPassOperator:
      return Inbox::Kind::kDuringCycle;
    case ToServer::kOpenMission:
      return Inbox::Kind::kEndsWait;
    case ToServer::kControl:
      return message.control().action() == Control::ABORT || message.control().action() == Control::RESTART
                 ? Inbox::Kind::kEndsWait
                 : Inbox::Kind::kAfterCycle;
    default:
      return Inbox::Kind::kAfterCycle;
  }
}

}  // namespace

mdl::LoadOptions Session::Parts::load_options() const {
  mdl::LoadOptions options;
  options.seed = settings_.run.seed;
  options.overlay_folders = settings_.overlay_folders;
  options.societies = [this](const std::string& program, const text::Place& place, text::Diagnostics& sink) {
    return robot::society_reader(program_sources())(program, place, sink);
  };
  return options;
}

Session::Parts::Parts(SessionSettings settings, Send send)
    : settings_(std::move(settings)),
      send_(std::move(send)),
      project_({settings_.project_folder, settings_.example_folder}),
      documents_(project_, load_options(), settings_.state_folder),
      session_name_(fmt::format("{:08x}", std::random_device{}())),
      seed_(settings_.run.seed),
      pace_(settings_.speed),
      workshop_(std::make_unique<Workshop>()) {
  const mission::ExecutiveOptions wall = {.epoch_seconds = static_cast<double>(std::time(nullptr))};
  started_at_ = clock_time(wall, 0.0);
  began_ = now();
  thread_ = std::thread([this] { work(); });
}

Session::Parts::~Parts() {
  end();
}

std::vector<std::string> Session::Parts::end() {
  ends_ = true;
  inbox_.wake();
  if (thread_.joinable()) thread_.join();
  jobs_end_.request_stop();
  workshop_.reset();
  return documents_.losses();
}

double Session::Parts::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// ---- from any thread

void Session::Parts::receive(ConnectionId from, std::unique_ptr<ToServer> message) {
  if (message->has_emergency_stop()) emergency_stop();  // overtakes whatever waits before it
  const Inbox::Kind kind = kind_of(*message);
  inbox_.post([this, from, kept = std::shared_ptr<const ToServer>(std::move(message))] { take(from, *kept); },
              kind);
}

void Session::Parts::closed(ConnectionId connection) {
  inbox_.post([this, connection] { take_closed(connection); });
}

void Session::Parts::emergency_stop() {
  stop_wanted_ = true;
  inbox_.wake();
}

Session::Picture Session::Parts::picture(std::uint64_t revision) const {
  const std::scoped_lock lock(picture_mutex_);
  return revision == picture_revision_ ? picture_ : Picture{};
}

std::string Session::Parts::report() {
  const auto answer = std::make_shared<std::promise<std::string>>();
  std::future<std::string> report = answer->get_future();
  inbox_.post([this, answer] {
    fleet::Performance performance;
    performance.wall_seconds = now() - began_;
    performance.cpu_seconds = cpu_seconds();
    performance.started_at = started_at_;
    performance.program_version = settings_.version;
    if (live_) performance.mission_clock = clock_time(live_->run().state().options, 0.0);
    answer->set_value(live_ ? fleet::report_json(live_->run(), performance, fleet::RunEnd::kInterrupted)
                            : "");
  });
  constexpr std::chrono::seconds kMost{5};
  return report.wait_for(kMost) == std::future_status::ready ? report.get() : "";
}

// ---- on the session's thread

void Session::Parts::work() {
  open_first_mission();
  while (!ends_) {
    for (const Inbox::Task& task : inbox_.wait_until(moment(next_wake()))) {
      if (stop_wanted_.exchange(false)) engage_emergency_stop();
      task();
    }
    if (stop_wanted_.exchange(false)) engage_emergency_stop();
    if (roles_.forget(now())) changes_.clients = true;
    update_teleoperations();
    advance();
    update_teleoperations();
    if (live_ && live_->run().is_over()) has_ended_ = true;
    keep_drafts();
    publish();
  }
  documents_.sync_drafts(now());
}

void Session::Parts::open_first_mission() {
  changes_.project = true;
  if (settings_.mission.empty()) return;
  const bool is_example = settings_.mission.starts_with("examples:");
  const text::Result<bool> opened = is_example ? documents_.open(settings_.mission, now())
                                               : documents_.open_on_disk(settings_.mission, now());
  if (!opened) {
    log_.add(0.0, {Log::WARNING, opened.error().message, 0, "", {}, true});
    return;
  }
  follow_documents(Follow::kAnew);
}

double Session::Parts::next_wake() const {
  const double wall = now();
  double next = wall + kIdle;
  if (changes_.status) next = std::min(next, last_status_ + 0.05);
  if (is_active() && !has_nothing_to_do_) next = std::min(next, pace_.due(sim_time()));
  next = std::min(next, teleoperations_.next_release().value_or(next));
  for (const auto& [id, channel] : channels_) {
    if (channel.seen != version_) next = std::min(next, channel.next_frame());
  }
  return next;
}

// Called within a cycle, while a robot's own process computes: whatever leaves the run alone is done
// meanwhile.
bool Session::Parts::attend_during_cycle() {
  if (stop_wanted_.exchange(false)) engage_emergency_stop();
  for (const Inbox::Task& task : inbox_.take_for_cycle()) task();
  if (now() - published_during_cycle_ > kPublishing) {
    publish();
    published_during_cycle_ = now();
  }
  return ends_ || inbox_.wants_cycle_over(kCyclePatience);
}

bool Session::Parts::is_active() const {
  if (!live_ || is_loading_) return false;
  const mission::State& state = live_->run().state();
  return is_stopped_ || (state.mode == mission::State::Mode::kRunning && !state.paused);
}

void Session::Parts::engage_emergency_stop() {
  if (is_stopped_) return;
  is_stopped_ = true;
  if (live_) {
    live_->run().set_emergency_stop(true);
    teleoperations_.let_go(live_->run());
  }
  has_nothing_to_do_ = false;
  time_runs_ = false;
  log_.add(sim_time(), {Log::OPERATOR, "emergency stop: all robots stand", 0, "", {}, true});
  changes_.status = true;
  ++version_;
}

void Session::Parts::advance() {
  if (!is_active() || has_nothing_to_do_) {
    time_runs_ = false;
    return;
  }
  const double began = now();
  if (!std::exchange(time_runs_, true)) pace_.start(began, sim_time());
  double wall = began;
  while (wall - began < kSlice && pace_.due(sim_time()) <= wall) {
    if (stop_wanted_.exchange(false)) engage_emergency_stop();
    if (!step_once()) {
      has_nothing_to_do_ = true;
      if (is_stopped_) changes_.status = true;  // all stand
      break;
    }
    wall = now();
    if (!is_active()) break;
  }
  meter_.note(wall, sim_time());
  pace_.forgive(wall, sim_time());
}

}  // namespace mlab::console
