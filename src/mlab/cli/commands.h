#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/robot/host/limits.h"

namespace mlab::cli {

/// Exit status of the command: done as asked; it ran, but the mission failed or a check found a problem in
/// the run; bad input or usage.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kBadInput = 2;

/// Where robots' programs are computed.
enum class RobotsAt {
  kRun,           ///< in the process of the run
  kOwnProcesses,  ///< each in one of its own, on this machine
  kFleet,         ///< at the agents of a fleet
};

/// Which fleet, and how it is reached.
struct NetworkOptions {
  std::string fleet;               ///< empty: the one that is called `default`
  std::string interface_name;      ///< or its address; empty: nothing leaves this machine
  std::vector<std::string> peers;  ///< addresses of other machines
  bool is_secure = false;          ///< members prove who they are, and all is encrypted
  std::string identity;            ///< folder of the identity; empty: this machine's own
};

struct RunOptions {
  std::string mission;  ///< file; empty: a console without one
  bool headless = false;
  bool proceed = false;
  bool strict = false;
  bool quiet = false;
  bool allow_native = false;
  bool no_cell = false;
  bool no_record = false;            ///< the console makes no recording
  bool resume = false;               ///< the console goes on with the newest run that did not end
  bool records_for_viewers = false;  ///< beside the history, what other people's viewers show
  double viewer_rate = 10.0;         ///< of poses for these [Hz, of simulated time]
  RobotsAt robots = RobotsAt::kRun;
  NetworkOptions network;     ///< of kFleet
  bool real_time = false;     ///< its robots are not waited for
  std::string unchecked;      ///< why vehicles are driven without a checklist; empty: they are not
  robot_host::Limits limits;  ///< of robots with code of their own
  std::string speed;          ///< `real`, `max` or a number; empty: the default of the surface
  std::uint64_t seed = 1;
  int threads = 1;
  std::string report;              ///< file; empty: none
  std::string plot;                ///< SVG file; empty: none
  std::string percepts;            ///< file that bodies are read from; empty: simulated ones
  std::string save_percepts;       ///< file that percepts are written to; empty: none
  std::string record;              ///< MCAP file; empty: headless none, in the console one on the shelf
  std::string environment;         ///< environment-change file; empty: none
  std::string start_time;          ///< of the mission clock; empty: now
  std::vector<std::string> set;    ///< `NAME=VALUE`, in place of what the mission says
  double patience = 600.0;         ///< [s]
  std::optional<double> limit;     ///< simulated seconds after which the run is ended
  std::optional<double> duration;  ///< simulated seconds that it goes on for, and then is done

  // Of the operator console.
  std::optional<std::uint16_t> port;  ///< 0: any free one
  std::string listen;                 ///< ADDRESS[:PORT]; empty: only this machine
  std::string certificate;            ///< PEM file; empty: no TLS
  std::string key;                    ///< PEM file
  std::string project;                ///< folder; empty: the mission's, or the current one
  std::string tiles;                  ///< MBTiles file that the map lies on; empty: none
  bool no_browser = false;
  bool new_token = false;  ///< pages that were left open do not find this server

  // Of the designer, which is the console with one page more.
  bool edits = false;
  std::string configuration;  ///< file to open first; empty: none

  std::string recording;  ///< of a run, that is shown in place of one; empty: none
  std::string against;    ///< of another one, that is shown beside it; empty: none
};
int run(const RunOptions& options);
/// `run` without `headless`: serves the operator console until it is interrupted.
int run_console(const RunOptions& options);
/// The designer, and beside it a console without a mission, until it is interrupted.
int edit(RunOptions options);

struct ReplayOptions {
  std::string recording;             ///< empty: those that the console has recorded are listed
  std::string report;                ///< file; empty: none
  std::string record;                ///< MCAP file in which it is recorded once more; empty: none
  bool records_for_viewers = false;  ///< as RunOptions
  double viewer_rate = 10.0;         ///< likewise
  bool headless = false;             ///< in the terminal
  RunOptions page;  ///< else: where and how it is shown; its project is the one whose runs are listed
  bool quiet = false;
  bool keep = false;          ///< it is only marked: the console does not make room by it
  bool no_keep = false;       ///< the mark is taken away
  robot_host::Limits limits;  ///< of robots with code of their own
  int threads = 1;
};
/// Shows a recorded run in the browser, or computes it again in the terminal, and says whether it is the
/// same.
int replay(const ReplayOptions& options);

struct TraceOptions {
  ReplayOptions replay;
  std::vector<std::uint32_t> robots;  ///< empty: all
  std::vector<std::string> ports;     ///< paths, in which `*` stands for anything; empty: all outputs
  double from = 0.0;                  ///< [s]
  std::optional<double> to;           ///< [s]; nothing: the end
  std::uint32_t every = 1;            ///< cycles
  bool says_csv = false;              ///< which is what it does anyway
};
/// Says what ports of a recorded run held, as CSV.
int trace(const TraceOptions& options);

struct CompareOptions {
  std::string first;   ///< recording
  std::string second;  ///< likewise
  std::string page;    ///< HTML file; empty: none
  bool json = false;
  bool quiet = false;         ///< no progress, and only what came out
  robot_host::Limits limits;  ///< of robots with code of their own
  int threads = 1;
};
/// Says where two recorded runs part, and why.
/// @return kDone: they are the same; kFailed: they are not; kBadInput: one of them can't be read
int compare(const CompareOptions& options);

struct BatchOptions {
  std::string file;  ///< a mission, or the definition of a batch (.toml)
  std::vector<std::pair<std::string, std::string>> given;  ///< fields of the definition, in their order
  int threads = 1;
  bool resumes = false;
  bool merges = false;
  std::string rank;  ///< `1/3`, `none`; empty: as the environment says
  bool strict = false;
  bool quiet = false;
  bool allow_native = false;
  bool no_cell = false;
  robot_host::Limits limits;  ///< of robots with code of their own
};
/// Carries out a mission many times.
int batch(const BatchOptions& options);

struct AgentOptions {
  NetworkOptions network;
  std::string name;   ///< in the fleet; empty: the machine's
  std::string offer;  ///< executable whose robots it carries, and no others; empty: those that runs bring
  bool allow_native = false;
  bool no_cell = false;
  robot_host::Limits limits;  ///< of the robots' processes
};
/// Carries robots for runs of a fleet, until it is interrupted.
int agent(const AgentOptions& options);

/// What `--drives` may be.
inline constexpr char kDrivesVelocities[] = "velocities";
inline constexpr char kDrivesNav2[] = "nav2";

/// Of a robot under ROS 2.
struct Ros2Options {
  std::string robot_namespace;       ///< empty: it has none
  std::optional<int> domain;         ///< else what the environment says
  std::vector<std::string> scans;    ///< topics; empty: `scan`
  std::string interface_name;        ///< or its address; empty: nothing leaves this machine
  std::vector<std::string> peers;    ///< addresses of other machines
  std::string map_frame;             ///< empty: poses are those of its odometry
  std::string drives;                ///< kDrivesVelocities (or empty), kDrivesNav2
  std::optional<double> look_ahead;  ///< of goals [m]
  std::optional<double> standstill;  ///< [s]
};

struct RobotOptions {
  NetworkOptions network;
  std::string name;                             ///< in the fleet; empty: the machine's
  std::string binding;                          ///< the kind of vehicle
  std::string device;                           ///< where it is connected, where its kind wants that
  std::string world;                            ///< overlay, of a simulated one
  std::optional<std::array<double, 3>> at;      ///< where that starts [m, m, deg]; else at 0, 0, 0
  std::optional<std::uint64_t> seed;            ///< of its noise; else 1
  std::string key_file;                         ///< of a mavlink one: holds the key that all is signed with
  std::optional<std::array<double, 2>> origin;  ///< of a vehicle's own frame, in the world [m]
  std::optional<double> radius;                 ///< of a vehicle that does not say so itself [m]
  std::optional<double> max_speed;              ///< likewise [m/s]
  std::optional<double> max_turn_rate;          ///< likewise [deg/s]
  Ros2Options ros2;
};
/// Lets runs of a fleet drive a vehicle, until it is interrupted.
int robot(const RobotOptions& options);

struct FleetOptions {
  NetworkOptions network;
  bool once = false;
  bool stop = false;     ///< pull the emergency stop
  bool release = false;  ///< release it
  bool json = false;
  std::string log;  ///< agent whose log is read; empty: who is there is said
};
/// Says who is in a fleet, again and again until it is interrupted.
int show_fleet(const FleetOptions& options);

struct PreflightOptions {
  std::string mission;  ///< file
  NetworkOptions network;
  std::string sign;                  ///< name of who signs; empty: nobody does
  std::vector<std::string> accept;   ///< items that have failed, and do not keep the mission from running
  std::vector<std::string> because;  ///< why, for each of them
  bool yes = false;                  ///< all that a person has to confirm is so
  bool json = false;
  bool allow_native = false;
  bool no_cell = false;
};
/// Looks at a mission and its vehicles, says what is well and what is not, and has it signed.
/// @return kDone: nothing has failed, or it is signed; kFailed: something has, or it is not; kBadInput
int preflight(const PreflightOptions& options);

struct KeysOptions {
  std::string fleet;     ///< empty: the one that is called `default`
  std::string add;       ///< name of an identity to make; empty: none
  std::string withdraw;  ///< name of one that is good no longer; empty: none
};
/// Makes the keys of a secured fleet, and says where they are.
int keys(const KeysOptions& options);

struct CheckOptions {
  std::vector<std::string> files;
  std::string format = "text";  ///< or `json`
  bool strict = false;
  bool failsafes = false;  ///< of missions, as they are in force
  bool no_cell = false;
};
int check(const CheckOptions& options);

struct TestOptions {
  std::vector<std::string> files;  ///< or folders; empty: the current one
  std::string only;                ///< stands in the name of tests that are to run; empty: all
  std::uint64_t seed = 1;
  bool quiet = false;
  bool no_cell = false;
};
/// Runs the tests of configurations.
int test_components(const TestOptions& options);

struct FormatOptions {
  std::vector<std::string> files;
  bool check_only = false;
};
int format(const FormatOptions& options);

struct DiffOptions {
  std::string file;      ///< before; after, where it is alone
  std::string after;     ///< empty: the other one is of git
  std::string revision;  ///< of git: `REV` or `A..B`; empty: HEAD, where one file is named
  bool json = false;
  bool layout = false;  ///< what was only moved counts as well
};
/// What differs between two versions of a configuration.
/// @return kDone: nothing; kFailed: something; kBadInput: one of them can't be read, or not whole
int diff(const DiffOptions& options);

struct DescribeOptions {
  std::string name;  ///< empty: all
  std::string format = "text";
};
int describe(const DescribeOptions& options);

struct BuildOptions {
  std::string file;    ///< a configuration (.cdl) or a network (.cnl)
  std::string emit;    ///< what to write instead of an executable; empty: nothing
  std::string robot;   ///< of the file; empty: the one of the file's name, or the only one
  std::string output;  ///< file; empty: the executable beside the file, anything else to standard output
  bool no_cell = false;
  bool closed = false;  ///< the executable does not show its nodes
};
int build(const BuildOptions& options);

struct ImportOptions {
  std::string file;
  std::string output;  ///< file; empty: standard output
  bool strict = false;
};
int import(const ImportOptions& options);

/// The language server, until it is told to exit.
int lsp();

struct NewOptions {
  std::string kind;  ///< one of new_kinds
  std::string name;  ///< of the files without their endings, perhaps with a folder
};
int make_new(const NewOptions& options);
std::vector<std::string> new_kinds();

struct PlaceOptions {
  std::string map;    ///< overlay file
  std::string place;  ///< on the Earth, in any notation
};
/// Tells where a place lies on a map, and how it is written in all notations.
int tell_place(const PlaceOptions& options);

struct WorldOptions {
  std::string kind;
  std::uint64_t seed = 1;
  std::uint64_t count = 1;  ///< maps, of this seed and those that follow
  std::string folder;       ///< empty: standard output
};
int draw_worlds(const WorldOptions& options);
std::vector<std::string> world_kinds();
std::string world_kinds_help();
inline constexpr const char* kWorldDescription =
    "Draw maps by seeds, for studies (docs/batch.md): each with what stands there, and with the passage\n"
    "points Start and Goal. To the terminal, or one and more into a folder, as KIND_SEED.odl.";

struct BenchOptions {
  std::uint32_t robots = 1000;
  int threads = 1;
  std::string control = "schemas";
  std::string positions;  ///< CSV; empty: generated
  std::string json;       ///< file; empty: none
  double range = 1.0;     ///< of the sensors [m]
  std::uint64_t seed = 1;
  std::uint32_t cycles = 0;  ///< timed ones; 0: as the scenario says
};
int bench(const BenchOptions& options);

}  // namespace mlab::cli
