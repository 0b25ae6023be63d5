// `mlab run` without --headless: a session, the server that shows it, and a terminal that says where.

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/agents/ending_watchdog.h"
#include "mlab/base/counted.h"
#include "mlab/cli/browser.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/input.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/kept_address.h"
#include "mlab/cli/other_language.h"
#include "mlab/cli/output.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/recorded_run.h"
#include "mlab/cli/resumable.h"
#include "mlab/cli/run_settings.h"
#include "mlab/cli/runs_folder.h"
#include "mlab/cli/terminal.h"
#include "mlab/cli/version.h"
#include "mlab/console.pb.h"
#include "mlab/console/server/server.h"
#include "mlab/console/session.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/designer.h"
#include "mlab/documents/draft_place.h"
#include "mlab/documents/project_folder.h"
#include "mlab/documents/state_folder.h"
#include "mlab/lang/envchange/envchange.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/metrics/process.h"
#include "mlab/text/shown.h"
#include "mlab/tiles/map_tiles.h"

namespace mlab::cli {
namespace {

namespace fs = std::filesystem;

// What comes by a socket of the server goes to the one who is spoken to by it.
template <class Message>
console::SocketHandlers socket_of(auto& listener) {
  return {[&listener](console::ConnectionId from, std::string_view bytes) {
            auto message = std::make_unique<Message>();
            if (!message->ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return false;
            listener.receive(from, std::move(message));
            return true;
          },
          [&listener](console::ConnectionId connection) { listener.closed(connection); }};
}

constexpr double kConsoleSpeed = 10.0;
constexpr std::uint16_t kUsualPort = 8642;

int interrupt = -1;  // eventfd that the signal handler writes to

void on_interrupt(int) {
  note_interrupt();
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(interrupt, &one, sizeof one);
}

// From here on Ctrl-C, the end of the terminal and `kill` are waited for.
bool listen_for_interrupts() {
  interrupt = ::eventfd(0, EFD_CLOEXEC);
  if (interrupt < 0) return false;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, on_interrupt);
  return true;
}

void wait_for_interrupt() {
  pollfd descriptor{interrupt, POLLIN, 0};
  while (!was_interrupted()) ::poll(&descriptor, 1, -1);
}

std::optional<std::uint16_t> port_of(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return port;
}

// ADDRESS, ADDRESS:PORT, [ADDRESS]:PORT; an IPv6 address without brackets has no port.
bool read_listen(const std::string& text, console::ServerSettings& out) {
  std::string_view address = text;
  std::string_view port;
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    if (end == std::string::npos) return false;
    address = std::string_view(text).substr(1, end - 1);
    port = std::string_view(text).substr(end + 1);
    if (!port.empty() && !port.starts_with(':')) return false;
  } else if (const std::size_t colon = text.find(':');
             colon != std::string::npos && colon == text.rfind(':')) {
    address = std::string_view(text).substr(0, colon);
    port = std::string_view(text).substr(colon);
  }
  out.address = address == "localhost" ? "127.0.0.1" : std::string(address);
  if (port.empty()) return true;
  const std::optional<std::uint16_t> number = port_of(port.substr(1));
  if (number) out.ports = {*number};
  return number.has_value();
}

std::optional<console::ServerSettings> server_settings(const RunOptions& options) {
  console::ServerSettings out;
  out.ports =
      options.port ? std::vector<std::uint16_t>{*options.port} : std::vector<std::uint16_t>{kUsualPort, 0};
  if (!options.listen.empty() && !read_listen(options.listen, out)) {
    usage_error(
        fmt::format("--listen {}: expected an IP address of this machine, as 192.168.1.5 or 0.0.0.0:8642",
                    options.listen));
    return std::nullopt;
  }
  out.certificate = options.certificate;
  out.key = options.key;
  out.web_folder = web_folder();
  return out;
}

// What an open page knows of the last server is good for this one, where it gets the same port. Whoever has
// that port by now may have been told the token, so on another one there is a new one.
void take_over(const KeptAddress& kept, const RunOptions& options, console::ServerSettings& out) {
  if (kept.found() == KeptAddress::Lookup::kUnsafe)
    fmt::print(stderr, "mlab: warning: the address of the last start is not used again: {}\n",
               kept.problem());
  if (kept.found() != KeptAddress::Lookup::kAddress || kept.address().host != out.address) return;
  const bool may_choose = out.ports.size() > 1;
  if (may_choose) out.ports.insert(out.ports.begin(), kept.address().port);
  if (options.new_token) return;
  out.token = kept.address().token;
  out.token_port = kept.address().port;
}

// The mission, for what the terminal says about it; what is wrong with it is shown here and in the console.
struct Look {
  std::shared_ptr<const mission::Mission> mission;
  std::size_t warnings = 0;
  bool is_readable = true;  ///< there is such a file
  bool is_usable = true;    ///< what else the command line names could be read
};

Look look_at(const RunOptions& options, run::RunSettings& settings) {
  Look out;
  if (options.mission.empty()) return out;
  text::Diagnostics sink;
  std::error_code error;
  out.is_readable = fs::is_regular_file(options.mission, error);
  out.mission = mdl::load_mission(options.mission, sink, load_options(options, mission_sources(options, {})));
  if (out.mission && !options.environment.empty()) {
    const auto changes = envchange::load(options.environment, out.mission->overlay.origin, sink);
    out.is_usable = changes.has_value() && !sink.has_errors();
    settings.environment = changes.value_or(overlay::EnvironmentChanges{});
  }
  if (const std::string problem =
          out.mission ? problem_with_outputs(outputs_of(options), files_read_for(*out.mission, nullptr)) : "";
      !problem.empty()) {
    out.is_usable = false;
    sink.error("output-is-read", {}, problem);
  }
  tell(told_of_run(sink, options));
  out.warnings = sink.warning_count();
  return out;
}

/// Says at this terminal when what is not saved begins or ceases to be kept. Two threads may tell it.
class KeepingTold {
 public:
  explicit KeepingTold(std::string folder) : folder_(std::move(folder)) {}

  /// @param why  it is not kept; empty: it is
  void tell(const std::string& who, const std::string& why) {
    const std::scoped_lock lock(mutex_);
    const bool was_kept = is_kept();
    why_[who] = why;
    if (!why.empty() && why != told_)
      fmt::print(stderr, "mlab: warning: what is not saved is not kept: {}{}\n", why,
                 folder_.empty() ? "" : fmt::format(" (in {})", folder_));
    if (!was_kept && is_kept()) fmt::print(stderr, "mlab: what is not saved is kept again\n");
    told_ = is_kept() ? "" : why.empty() ? told_ : why;
  }

 private:
  bool is_kept() const {
    return std::ranges::all_of(why_, [](const auto& entry) { return entry.second.empty(); });
  }

  const std::string folder_;
  std::mutex mutex_;
  std::map<std::string, std::string> why_;
  std::string told_;
};

void show_start(const console::Server& server, const RunOptions& options, const Look& look, bool was_opened,
                bool is_kept) {
  const std::vector<std::string> urls = server.urls(options.edits ? "designer.html" : "");
  if (!options.recording.empty())
    fmt::print("The recorded run {}{}: nothing that is done there changes it.\n", options.recording,
               options.edits ? " on the drawing of " + options.configuration : "");
  else if (options.edits)
    fmt::print("The designer{}.\n", options.configuration.empty() ? "" : " for " + options.configuration);
  else if (options.mission.empty() && options.resume)  // the mission has no file
    fmt::print("The operator console. Nothing moves before Resume.\n");
  else if (options.mission.empty())
    fmt::print("The operator console, without a mission: open one or write one there.\n");
  else if (!look.mission)
    fmt::print("The operator console; {} has errors, and can be mended there.\n", options.mission);
  else
    fmt::print("The operator console for {}: {}, {}. Nothing moves before {}.\n", options.mission,
               base::counted(look.mission->robots.size(), "robot"),
               base::counted(look.mission->steps.size(), "step"), options.resume ? "Resume" : "Execute");
  fmt::print("{} in a browser:\n\n", was_opened ? "It opens" : "Open this address");
  for (const std::string& url : urls) fmt::print("    {}\n", url);
  fmt::print("\nCtrl-C here ends {}; what is not saved is {}.\n",
             options.edits               ? "the designer"
             : options.recording.empty() ? "the run and the console"
                                         : "the console",
             is_kept ? "kept" : "lost then");
  std::fflush(stdout);
  if (!server.is_loopback() && !server.is_encrypted()) {
    fmt::print(
        stderr,
        "mlab run: warning: other machines can reach this console, and nothing is encrypted: who listens on "
        "the way learns the token. --certificate and --key switch TLS on\n");
  }
}

// As headless, but for a mission that nobody started: looking at it is not to fail.
int exit_status(const std::string& report) {
  if (report.empty()) return kDone;
  const auto json = nlohmann::json::parse(report, nullptr, false);
  if (json.is_discarded() || !json.contains("outcome")) return kFailed;
  const bool was_started = json.contains("steps") && !json["steps"].empty();
  return !was_started || json["outcome"] == "done" ? kDone : kFailed;
}

console::RecordSettings record_settings(const RunOptions& options, const std::string& project) {
  const std::string runs = runs_folder(project);
  const bool has_place = !runs.empty() || !options.record.empty();
  return {!options.no_record && has_place, runs, options.record};
}

console::SessionSettings session_settings(const RunOptions& options, RunManner manner) {
  console::SessionSettings out;
  const std::string& first = options.edits ? options.configuration : options.mission;
  out.project_folder = !options.project.empty() ? options.project
                       : first.empty()          ? "."
                                                : fs::absolute(first).parent_path().string();
  out.example_folder = example_folder();
  out.overlay_folders = overlay_folders();
  out.mission = options.mission;
  out.version = kVersion;
  out.include_root = program_sources("", {}).include_root;
  out.state_folder = state_folder();
  out.limits = options.limits;
  out.in_own_processes = options.robots == RobotsAt::kOwnProcesses;
  out.speed = manner.speed;
  out.run = std::move(manner.settings);
  out.gate = std::move(manner.gate);
  out.machines = std::move(manner.machines);
  return out;
}

designer::DesignerSettings designer_settings(const RunOptions& options,
                                             const console::SessionSettings& settings) {
  designer::DesignerSettings out;
  out.project_folder = settings.project_folder;
  out.example_folder = settings.example_folder;
  out.open = options.configuration;
  out.version = settings.version;
  out.include_root = settings.include_root;
  out.state_folder = settings.state_folder;
  out.permission = settings.permission;
  out.limits = settings.limits;
  return out;
}

// A run of a fleet may not come to its end; what has to be saved before is saved within that time.
constexpr std::chrono::seconds kEndingPatience(10);

int serve(const RunOptions& options, console::SessionSettings settings, const Look& look,
          console::Server& server) {
  const bool may_hang = options.robots == RobotsAt::kFleet;
  const agents::EndingWatchdog watchdog(
      "mlab", [&] { return may_hang && was_interrupted() ? std::optional(kFailed) : std::nullopt; },
      kEndingPatience);
  KeepingTold keeping(settings.state_folder);
  settings.tell_not_kept = [&](const std::string& why) { keeping.tell("console", why); };
  const std::string& kept_in = settings.state_folder;
  const std::string project = documents::ProjectFolder({settings.project_folder, ""}).folder();
  const bool is_kept = documents::StateFolder(kept_in, project).problem().empty();
  const auto send = [&server](console::ConnectionId to, auto bytes) { server.send(to, std::move(bytes)); };
  designer::DesignerSettings drawing = designer_settings(options, settings);
  console::Session session(std::move(settings), send);
  drawing.try_out = [&session](console::Trial trial, console::TrialDone done) {
    session.try_out(std::move(trial), std::move(done));
  };
  drawing.tell_not_kept = [&](const std::string& why) { keeping.tell("designer", why); };
  drawing.look_at_run = [&session](console::RunLook shown) { session.look_at_run(std::move(shown)); };
  std::unique_ptr<designer::Designer> designer;  // ends first: it asks the session
  if (options.edits) designer = std::make_unique<designer::Designer>(std::move(drawing), send);
  console::ServerHandlers handlers = {
      socket_of<console::ToServer>(session),
      designer ? socket_of<designer::ToDesigner>(*designer) : console::SocketHandlers{},
      [&] { session.emergency_stop(); },
      [&](std::uint64_t revision) {
        console::Session::Picture picture = session.picture(revision);
        return console::Content{std::move(picture.content_type), std::move(picture.bytes)};
      },
      [&](std::uint32_t zoom, std::uint32_t column, std::uint32_t row) {
        console::Session::Picture square = session.tile(zoom, column, row);
        return console::Content{std::move(square.content_type), std::move(square.bytes)};
      },
      [&] { return session.report(); },
      [&](metrics::Exposition& out) {
        session.tell_metrics(out);
        metrics::tell_process(out);
      },
  };
  server.start(std::move(handlers));
  Browser browser;
  const std::string page = options.edits ? "designer.html" : "";
  show_start(server, options, look, !options.no_browser && browser.open(server.urls(page).front()), is_kept);
  wait_for_interrupt();
  fmt::print("\nending\n");
  const std::string report = session.report();
  server.stop();
  std::vector<std::string> lost = designer ? designer->end() : std::vector<std::string>{};
  std::ranges::move(session.end(), std::back_inserter(lost));
  for (const std::string& what : lost)
    fmt::print(stderr, "mlab: error: what was not saved is lost: {}\n", what);
  if (!options.report.empty() && !report.empty() && !deliver("mlab run", "report", options.report, report))
    return kFailed;
  if (!lost.empty()) return kFailed;
  return options.strict && look.warnings > 0 ? kFailed : exit_status(report);
}

// Who else has the project open, and what that means for what is not saved here.
void tell_place(const documents::DraftPlace& place) {
  if (place.is_beside())
    fmt::print(
        stderr,
        "mlab: note: another server has this project open: what is not saved here is kept apart from what "
        "is not saved there, in {}\n",
        place.state_folder());
  for (const std::string& path : place.left_beside())
    fmt::print(
        stderr,
        "mlab: warning: {} was edited in two servers at once, and neither saved it: this one has the text of "
        "the first; start another one beside it for the other text\n",
        text::shown(path, 200));
}

// What the map is to lie on.
// @return  false where that can't be; it is said
bool open_tiles(const RunOptions& options, const Look& look, console::SessionSettings& settings) {
  if (options.tiles.empty()) return true;
  auto opened = tiles::MapTiles::open(options.tiles);
  if (!opened) {
    text::Diagnostics sink;
    sink.report(std::move(opened.error()));
    tell(sink);
    return false;
  }
  settings.tiles = *std::move(opened);
  if (look.mission && !look.mission->overlay.projection)
    fmt::print(stderr,
               "mlab: warning: --tiles: the map does not say where it lies on the Earth, so nothing is drawn "
               "below it; "
               "`ORIGIN GEO \"latitude longitude\"` in its overlay says that\n");
  return true;
}

// The recording that another one is shown beside.
// @return  the exit status where it can't be
std::optional<int> open_against(const std::string& path, console::OpenRecording& out) {
  out = {fs::path(path).stem().string(), read_history(path)};
  if (!out.history) return kBadInput;
  const std::string why = out.history->why_not_recomputed();
  if (why.empty()) return std::nullopt;
  fmt::print(stderr,
             "mlab: --against: {} can't be shown at any moment: {}; `mlab compare` tells the two apart\n",
             text::shown(path, 200), why);
  return kFailed;
}

int run_console(const RunOptions& options, const std::string& journal) {
  if (!options.plot.empty() || options.limit || options.duration || options.quiet)
    return usage_error("--plot, --limit, --for and --quiet go with --headless");
  if (options.records_for_viewers)
    return usage_error(
        "--record-for viewers counts with --headless; of a run of the console, `mlab replay RUN.mcap "
        "--record "
        "OUT.mcap --record-for viewers` makes one");
  if (!options.percepts.empty() || !options.save_percepts.empty())
    return usage_error("--percepts and --save-percepts go with --headless");
  if (is_standard_input(options.mission)) return usage_error("-, standard input, goes with --headless");
  if (const std::string reason = why_web_is_missing(); !reason.empty())
    return usage_error("there is no page to show; --headless carries a mission out without\n" + reason);
  std::optional<RunManner> manner = run_manner(options, kConsoleSpeed);
  std::optional<console::ServerSettings> where = manner ? server_settings(options) : std::nullopt;
  if (!where) return kBadInput;
  const Look look = look_at(options, manner->settings);
  if (!look.is_readable || !look.is_usable) return kBadInput;
  console::SessionSettings settings = session_settings(options, std::move(*manner));
  if (!open_tiles(options, look, settings)) return kBadInput;
  if (!options.recording.empty()) {
    settings.recording = {fs::path(options.recording).stem().string(), read_history(options.recording),
                          options.recording};
    if (!settings.recording.history) return kBadInput;
    if (const std::string why = settings.recording.history->why_not_recomputed(); !why.empty())
      fmt::print(stderr, "mlab: warning: the run can't be computed again: {}; what was recorded is shown\n",
                 why);
  }
  if (!options.against.empty()) {
    const std::optional<int> failed = open_against(options.against, settings.against);
    if (failed) return *failed;
  }
  const std::string project = documents::ProjectFolder({settings.project_folder, ""}).folder();
  if (options.recording.empty()) {
    settings.record = record_settings(options, project);
    settings.journal_folder = journal_folder(project);
    settings.resume = journal;
  }
  const KeptAddress kept(settings.state_folder, project, options.edits ? "edit" : "run");
  const documents::DraftPlace place(settings.state_folder, project, {"", "designer"});
  settings.state_folder = place.state_folder();
  take_over(kept, options, *where);
  std::string error;
  const std::unique_ptr<console::Server> server = console::Server::open(*where, error);
  if (!server) return usage_error(error);
  if (!listen_for_interrupts()) return usage_error("the operating system has no descriptor left");
  tell_place(place);
  if (const std::string why = kept.keep({where->address, server->port(), server->token()}); !why.empty())
    fmt::print(stderr, "mlab: warning: a page that is left open will not find the next server: {}\n", why);
  const auto people =
      server->is_loopback() ? cell::Grounds::People::kHere : cell::Grounds::People::kElsewhere;
  // What a recording brings may be a stranger's.
  settings.permission = options.recording.empty()
                            ? permission_to_run(options, people, settings.project_folder)
                            : permission_to_replay();
  return serve(options, std::move(settings), look, *server);
}

constexpr std::size_t kLongestReason = 400;  // characters

// The mission and its project are the run's.
int resume_run(RunOptions options) {
  const auto found = find_resumable(options);
  if (!found) return usage_error("--resume: " + found.error());
  options.project = found->stand.session.project();
  options.mission = mission_file(*found);
  const std::string mission = text::shown(found->stand.session.mission());
  const double time = found->stand.progress.time();  // the recording may know of a moment more
  const std::string& why = found->stand.session.why_not_gone_on();
  const bool is_gone = is_mission_gone(*found);
  options.resume = why.empty() && !is_gone;
  if (is_gone)
    fmt::print(
        "The run that stopped at {:.1f} s can't go on, because `{}` is not there. It is kept until it can.\n",
        time, mission);
  else if (why.empty())
    fmt::print("{} goes on as it stood at about {:.0f} s, paused.\n", mission, time);
  else
    fmt::print(
        "{} stopped at {:.1f} s, and that run does not go on: {}. Mission, log and people come back, for a "
        "new run.\n",
        mission, time, text::shown(why, kLongestReason));
  return run_console(options, found->path);
}

// Who starts a mission anew may not know that it stands somewhere in between.
void mention_resumable(const RunOptions& options) {
  if (options.edits || !options.recording.empty() || options.mission.empty()) return;
  const auto found = find_resumable(options);
  if (!found || found->stand.progress.time() <= 0.0) return;
  const std::string mission = text::shown(found->stand.session.mission());
  const double time = found->stand.progress.time();
  if (const std::string& why = found->stand.session.why_not_gone_on(); why.empty())
    fmt::print("A run of {} that did not end stands at {:.1f} s: with --resume it goes on.\n", mission, time);
  else
    fmt::print(
        "A run of {} that did not end stopped at {:.1f} s, and does not go on: {}. --resume brings back its "
        "log, and what was not saved.\n",
        mission, time, text::shown(why, kLongestReason));
}

}  // namespace

int run_console(const RunOptions& options) {
  if (options.resume) return resume_run(options);
  mention_resumable(options);
  return run_console(options, "");
}

int edit(RunOptions options) {
  options.edits = true;
  std::error_code error;
  if (!options.configuration.empty() && !fs::is_regular_file(options.configuration, error)) {
    fmt::print(stderr, "mlab edit: {}: there is no such file\n", options.configuration);
    return kBadInput;
  }
  if (const std::string why = other_language(options.configuration, {assist::Language::kConfiguration});
      !why.empty()) {
    fmt::print(stderr, "mlab edit: {}\n", why);
    return kBadInput;
  }
  return run_console(options);
}

}  // namespace mlab::cli
