#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/console/breakpoints.h"
#include "mlab/console/channel.h"
#include "mlab/console/documents.h"
#include "mlab/console/event_log.h"
#include "mlab/console/frame_encoder.h"
#include "mlab/console/inbox.h"
#include "mlab/console/live_run.h"
#include "mlab/console/pace.h"
#include "mlab/console/project_folder.h"
#include "mlab/console/roles.h"
#include "mlab/console/session.h"
#include "mlab/console/teleoperations.h"
#include "mlab/console/workshop.h"

namespace mlab::console {

/// The session itself. But for what is marked, everything happens on its own thread, in `work`. The functions
/// stand in several files: session_loop.cc, session_receive.cc, session_control.cc,
/// session_teleoperation.cc, session_edit.cc, session_load.cc,
/// session_publish.cc.
class Session::Parts {
 public:
  Parts(SessionSettings settings, Send send);
  ~Parts();
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  // ---- from any thread

  void receive(ConnectionId from, std::unique_ptr<ToServer> message);
  void closed(ConnectionId connection);
  void emergency_stop();
  void try_out(Trial trial, TrialDone done);
  void look_at_run(RunLook look);
  Picture picture(std::uint64_t revision) const;
  std::string report();
  std::vector<std::string> end();
  bool has_ended() const { return has_ended_; }

 private:
  /// What a request is answered with; an error is one sentence.
  using Answered = std::optional<std::string>;

  // ---- session_loop.cc

  void work();
  void open_first_mission();
  double now() const;
  double sim_time() const { return live_ ? live_->run().time() : 0.0; }
  void engage_emergency_stop();
  /// Lets as much time pass as is due, but not for longer than a person would notice.
  void advance();
  bool is_active() const;
  bool attend_during_cycle();
  /// When the loop has to look around again [s].
  double next_wake() const;

  // ---- session_receive.cc

  void take(ConnectionId from, const ToServer& message);
  void take_hello(ConnectionId from, const Hello& hello, std::uint32_t request);
  void greet(ConnectionId to);
  void take_as_client(Channel& channel, const Roles::Client& client, const ToServer& message);
  /// Requests that only the operator may make.
  Answered take_as_operator(const std::string& who, const ToServer& message, Reply& reply);
  /// Requests that anybody may make.
  Answered take_from_anybody(Channel& channel, const Roles::Client& client, const ToServer& message,
                             Reply& reply);
  Answered list_files(const ListFiles& list, Reply& reply) const;
  Answered take_ownership(const Roles::Client& client, const ToServer& message);
  void take_closed(ConnectionId connection);

  // ---- session_control.cc

  Answered control(const std::string& who, const Control& control);
  Answered set_speed(const std::string& who, double speed);
  Answered answer(const std::string& who, const Answer& answer);
  Answered typed(const std::string& who, const Typed& typed, Reply& reply);
  Answered set_option(const std::string& who, const SetOption& option);
  void release_stop(const std::string& who);
  void single_step();
  void skip_step();
  void single_cycle();
  /// The mission has ended, and begins anew: trails and alerts are of before.
  void forget_earlier_run();
  /// Why no command can be given now.
  Answered why_not_now() const;
  void post(const mission::Event& event);
  void note(const std::string& who, const std::string& what);

  // ---- session_breakpoints.cc

  Answered set_breakpoint(const std::string& who, const SetBreakpoint& set, Reply& reply);
  Answered remove_breakpoint(const std::string& who, const RemoveBreakpoint& remove);
  /// One control cycle. False where no time passed.
  bool step_once();
  /// Pauses where a breakpoint wants it.
  void look_at_breakpoints();
  void publish_breakpoints();
  void greet_with_breakpoints(ConnectionId to);

  // ---- session_teleoperation.cc

  Answered start_teleoperation(const std::string& who, const StartTeleoperation& start);
  Answered end_teleoperation(const std::string& who, const EndTeleoperation& end);
  void update_teleoperations();

  // ---- session_edit.cc

  Answered edit(const std::string& who, const ToServer& message);
  Answered open(const std::string& who, const std::string& path);
  void keep_drafts();
  void tell_not_kept();
  Answered set_parameter(const std::string& who, const SetParameter& set);
  /// Sets parameters of robots to these texts, now and in every later run. @errors  nothing has changed then
  Answered apply_parameters(const std::vector<std::uint32_t>& robots, const std::string& port,
                            const std::vector<std::string>& values);
  /// After the documents have changed: tells it, and brings the run to what they say.
  enum class Follow { kGoesOn, kAnew };
  void follow_documents(Follow how = Follow::kGoesOn);
  /// The run goes on with another version of its mission.
  /// @return false: what it needs is being made, it will happen later
  bool change_mission(std::shared_ptr<const mission::Mission> plain);
  void update_picture();

  // ---- session_load.cc

  /// The run is made anew from the documents' mission, on the workshop's thread.
  /// @param known  programs that need not be built again; null: none
  void load(std::uint64_t seed, const std::shared_ptr<const fleet::Crew>& known = nullptr);
  void start_trial(const Trial& trial, TrialDone done);
  /// Tells who asked for the trial how it stands; at most once.
  void answer_trial(const std::string& error, const text::Diagnostics& problems);
  void adopt(std::shared_ptr<const fleet::Crew> crew, std::unique_ptr<fleet::MissionRun> run);
  void report_problems(const text::Diagnostics& problems);
  robot::ProgramSources program_sources() const;
  mdl::LoadOptions load_options() const;

  // ---- session_publish.cc

  void publish();
  void publish_state();
  void publish_frames();
  void publish_log(Channel& channel);
  void publish_beats();
  void send_beat(const Channel& channel);
  void send(ConnectionId to, const ToBrowser& message);
  void broadcast(const ToBrowser& message);
  Status status_message() const;
  void fill_roster(ToBrowser& out) const;
  void fill_plan(ToBrowser& out) const;
  void fill_starts(ToBrowser& out);
  void fill_questions(ToBrowser& out) const;
  void fill_scene(ToBrowser& out) const;
  /// Obstacles may come and go by themselves.
  void look_at_world();
  /// Who has been started is no longer shown where it will be.
  void look_at_starts();
  void fill_frame(Channel& channel, Frame& out);
  void fill_details(const Watch& watch, Frame& out);
  void fill_series(Channel& channel, SeriesData& out);
  void read_series(const ReadSeries& read, Reply& reply) const;
  /// Who looks at what decides what is recorded.
  void update_watches();

  /// What has changed and is to be sent to all.
  struct Changes {
    bool project = false;
    bool documents = false;
    bool scene = false;
    bool roster = false;
    bool plan = false;
    bool starts = false;
    bool status = false;
    bool questions = false;
    bool clients = false;
    bool edits = false;
    bool trails = false;
  };

  const SessionSettings settings_;
  const Send send_;
  Inbox inbox_;
  double published_during_cycle_ = 0.0;
  std::atomic<bool> ends_ = false;
  std::atomic<bool> stop_wanted_ = false;
  std::atomic<bool> has_ended_ = false;
  mutable std::mutex picture_mutex_;
  Picture picture_;
  std::uint64_t picture_revision_ = 0;

  ProjectFolder project_;
  OpenDocuments documents_;
  std::string not_kept_;      // as it was told last
  std::string session_name_;  // another one each time the server is started
  EventLog log_;
  Roles roles_;
  std::map<ConnectionId, Channel> channels_;
  std::unique_ptr<LiveRun> live_;
  /// Number of the last load or change of the mission; what older ones bring is thrown away.
  std::atomic<std::uint64_t> loading_ = 0;
  bool is_loading_ = false;
  std::uint64_t seed_ = 1;
  std::uint64_t plan_revision_ = 0;
  std::shared_ptr<const text::Files> trial_files_;  // that programs of a trial are read with
  TrialDone trial_done_;                            // who waits for it; empty: nobody
  bool executes_trial_ = false;
  std::shared_ptr<const mission::Mission> from_documents_;  // that the run follows
  std::shared_ptr<const mission::Mission> plain_;           // the same with what was typed
  std::vector<std::string> typed_edits_;                    // lines that added to the mission
  std::map<std::uint32_t, std::map<std::string, std::string>>
      parameters_;                  // that people set, by robot and port
  std::uint64_t world_key_ = 0;     // of the obstacles that the scene has
  std::size_t not_started_ = 0;     // robots, when the starts were told last
  std::uint64_t scene_extras_ = 0;  // how often obstacles came that no document has
  Teleoperations teleoperations_;
  struct Sentences {
    double wall = -1e9;  ///< when they were made
    std::vector<std::string> lines;
  };
  std::map<std::uint32_t, Sentences> sentences_;  // what robots that are looked at wait for

  BreakpointTable breakpoints_;
  Halted halted_;            // at these hits; without any: at none
  std::string halted_told_;  // to all, serialised
  Pace pace_;
  SpeedMeter meter_;
  bool is_stopped_ = false;         // emergency stop
  bool time_runs_ = false;          // cycles are being run, paced from when this began
  bool has_nothing_to_do_ = false;  // the run waits for a person; nothing but a message changes that
  RobotRows rows_;
  std::uint64_t rows_version_ = 0;  // of the world in `rows_`
  std::uint64_t version_ = 1;       // of the world: grows with every cycle and edit
  Changes changes_;
  double last_status_ = -1e9;
  double last_beats_ = -1e9;
  double began_ = 0.0;
  std::string started_at_;

  std::stop_source jobs_end_;           // stops a C++ compiler that a job waits for
  std::unique_ptr<Workshop> workshop_;  // ends before everything that its jobs report to
  std::thread thread_;
};

}  // namespace mlab::console
