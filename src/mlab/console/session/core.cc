#include "mlab/console/session/core.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <future>
#include <random>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/published/status_encoder.h"
#include "mlab/console/session/order.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/run/report.h"

namespace mlab::console {
namespace {

constexpr std::uint32_t kProtocol = 1;
// The loop looks around at least so often [s].
constexpr double kIdle = 0.25;
// How long a person waits for a cycle that some robot's own process does not come to an end with [s].
constexpr double kCyclePatience = 3.0;
constexpr double kPublishing = 0.05;  // while a cycle is waited for [s]

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

std::string clock_now() {
  const mission::ExecutiveOptions wall = {.epoch_seconds = static_cast<double>(std::time(nullptr))};
  return clock_time(wall, 0.0);
}

// Another session each time the server is started.
Welcome welcome_of(const SessionSettings& settings) {
  Welcome out;
  out.set_protocol(kProtocol);
  out.set_version(settings.version);
  out.set_session(fmt::format("{:08x}", std::random_device{}()));
  out.set_may_compile(settings.permission.takes_new_code());
  if (settings.tiles) {
    const tiles::Description& map = settings.tiles->description();
    Tiles& tiles = *out.mutable_tiles();
    tiles.set_least_zoom(static_cast<std::uint32_t>(map.least_zoom));
    tiles.set_most_zoom(static_cast<std::uint32_t>(map.most_zoom));
    tiles.set_south(map.south);
    tiles.set_west(map.west);
    tiles.set_north(map.north);
    tiles.set_east(map.east);
    tiles.set_attribution(map.attribution);
  }
  return out;
}

// What the designer keeps of configurations that are not saved.
documents::Drafts designs_of(const SessionSettings& settings, const documents::ProjectFolder& project) {
  const std::string& folder = settings.state_folder;
  return {folder.empty() ? "" : folder + "/designer", project.folder()};
}

}  // namespace

SessionCore::SessionCore(SessionSettings settings, Session::Send send)
    : settings_(std::move(settings)),
      began_(wall_time()),
      started_at_(clock_now()),
      project_({settings_.project_folder, settings_.example_folder}),
      documents_(project_, load_options(), settings_.state_folder),
      people_(welcome_of(settings_), std::move(send)),
      run_(
          log_, settings_.speed, settings_.run.stop_line, [this] { inbox_.wake(); }, settings_.gate),
      preflight_orders_({settings_, run_, people_, inbox_}),
      parameters_(run_, documents_, log_),
      bookmark_orders_({settings_, run_, log_, bookmarks_}),
      chronicle_({settings_, documents_, run_, people_, log_, bookmarks_.bookmarks}),
      maker_({settings_, documents_, run_, parameters_, log_, inbox_, chronicle_},
             [this] { return attend_during_cycle(); }),
      resumption_({documents_, run_, people_, maker_, chronicle_, bookmark_orders_, log_}),
      document_orders_({documents_, project_, run_, maker_, log_}, settings_.tell_not_kept),
      name_orders_(documents_, document_orders_, maker_,
                   {designs_of(settings_, project_), "in the designer"}),
      // So that it stays known what was executed.
      run_orders_(run_, log_, [this] { document_orders_.sync_drafts(); }),
      failsafe_trials_(run_),
      look_backs_({settings_, documents_, chronicle_, run_, people_, log_, inbox_}),
      other_futures_({settings_, look_backs_, run_, people_, inbox_}),
      frames_(run_, people_),
      machines_(settings_.machines),
      publisher_({people_, documents_, run_, maker_, frames_, log_, look_backs_, chronicle_, bookmark_orders_,
                  preflight_orders_, machines_}),
      measuring_({people_, run_, log_, settings_.version}),
      thread_([this] { work(); }) {}

SessionCore::~SessionCore() {
  end();
}

std::vector<std::string> SessionCore::end() {
  ends_ = true;
  inbox_.wake();
  if (thread_.joinable()) thread_.join();
  other_futures_.end();
  look_backs_.end();
  maker_.end();
  preflight_orders_.end();
  return documents_.losses();
}

mdl::LoadOptions SessionCore::load_options() const {
  mdl::LoadOptions options;
  options.seed = settings_.run.seed;
  options.overlay_folders = settings_.overlay_folders;
  options.societies = [this](const std::string& program, const text::Place& place, text::Diagnostics& sink) {
    return robot::society_reader(maker_.program_sources())(program, place, sink);
  };
  return options;
}

// ---- from any thread

Session::Picture SessionCore::tile(std::uint32_t zoom, std::uint32_t column, std::uint32_t row) const {
  if (!settings_.tiles) return {};
  tiles::Tile tile = settings_.tiles->find(zoom, column, row);
  return {std::move(tile.content_type), std::move(tile.bytes)};
}

void SessionCore::receive(ConnectionId from, std::unique_ptr<ToServer> message) {
  if (message->has_emergency_stop()) emergency_stop();  // overtakes whatever waits before it
  const Inbox::Kind kind = Order::kind_of(*message);
  inbox_.post([this, from, kept = std::shared_ptr<const ToServer>(std::move(message))] { take(from, *kept); },
              kind);
}

void SessionCore::closed(ConnectionId connection) {
  inbox_.post([this, connection] {
    people_.leave(connection);
    look_backs_.forget(connection);
    other_futures_.forget(connection);
    frames_.update_watches();
  });
}

void SessionCore::emergency_stop() {
  run_.want_stop();
  inbox_.wake();
}

void SessionCore::try_out(Trial trial, TrialDone done) {
  inbox_.post([this, trial = std::move(trial), done = std::move(done)] { maker_.start_trial(trial, done); });
}

void SessionCore::look_at_run(RunLook look) {
  inbox_.post(
      [this, look = std::move(look)] { look(run_.live() != nullptr ? &run_.live()->run() : nullptr); });
}

std::string SessionCore::report() {
  const auto answer = std::make_shared<std::promise<std::string>>();
  std::future<std::string> report = answer->get_future();
  inbox_.post([this, answer] {
    if (run_.live() == nullptr) {
      answer->set_value("");
      return;
    }
    const run::MissionRun& run = run_.live()->run();
    run::Performance performance;
    performance.wall_seconds = wall_time() - began_;
    performance.cpu_seconds = cpu_seconds();
    performance.started_at = started_at_;
    performance.program_version = settings_.version;
    performance.mission_clock = clock_time(run.state().options, 0.0);
    answer->set_value(run::report_json(run, performance, run::RunEnd::kInterrupted));
  });
  constexpr std::chrono::seconds kMost{5};
  return report.wait_for(kMost) == std::future_status::ready ? report.get() : "";
}

// ---- on the session's thread

void SessionCore::work() {
  open_first_mission();
  while (!ends_) {
    do_tasks(inbox_.wait_until(moment(next_wake())));
    run_.heed_stop();
    people_.forget();
    run_.update_teleoperations();
    run_.advance();
    run_.update_teleoperations();
    if (run_.live() != nullptr && run_.live()->run().is_over()) has_ended_ = true;
    chronicle_.keep();
    bookmark_orders_.keep();
    document_orders_.keep_drafts();
    document_orders_.look_at_disk();
    picture_.follow(documents_, project_);
    preflight_orders_.follow();
    publisher_.publish();
    measuring_.look();
  }
  chronicle_.keep_now();
  bookmark_orders_.keep(true);
  documents_.store().sync_drafts(wall_time());
}

void SessionCore::do_tasks(const std::vector<Inbox::Task>& tasks) {
  for (const Inbox::Task& task : tasks) {
    run_.heed_stop();
    task();
    frames_.follow_run();
    look_backs_.follow_run();
    bookmark_orders_.follow_run();
    other_futures_.follow_run();
  }
}

void SessionCore::open_first_mission() {
  if (settings_.recording.history) {
    look_backs_.open(settings_.recording.history);
    bookmark_orders_.open_recording();
    if (settings_.against.history) other_futures_.compare(settings_.against);
    return;
  }
  const Answered not_resumed = settings_.resume.empty() ? std::nullopt : resumption_.resume(settings_.resume);
  if (not_resumed) log_.add(0.0, {Log::WARNING, *not_resumed, 0, "", {}, true});
  chronicle_.look();
  const bool is_resumed = !settings_.resume.empty() && !not_resumed;
  if (settings_.mission.empty() || is_resumed) return;
  const bool is_example = settings_.mission.starts_with("examples:");
  const text::Result<bool> opened = is_example ? documents_.open(settings_.mission, wall_time())
                                               : documents_.open_on_disk(settings_.mission, wall_time());
  if (opened)
    maker_.follow_other_mission();
  else
    log_.add(0.0, {Log::WARNING, opened.error().message, 0, "", {}, true});
}

double SessionCore::next_wake() {
  return std::min({wall_time() + kIdle, publisher_.next(), run_.next_cycle(), frames_.next_frame(),
                   run_.teleoperations().next_release().value_or(wall_time() + kIdle)});
}

// Whatever leaves the run alone is done meanwhile.
bool SessionCore::attend_during_cycle() {
  run_.heed_stop();
  for (const Inbox::Task& task : inbox_.take_for_cycle()) task();
  if (wall_time() - published_during_cycle_ > kPublishing) {
    publisher_.publish();
    published_during_cycle_ = wall_time();
  }
  return ends_ || inbox_.wants_cycle_over(kCyclePatience);
}

// ---- messages

void SessionCore::take(ConnectionId from, const ToServer& message) {
  ToBrowser out;
  Reply& reply = *out.mutable_reply();
  reply.set_request(message.request());
  const std::optional<Sender> sender = people_.find(from);
  const Order order = Order::of(message.body_case());
  Answered error;
  bool wants_answer = message.request() != 0;
  if (message.has_hello()) {
    error = hello(from, message);
    wants_answer = wants_answer || error;
  } else if (!sender) {
    error = "a connection begins with Hello";
    wants_answer = true;
  } else if (order.take == nullptr) {
    error = "this request is not known here";
  } else if (Order::is_for_operator(message) && !people_.roles().is_operator(sender->client.id)) {
    error = people_.why_no_operator(sender->client);
  } else if (auto why = why_no_order(from, message)) {
    error = why;
  } else {
    if (order.from != Order::From::kAnybody) run_.look_again();
    error = order.take(*this, *sender, message, reply);
    if (Order::is_to_be_kept(message)) keep_what_is_acknowledged(message, reply);
    if (!error && order.answers_later) return;
  }
  if (!wants_answer) return;
  reply.set_ok(!error.has_value());
  if (error) reply.set_error(*error);
  people_.send(from, out);
}

void SessionCore::keep_what_is_acknowledged(const ToServer& message, Reply& reply) {
  chronicle_.keep_now(message.has_save_documents() ? journal::Reach::kMachine : journal::Reach::kProcess);
  reply.set_not_saved(chronicle_.not_saved());
}

Answered SessionCore::hello(ConnectionId from, const ToServer& message) {
  if (auto error = people_.join(from, message.hello())) return error;
  publisher_.greet(from);
  look_backs_.begin(*people_.find(from));
  other_futures_.begin(from);
  return std::nullopt;
}

Answered SessionCore::control(const Sender& sender, const Control& control) {
  if (control.action() == Control::RESTART) return maker_.restart(sender, control);
  return run_orders_.control(sender, control);
}

Answered SessionCore::why_no_order(ConnectionId from, const ToServer& message) const {
  if (!Order::is_for_operator(message)) return std::nullopt;
  const Order::From from_whom = Order::of(message.body_case()).from;
  if (from_whom == Order::From::kOperatorEver) return std::nullopt;
  const bool is_of_run = from_whom == Order::From::kOperatorNow;
  return is_of_run || look_backs_.is_recording() ? look_backs_.why_no_order(from) : std::nullopt;
}

Answered SessionCore::take_operator(const Sender& sender) {
  if (people_.take_operator(sender.client)) run_.note(sender.client.name, "is the operator");
  return std::nullopt;
}

Answered SessionCore::pass_operator(const Sender& sender, const PassOperator& pass) {
  const std::uint32_t before = people_.roles().operator_id();
  if (auto error = people_.pass_operator(sender.client, pass.client())) return error;
  const std::uint32_t now = people_.roles().operator_id();
  if (now != before) run_.note(people_.roles().find(now)->name, "is the operator");
  return std::nullopt;
}

}  // namespace mlab::console
