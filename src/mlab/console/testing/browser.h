#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/console.pb.h"
#include "mlab/console/session.h"

namespace mlab::console::testing {

/// A session without sockets: what it sends is kept for each connection.
class TestSession {
 public:
  /// @param mission  below the folder of examples; empty: none
  explicit TestSession(const std::string& mission, double speed = 100.0,
                       const std::function<void(SessionSettings&)>& change = {}) {
    SessionSettings settings;
    settings.example_folder = base::source_folder() + "/missions";
    if (!mission.empty()) settings.mission = "examples:" + mission;
    settings.include_root = base::source_folder() + "/src";
    settings.permission = cell::testing::code_permitted();
    settings.version = "test";
    settings.speed = speed;
    if (change) change(settings);
    session_ = std::make_unique<Session>(
        std::move(settings), [this](ConnectionId to, const std::shared_ptr<const std::string>& bytes) {
          const std::scoped_lock lock(mutex_);
          mail_[to].push_back(bytes);
          arrived_.notify_all();
        });
  }
  Session* operator->() { return session_.get(); }
  Session& session() { return *session_; }

  ConnectionId connect() {
    const std::scoped_lock lock(mutex_);
    return {++last_connection_};
  }
  /// The next message to a connection; null where none comes in time.
  std::shared_ptr<const std::string> next(ConnectionId to, std::chrono::milliseconds most) {
    std::unique_lock lock(mutex_);
    arrived_.wait_for(lock, most, [&] { return !mail_[to].empty(); });
    if (mail_[to].empty()) return nullptr;
    auto bytes = mail_[to].front();
    mail_[to].pop_front();
    return bytes;
  }

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::map<ConnectionId, std::deque<std::shared_ptr<const std::string>>> mail_;
  std::uint32_t last_connection_ = 0;
  std::unique_ptr<Session> session_;  // ends first
};

/// What a browser knows of a session: the last of each message.
class Browser {
 public:
  explicit Browser(TestSession& session, std::string name, std::string key = "")
      : session_(session), connection_(session.connect()) {
    auto message = std::make_unique<ToServer>();
    message->mutable_hello()->set_protocol(1);
    message->mutable_hello()->set_name(name);
    message->mutable_hello()->set_client_key(key.empty() ? name : key);
    session_->receive(connection_, std::move(message));
  }
  ~Browser() { leave(); }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  void leave() {
    if (!std::exchange(has_left_, true)) session_->closed(connection_);
  }

  /// Takes messages until `is_true`; false where that does not come about in time.
  bool wait(const std::function<bool()>& is_true, double seconds = 60.0) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (!is_true()) {
      if (std::chrono::steady_clock::now() > end) return false;
      take_one(std::chrono::milliseconds(20));
    }
    return true;
  }
  /// Takes what comes in this time.
  void watch_for(double seconds) {
    wait([] { return false; }, seconds);
  }

  void send(std::unique_ptr<ToServer> message) { session_->receive(connection_, std::move(message)); }
  /// Sends a request and waits for its answer.
  Reply ask(ToServer message) {
    const std::uint32_t request = ++last_request_;
    message.set_request(request);
    send(std::make_unique<ToServer>(std::move(message)));
    wait([&] { return replies_.contains(request); }, 20.0);
    return replies_[request];
  }
  /// The answer's error; empty: it was done.
  std::string control(Control::Action action, std::uint32_t step = 0) {
    ToServer message;
    message.mutable_control()->set_action(action);
    message.mutable_control()->set_step(step);
    return error_of(ask(std::move(message)));
  }
  std::string type(const std::string& line) {
    ToServer message;
    message.mutable_typed()->set_line(line);
    return error_of(ask(std::move(message)));
  }
  std::string answer(std::uint32_t question, bool proceed) {
    ToServer message;
    message.mutable_answer()->set_question(question);
    message.mutable_answer()->set_proceed(proceed);
    return error_of(ask(std::move(message)));
  }
  static std::string error_of(const Reply& reply) {
    return reply.ok() ? "" : reply.error().empty() ? "no answer" : reply.error();
  }

  const Welcome& welcome() const { return welcome_; }
  const Status& status() const { return status_; }
  const Plan& plan() const { return plan_; }
  const Roster& roster() const { return roster_; }
  const Starts& starts() const { return starts_; }
  const Scene& scene() const { return scene_; }
  const Clients& clients() const { return clients_; }
  const Questions& questions() const { return questions_; }
  const Documents& documents() const { return documents_; }
  const EditState& edits() const { return edits_; }
  const Project& project() const { return project_; }
  const Trails& trails() const { return trails_; }
  const Frame& frame() const { return frame_; }
  const Breakpoints& breakpoints() const { return breakpoints_; }
  const Halted& halted() const { return halted_; }
  const HeldValues& held() const { return held_; }
  const Failsafes& failsafes() const { return failsafes_; }
  const Preflight& preflight() const { return preflight_; }
  const std::optional<Machines>& machines() const { return machines_; }  ///< nothing: was not told of any
  const TimeLine& time_line() const { return time_line_; }
  const Moment& moment() const { return moment_; }
  const Journal& journal() const { return journal_; }
  const Bookmarks& bookmarks() const { return bookmarks_; }
  const OtherFuture& other_future() const { return other_future_; }
  /// How the table stands for a robot, and how many frames told of it.
  const FailsafeStandings& standings(std::uint32_t robot) { return standings_[robot]; }
  std::uint64_t standings_count() const { return standings_count_; }
  const std::vector<Log::Entry>& log() const { return log_; }
  std::uint64_t frame_count() const { return frame_count_; }
  std::uint64_t alerts_after() const { return alerts_after_; }
  /// The number in the last beat, and how many came.
  std::uint64_t beat() const { return beat_; }
  std::uint64_t beat_count() const { return beat_count_; }
  /// What was asked is not looked at again until the session tells of it again.
  void forget_questions() { questions_.Clear(); }
  /// From now on; the last one, too.
  void acknowledge_frames(bool does) {
    acknowledges_ = does;
    acknowledge();
  }
  bool has_log(const std::string& text) const {
    for (const Log::Entry& entry : log_) {
      if (entry.text().find(text) != std::string::npos) return true;
    }
    return false;
  }

 private:
  void take_one(std::chrono::milliseconds most) {
    const auto bytes = session_.next(connection_, most);
    ToBrowser message;
    if (!bytes || !message.ParseFromString(*bytes)) return;
    switch (message.body_case()) {
      case ToBrowser::kWelcome:
        welcome_ = message.welcome();
        break;
      case ToBrowser::kReply:
        replies_[message.reply().request()] = message.reply();
        break;
      case ToBrowser::kFrame:
        take_frame(message.frame());
        break;
      case ToBrowser::kScene:
        scene_ = message.scene();
        break;
      case ToBrowser::kRoster:
        roster_ = message.roster();
        break;
      case ToBrowser::kStarts:
        starts_ = message.starts();
        break;
      case ToBrowser::kPlan:
        plan_ = message.plan();
        break;
      case ToBrowser::kStatus:
        status_ = message.status();
        break;
      case ToBrowser::kQuestions:
        questions_ = message.questions();
        break;
      case ToBrowser::kLog:
        if (message.log().is_whole()) log_.clear();
        alerts_after_ = message.log().alerts_after();
        log_.insert(log_.end(), message.log().entries().begin(), message.log().entries().end());
        break;
      case ToBrowser::kClients:
        clients_ = message.clients();
        break;
      case ToBrowser::kEdits:
        edits_ = message.edits();
        break;
      case ToBrowser::kOtherFuture:
        other_future_ = message.other_future();
        break;
      case ToBrowser::kDocuments:
        documents_ = message.documents();
        break;
      case ToBrowser::kProject:
        project_ = message.project();
        break;
      case ToBrowser::kTrails:
        trails_ = message.trails();
        break;
      case ToBrowser::kBreakpoints:
        breakpoints_ = message.breakpoints();
        break;
      case ToBrowser::kHeldValues:
        held_ = message.held_values();
        break;
      case ToBrowser::kPreflight:
        preflight_ = message.preflight();
        break;
      case ToBrowser::kMachines:
        machines_ = message.machines();
        break;
      case ToBrowser::kFailsafes:
        failsafes_ = message.failsafes();
        break;
      case ToBrowser::kTimeLine:
        time_line_ = message.time_line();
        break;
      case ToBrowser::kMoment:
        moment_ = message.moment();
        break;
      case ToBrowser::kHalted:
        halted_ = message.halted();
        break;
      case ToBrowser::kBookmarks:
        bookmarks_ = message.bookmarks();
        break;
      case ToBrowser::kJournal:
        journal_ = message.journal();
        break;
      case ToBrowser::kBeat:
        beat_ = message.beat().number();
        ++beat_count_;
        break;
      case ToBrowser::BODY_NOT_SET:
        break;
    }
  }
  void take_frame(const Frame& frame) {
    frame_ = frame;
    ++frame_count_;
    for (const FailsafeStandings& one : frame.failsafes()) {
      standings_[one.robot()] = one;
      ++standings_count_;
    }
    acknowledge();
  }
  void acknowledge() {
    if (!acknowledges_) return;
    auto message = std::make_unique<ToServer>();
    message->mutable_acknowledge()->set_frame(frame_.number());
    send(std::move(message));
  }

  TestSession& session_;
  ConnectionId connection_;
  bool has_left_ = false;
  bool acknowledges_ = true;
  std::uint32_t last_request_ = 0;
  std::map<std::uint32_t, Reply> replies_;
  Welcome welcome_;
  Status status_;
  Plan plan_;
  Roster roster_;
  Starts starts_;
  Scene scene_;
  Clients clients_;
  Questions questions_;
  Documents documents_;
  EditState edits_;
  Project project_;
  Trails trails_;
  Frame frame_;
  Breakpoints breakpoints_;
  Halted halted_;
  HeldValues held_;
  Failsafes failsafes_;
  Preflight preflight_;
  std::optional<Machines> machines_;
  TimeLine time_line_;
  Moment moment_;
  Journal journal_;
  Bookmarks bookmarks_;
  OtherFuture other_future_;
  std::map<std::uint32_t, FailsafeStandings> standings_;
  std::uint64_t standings_count_ = 0;
  std::vector<Log::Entry> log_;
  std::uint64_t frame_count_ = 0;
  std::uint64_t alerts_after_ = 0;
  std::uint64_t beat_ = 0;
  std::uint64_t beat_count_ = 0;
};

}  // namespace mlab::console::testing
