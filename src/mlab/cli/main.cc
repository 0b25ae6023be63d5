#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include <fmt/core.h>
#include <google/protobuf/stubs/logging.h>

#include <CLI/CLI.hpp>

#include "mlab/cli/agent_options.h"
#include "mlab/cli/batch_options.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/commands/export.h"
#include "mlab/cli/fleet_options.h"
#include "mlab/cli/fleet_words.h"
#include "mlab/cli/option_groups.h"
#include "mlab/cli/output.h"
#include "mlab/cli/preflight_options.h"
#include "mlab/cli/replay_options.h"
#include "mlab/cli/robot_options.h"
#include "mlab/cli/shell_words.h"
#include "mlab/cli/version.h"
#include "mlab/cli/wrong_words.h"

namespace mlab::cli {
namespace {

int hardware_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void add_robots(CLI::App* c, RunOptions& o) {
  c->add_option_function<std::string>(
       "--robots",
       [&o](const std::string& where) {
         o.robots = where == "process" ? RobotsAt::kOwnProcesses
                    : where == "fleet" ? RobotsAt::kFleet
                                       : RobotsAt::kRun;
       },
       "embedded: all in this process; process: each in a process of its own; fleet: on other machines, or "
       "in "
       "other processes, whose agents wait for them (docs/robots_of_their_own.md). The result is the same")
      ->default_str("embedded")
      ->check(CLI::IsMember({"embedded", "process", "fleet"}))
      ->type_name("embedded|process|fleet");
  c->add_option("--fleet", o.network.fleet, "the fleet of --robots fleet")
      ->default_str("default")
      ->check(refuse_unless_name)
      ->type_name("NAME");
  c->add_flag("--real-time", o.real_time,
              "robots of --robots fleet are not waited for: they act at their own rate on what reaches them, "
              "and time passes as on the clock");
  c->add_option("--unchecked", o.unchecked,
                "drive vehicles without a signed checklist (mlab preflight), for this reason: the log has it")
      ->check(refuse_if_empty)
      ->type_name("REASON");
  add_network(c, o.network);
}

// What a run reads and writes beside its mission.
void add_run_files(CLI::App* c, RunOptions& o) {
  c->add_option("--report", o.report, "write what happened to a JSON file (docs/report.md)")
      ->type_name("FILE.json");
  c->add_option("--plot", o.plot, "draw the map and the robots' ways as an SVG picture")
      ->type_name("FILE.svg");
  add_record(c, o);
  c->add_option("--save-percepts", o.save_percepts,
                "write what the robots sense and do to a file (docs/percepts.md); with --headless")
      ->type_name("FILE");
  c->add_option(
       "--percepts", o.percepts,
       "let the robots' programs act on what such a file says, and compare what they do; with --headless")
      ->type_name("FILE");
  c->add_option(
       "--environment", o.environment,
       "change the world while the mission runs, as this file says; -: standard input, with --headless")
      ->type_name("FILE");
  c->add_option("--set", o.set,
                "in place of what the mission says: a parameter of its robots (scout:NAME for one type), a "
                "number that SET gives,\nor OVERLAY; again for each (docs/batch.md); with --headless")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
}

void add_run(CLI::App& app, RunOptions& o) {
  CLI::App* c = app.add_subcommand("run", "Carry out a mission in simulation, watched from a browser.");
  c->add_option("mission", o.mission,
                "the mission file; without one the console opens empty; -: standard input, with --headless")
      ->type_name("MISSION.mdl");
  c->add_flag("--headless", o.headless, "no console: print the steps as they happen");
  c->add_flag("--proceed", o.proceed, "answer every Proceed? with yes");
  c->add_option("--speed", o.speed,
                "real, N times real time from 0.1 to 1000, or max (default: 10; headless: max)")
      ->type_name("real|N|max");
  c->add_option("--seed", o.seed, "of everything random in the run")
      ->capture_default_str()
      ->check(refuse_unless_whole)
      ->type_name("N");
  c->add_option("--threads", o.threads,
                "how many threads step the robots; the result is the same for any number")
      ->capture_default_str()
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  add_robots(c, o);
  add_run_files(c, o);
  c->add_option("--start-time", o.start_time,
                "what the mission's clock shows at the start: \"YYYY-MM-DD HH:MM[:SS]\" (default: now)")
      ->type_name("TIME");
  c->add_option("--patience", o.patience,
                "simulated seconds without progress after which a command has failed")
      ->capture_default_str()
      ->check(refuse_unless_positive)
      ->type_name("SECONDS");
  c->add_option("--for", o.duration,
                "run for so many simulated seconds, for robots that act by themselves, and end as done")
      ->check(refuse_unless_positive)
      ->type_name("SECONDS");
  c->add_option("--limit", o.limit, "end the run after so many simulated seconds, as interrupted")
      ->check(refuse_unless_positive)
      ->type_name("SECONDS");
  c->add_flag("--strict", o.strict, "warnings keep the mission from running (exit status 1)");
  c->add_flag("--quiet", o.quiet, "print only the summary");
  c->add_flag(
      "--allow-native", o.allow_native,
      "run executables that the mission names as robot programs (mlab build makes them), and let people on\n"
      "other machines bring code of their own; both in cells (docs/security.md)");
  add_cell(c, o);
}

void add_console(CLI::App* c, RunOptions& o, const std::string& group) {
  c->add_option("--port", o.port, "where it listens (default: 8642, or any other that is free; 0: any)")
      ->type_name("N")
      ->group(group);
  c->add_option("--listen", o.listen, "also reachable from other machines, at this address of this one")
      ->type_name("ADDRESS[:PORT]")
      ->group(group);
  CLI::Option* certificate =
      c->add_option("--certificate", o.certificate, "encrypt (TLS): certificate chain, PEM")
          ->check(CLI::ExistingFile)
          ->type_name("FILE")
          ->group(group);
  CLI::Option* key = c->add_option("--key", o.key, "the certificate's private key, PEM")
                         ->check(CLI::ExistingFile)
                         ->type_name("FILE")
                         ->group(group);
  certificate->needs(key);
  key->needs(certificate);
  c->add_option("--project", o.project,
                "folder whose files can be opened and saved (default: the mission's, or the current one)")
      ->check(CLI::ExistingDirectory)
      ->type_name("FOLDER")
      ->group(group);
  c->add_option(
       "--tiles", o.tiles,
       "draw the map on a map of the Earth: pictures out of an MBTiles file; the overlay says where it\n"
       "lies (ORIGIN GEO, docs/geography.md)")
      ->check(CLI::ExistingFile)
      ->type_name("FILE.mbtiles")
      ->group(group);
  c->add_flag("--no-browser", o.no_browser, "only print the address")->group(group);
  c->add_flag(
       "--new-token", o.new_token,
       "lets nobody in who has the address of an earlier start (else it stays the same for a project, so\n"
       "that pages which were left open find their way back)")
      ->group(group);
}

void add_edit(CLI::App& app, RunOptions& o) {
  CLI::App* c = app.add_subcommand(
      "edit",
      "Draw configurations of robots and see them live, in the browser. Without a file it starts with the\n"
      "examples and the component library.");
  c->add_option("file", o.configuration, "the configuration")->type_name("FILE.cdl");
  c->add_flag("--allow-native", o.allow_native, "let people on other machines bring code of their own");
  add_cell(c, o);
  c->add_option("--recording", o.recording,
                "show this recorded run on the drawing, in place of one that goes on")
      ->check(CLI::ExistingFile)
      ->type_name("RUN.mcap");
  add_console(c, o, "Where and how");
}

void add_check(CLI::App& app, CheckOptions& o) {
  CLI::App* c = app.add_subcommand(
      "check", "Parse and check files of missions, overlays, networks, configurations and batches.");
  c->add_option("files", o.files, "files; the language is told by name or content; -: standard input")
      ->required()
      ->type_name("FILE");
  c->add_option("--format", o.format, "how problems are printed")
      ->capture_default_str()
      ->check(CLI::IsMember({"text", "json"}));
  c->add_flag("--strict", o.strict, "warnings count as problems (exit status 1)");
  c->add_flag(
      "--failsafes", o.failsafes,
      "print what is in force below the programs of a mission's robots (FAILSAFE), the highest rank first");
  add_no_cell(c, o.no_cell);
}

void add_test_components(CLI::App& app, TestOptions& o) {
  CLI::App* c = app.add_subcommand(
      "test-components",
      "Run the tests that stand beside components in configurations (docs/component_tests.md).\n"
      "Exit status 0: all have passed, 1: some have failed, 2: something can't be read.");
  c->add_option("files", o.files,
                "configurations, or folders that are searched for them (default: here); -: standard input")
      ->type_name("FILE|FOLDER");
  c->add_option("--only", o.only, "only tests in whose name this stands, letter case aside")
      ->type_name("TEXT");
  c->add_option("--seed", o.seed, "of everything random in the tests")
      ->capture_default_str()
      ->check(refuse_unless_whole)
      ->type_name("N");
  c->add_flag("--quiet", o.quiet, "print only what failed, and the summary");
  add_no_cell(c, o.no_cell);
}

void add_fmt(CLI::App& app, FormatOptions& o) {
  CLI::App* c = app.add_subcommand("fmt", "Rewrite files in the canonical layout, comments kept.");
  c->add_option("files", o.files, "files to rewrite in place; -: standard input, to standard output")
      ->required()
      ->type_name("FILE");
  c->add_flag("--check", o.check_only,
              "change nothing; exit status 1 where a file is not in the canonical layout");
}

void add_diff(CLI::App& app, DiffOptions& o) {
  CLI::App* c = app.add_subcommand(
      "diff",
      "Show what differs between two versions of a configuration: nodes, wires, values, states, devices.\n"
      "With one file, what has changed since git's last revision of it. What was only moved in the drawing,\n"
      "comments and blanks are no differences. Exit status 0: none, 1: some, 2: something can't be read.");
  c->add_option("file", o.file, "the version before; alone: the one after; -: standard input")
      ->required()
      ->type_name("FILE.cdl");
  c->add_option("after", o.after, "the version after")->type_name("FILE.cdl");
  c->add_option("--rev", o.revision,
                "compare the file with a revision of git (default: HEAD), or two revisions of it: A..B")
      ->type_name("REV");
  c->add_flag("--layout", o.layout,
              "what was moved in the drawing, and notes on it, are differences as well");
  c->add_flag("--json", o.json, "for programs (docs/diff.md)");
}

void add_describe(CLI::App& app, DescribeOptions& o) {
  CLI::App* c = app.add_subcommand("describe", "Show the component library, or one component of it.");
  c->add_option(
       "name", o.name,
       "a component or assemblage, by its own name or a historic one; `robot`, the standard robot; or a "
       "configuration file; -: one from standard input")
      ->type_name("NAME");
  c->add_option("--format", o.format, "text, json, or markdown")
      ->capture_default_str()
      ->check(CLI::IsMember({"text", "json", "markdown"}));
}

void add_build(CLI::App& app, BuildOptions& o) {
  CLI::App* c = app.add_subcommand(
      "build",
      "Compile the robot of a configuration to an executable, through CNL and C++. A mission runs it as\n"
      "NEW-ROBOT forager \"./forager\", in lock-step, with mlab run --allow-native. It needs g++; a mission "
      "that\n"
      "names the configuration itself does not. A configuration for the architecture UGV becomes a\n"
      "SAUSAGES plan instead (FILE.sausages).");
  c->add_option("file", o.file, "the configuration (.cdl), or a network (.cnl)")
      ->required()
      ->type_name("FILE");
  std::vector<std::string> formats = {"cnl", "cpp"};
  for (const std::string& format : export_formats()) formats.push_back(format);
  c->add_option("--emit", o.emit, "what to write instead of an executable")
      ->check(CLI::IsMember(formats))
      ->type_name("WHAT");
  c->add_option("--robot", o.robot,
                "which robot of the file (default: the one of the file's name, or the only one)")
      ->type_name("NAME");
  c->add_flag("--closed", o.closed,
              "an executable that does not show its nodes and values to those who run it");
  c->add_option(
       "-o,--output", o.output,
       "where to write it (default: the executable beside the file, without its ending; anything else to\n"
       "standard output)")
      ->type_name("FILE");
  add_no_cell(c, o.no_cell);
}

void add_import(CLI::App& app, ImportOptions& o) {
  CLI::App* c = app.add_subcommand("import", "Turn a configuration of the historic tools into one of ours.");
  c->add_option("file", o.file, "the historic configuration (.cdl); -: standard input")
      ->required()
      ->type_name("FILE");
  c->add_option("-o,--output", o.output, "write it to this file, not to the terminal")->type_name("FILE");
  c->add_flag("--strict", o.strict, "warnings count as problems (exit status 1)");
}

void add_bench(CLI::App& app, BenchOptions& o) {
  CLI::App* c =
      app.add_subcommand("bench", "Measure the simulator and the behavior runtime (docs/performance.md).");
  c->add_option("--robots", o.robots, "how many")
      ->capture_default_str()
      ->check(CLI::Range(1U, 1'000'000U))
      ->type_name("N");
  c->add_option("--threads", o.threads, "how many threads")
      ->capture_default_str()
      ->check(CLI::Range(1, 256))
      ->type_name("T");
  c->add_option("--control", o.control, "what steers the robots")
      ->capture_default_str()
      ->check(CLI::IsMember({"diffusion", "schemas"}));
  c->add_option("--positions", o.positions,
                "read obstacles and robots from a CSV file instead of generating them; -: standard input")
      ->type_name("FILE");
  c->add_option("--range", o.range, "of the range sensors [m]")
      ->capture_default_str()
      ->check(refuse_unless_positive)
      ->check(CLI::Range(0.01, 100.0))
      ->type_name("M");
  c->add_option("--seed", o.seed, "of the generator and the behaviors")
      ->capture_default_str()
      ->check(refuse_unless_whole)
      ->type_name("N");
  c->add_option("--cycles", o.cycles, "timed cycles (default: by the number of robots)")
      ->check(refuse_unless_whole)
      ->type_name("N");
  c->add_option("--json", o.json, "write the figures to a file")->type_name("FILE");
}

void add_lsp(CLI::App& app, bool& says_stdio) {
  CLI::App* c = app.add_subcommand(
      "lsp", "Language server for editors: LSP 3.17 over standard input and output (docs/editors.md).");
  c->add_flag("--stdio", says_stdio, "what it does anyway; many editors say it");
}

void add_new(CLI::App& app, NewOptions& o) {
  CLI::App* c = app.add_subcommand("new",
                                   "Write a small mission, behavior or configuration to begin with, and what "
                                   "it takes to run it: NAME.mdl,\n"
                                   "NAME.odl, NAME.cnl or NAME.cdl. What is there already is left alone.");
  c->add_option("kind", o.kind, "what to begin")
      ->required()
      ->check(CLI::IsMember(new_kinds()))
      ->type_name("KIND");
  c->add_option("name", o.name, "what it is called; a folder may stand before it")
      ->required()
      ->type_name("NAME");
}

// What shows or writes something of the command line itself.
struct OwnOptions {
  std::string help_of;  // never read: help is answered by the command it is asked of
  std::string shell;
  std::string folder;
};

void add_own(CLI::App& app, OwnOptions& o) {
  CLI::App* completion =
      app.add_subcommand("completion", "Print what a shell reads to complete command lines of mlab.");
  completion->add_option("shell", o.shell, "which shell; bash takes it as: source <(mlab completion bash)")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->type_name("SHELL");
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(command->get_name());
  CLI::App* help = app.add_subcommand("help", "Show the help of a command.");
  help->add_option("command", o.help_of, "which; without one: of all")
      ->check(CLI::IsMember(commands))
      ->type_name("COMMAND");
  // For the installation, not for people.
  CLI::App* write = app.add_subcommand("write-shell-files", "Write completions and manual pages.")->group("");
  write->add_option("folder", o.folder, "share/ of the installation")->required();
}

int show_own(const CLI::App& app, const OwnOptions& o) {
  const ProgramWords program = words_of(app);
  if (app.got_subcommand("write-shell-files")) return write_shell_files(program, o.folder) ? kDone : kFailed;
  fmt::print("{}", o.shell == "bash"  ? bash_completion(program)
                   : o.shell == "zsh" ? zsh_completion(program)
                                      : fish_completion(program));
  return kDone;
}

// `mlab help run` is `mlab run --help`.
std::vector<std::string> words_in(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty() || words.size() > 2 || words.front() != "help" || words.back().starts_with('-'))
    return words;
  words.erase(words.begin());
  words.emplace_back("--help");
  return words;
}

/// What the command line says, of each command.
struct AllOptions {
  RunOptions run;
  RunOptions edit;
  BatchOptions batch;
  CheckOptions check;
  TestOptions test;
  FormatOptions format;
  DiffOptions diff;
  DescribeOptions describe;
  BuildOptions build;
  ImportOptions import;
  BenchOptions bench;
  AgentOptions agent;
  RobotOptions robot;
  FleetOptions fleet;
  PreflightOptions preflight;
  KeysOptions keys;
  ReplayOptions replay;
  TraceOptions trace;
  CompareOptions compare;
  NewOptions fresh;
  WorldOptions world;
  PlaceOptions place;
  OwnOptions own;
  bool says_stdio = false;
};

void add_all(CLI::App& app, AllOptions& o) {
  o.run.threads = std::min(hardware_threads(), 8);
  add_run(app, o.run);
  add_console(app.get_subcommand("run"), o.run, "Operator console");
  o.edit = o.run;
  add_edit(app, o.edit);
  o.batch.threads = std::min(hardware_threads(), 256);
  add_batch(app, o.batch);
  add_check(app, o.check);
  add_test_components(app, o.test);
  add_fmt(app, o.format);
  add_diff(app, o.diff);
  add_describe(app, o.describe);
  add_build(app, o.build);
  add_import(app, o.import);
  add_bench(app, o.bench);
  add_agent_options(app.add_subcommand("agent", kAgentDescription), o.agent);
  add_robot(app, o.robot);
  add_fleet(app, o.fleet);
  add_preflight(app, o.preflight);
  o.replay.threads = o.trace.replay.threads = o.compare.threads = o.run.threads;
  CLI::App* const replay = app.add_subcommand("replay", kReplayDescription);
  add_replay_options(replay, o.replay);
  add_console(replay, o.replay.page, "Where and how it is shown");
  add_trace_options(app.add_subcommand("trace", kTraceDescription), o.trace);
  add_compare_options(app.add_subcommand("compare", kCompareDescription), o.compare);
  add_keys(app, o.keys);
  add_lsp(app, o.says_stdio);
  add_new(app, o.fresh);
  add_world(app, o.world);
  add_place(app, o.place);
  add_own(app, o.own);
}

/// What a command does with its options.
struct Command {
  const char* name;
  int (*does)(const AllOptions& o);
};

constexpr Command kCommands[] = {
    {"run", [](const AllOptions& o) { return run(o.run); }},
    {"edit", [](const AllOptions& o) { return edit(o.edit); }},
    {"batch", [](const AllOptions& o) { return batch(o.batch); }},
    {"check", [](const AllOptions& o) { return check(o.check); }},
    {"test-components", [](const AllOptions& o) { return test_components(o.test); }},
    {"fmt", [](const AllOptions& o) { return format(o.format); }},
    {"diff", [](const AllOptions& o) { return diff(o.diff); }},
    {"describe", [](const AllOptions& o) { return describe(o.describe); }},
    {"build", [](const AllOptions& o) { return build(o.build); }},
    {"import", [](const AllOptions& o) { return import(o.import); }},
    {"lsp", [](const AllOptions& /*o*/) { return lsp(); }},
    {"agent", [](const AllOptions& o) { return agent(o.agent); }},
    {"robot", [](const AllOptions& o) { return robot(o.robot); }},
    {"fleet", [](const AllOptions& o) { return show_fleet(o.fleet); }},
    {"preflight", [](const AllOptions& o) { return preflight(o.preflight); }},
    {"keys", [](const AllOptions& o) { return keys(o.keys); }},
    {"replay", [](const AllOptions& o) { return replay(o.replay); }},
    {"trace", [](const AllOptions& o) { return trace(o.trace); }},
    {"compare", [](const AllOptions& o) { return compare(o.compare); }},
    {"new", [](const AllOptions& o) { return make_new(o.fresh); }},
    {"place", [](const AllOptions& o) { return tell_place(o.place); }},
    {"world", [](const AllOptions& o) { return draw_worlds(o.world); }},
    {"bench", [](const AllOptions& o) { return bench(o.bench); }},
};

int do_as_told(CLI::App& app, const AllOptions& o) {
  for (const Command& one : kCommands) {
    if (app.got_subcommand(one.name)) return one.does(o);
  }
  return show_own(app, o.own);
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("Specify, check and carry out missions of teams of robots.", "mlab");
  app.set_version_flag("--version", fmt::format("mlab {}", kVersion));
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 done as asked; 1 it ran, but the mission failed or a check found a problem; 2 bad "
      "input or usage.\n"
      "Documentation: docs/README.md");
  AllOptions options;
  add_all(app, options);
  const std::vector<std::string> words = words_in(argc, argv);
  if (is_unknown_command(app, words)) {
    tell_unknown_command(app, words);
    return kBadInput;
  }
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // it takes them from the end
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // help and version come this way, too
    tell_wrong_words(app, e, words);
    return kBadInput;
  }
  return do_as_told(app, options);
}

}  // namespace
}  // namespace mlab::cli

int main(int argc, char** argv) {
  try {
    mlab::cli::guard_output();
    google::protobuf::SetLogHandler(nullptr);  // what arrives may be anything, and is told of in our words
    return mlab::cli::output_status(mlab::cli::parse_and_run(argc, argv));
  } catch (const std::exception& e) {
    fmt::print(stderr, "mlab: {}\n", e.what());
    return mlab::cli::kFailed;
  }
}
