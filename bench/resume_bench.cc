// How long a console takes to come back to a run of an hour that was killed: what stands between the start
// and the run is `resume_run`, all else is the opening of a mission. For the missions of `missions/` whose
// robots plan their ways, gone to and fro. Beside it what the journal costs, how much room it takes, and how
// long another future that departs shortly before the end takes to get there.
//
//     build/bench/bin/resume_bench [SECONDS]

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "journalled_run.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/console/run/resumed_run.h"
#include "mlab/history/branch.h"
#include "mlab/history/replay.h"
#include "mlab/history/timeline.h"
#include "mlab/journal/journal.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/simulated/run.h"

namespace mlab::console {
namespace {

namespace fs = std::filesystem;
using bench::cpu_seconds;

struct Case {
  const char* name;
  const char* folder;  ///< in missions/
  std::string mission;
};

// Two commands in turn, for longer than the run is.
std::string to_and_fro(std::string begin, const std::string& there, const std::string& back) {
  for (int step = 1; step < 120; ++step)
    begin += fmt::format("  {}. {}\n", step, step % 2 == 1 ? there : back);
  return begin;
}

Case scouts() {
  return {"Demo C, 4 robots", "demo_c",
          to_and_fro("OVERLAY democ.odl\nUNIT <scouts> ROBOT ROBOT ROBOT ROBOT\n\nCOMMAND LIST:\n\n"
                     "  0. UNIT scouts START AA-AA1 0 20\n",
                     "UNIT scouts MOVETO OBJ-Tango FORMATION Wedge",
                     "UNIT scouts MOVETO AA-AA1 FORMATION Column")};
}

Case crossing() {
  return {"A crossing, 10 robots", "crossing",
          to_and_fro("OVERLAY crossing.odl\nUNIT <red> ROBOT ROBOT ROBOT ROBOT ROBOT\n"
                     "UNIT <blue> ROBOT ROBOT ROBOT ROBOT ROBOT\n\nCOMMAND LIST:\n\n"
                     "  0. UNIT red START West 0 8 AND UNIT blue START East 0 8\n",
                     "UNIT red MOVETO East FORMATION Wedge AND UNIT blue MOVETO West FORMATION Wedge",
                     "UNIT red MOVETO West FORMATION Wedge AND UNIT blue MOVETO East FORMATION Wedge")};
}

std::unique_ptr<run::MissionRun> run_of(const Case& one) {
  text::Diagnostics sink;
  const std::string folder = base::source_folder() + "/missions/" + one.folder;
  const robot::ProgramSources sources{cell::testing::code_permitted(), folder,
                                      base::source_folder() + "/src"};
  mdl::LoadOptions options;
  options.societies = robot::society_reader(sources);
  const auto mission = mdl::check_mission(
      std::make_shared<const text::Source>(folder + "/resume_bench.mdl", one.mission), folder, sink, options);
  run::RunSettings settings;
  settings.executive.proceed_all = true;
  auto run = mission ? simulated::make_run(mission, sources, settings, sink) : nullptr;
  if (!run) fmt::print(stderr, "{}", text::render(sink));
  return run;
}

// @return  processor time [s]
double carry_out(const Case& one, double seconds, const std::string& folder, bool with_journal) {
  const auto run = run_of(one);
  if (!run) return 0.0;
  const std::string recording = folder + "/run.mcap";
  fs::remove(recording);
  const auto cycles = static_cast<std::uint64_t>(std::lround(seconds / run->cycle_duration()));
  // Twice a second at the console's usual speed of 10.
  return bench::carry_out(*run, cycles,
                          {"resume_bench.mdl", recording, with_journal ? folder + "/run.journal" : "", 50});
}

// Until both runs are where they depart, in its last twentieth.
void ask_what_if(const std::shared_ptr<history::History>& history, const history::ReplayTools& tools) {
  text::Diagnostics sink;
  const auto line = history::Timeline::make(history, tools, {}, sink);
  if (!line) return;
  while (line->advance(10.0)) {
  }
  const std::uint64_t cycle = history->last_cycle() / 20 * 19;
  if (line->go_to(cycle)) return;
  const auto other =
      history::branch(*history, {cycle, line->run().time(), {}, {}, true}, line->run().mission());
  if (!other) return;
  const auto go_there = [&](history::Replay& own, history::Replay& future) {
    for (history::Replay* const one : {&own, &future}) {
      while (one->run().cycle() < cycle && one->step()) continue;
    }
  };
  double began = cpu_seconds();
  const history::Timeline::Fork fork = line->fork(other->history, cycle);
  go_there(*fork.own, *fork.other);
  const double from_checkpoint = cpu_seconds() - began;
  began = cpu_seconds();
  const auto own = line->again();
  const auto future = history::Replay::make(other->history, tools, sink);
  if (future) go_there(*own, *future);
  fmt::print("  what if, from cycle {}: there in {:.4f} s of processor time, from the beginning {:.2f} s\n",
             cycle, from_checkpoint, cpu_seconds() - began);
}

void resume(const std::string& folder) {
  const double began = cpu_seconds();
  const auto kept = journal::read_journal(folder + "/run.journal");
  if (!kept) {
    fmt::print(stderr, "{}\n", kept.error().why);
    return;
  }
  history::ReplayTools tools;
  tools.permission = cell::testing::code_permitted();
  tools.include_root = base::source_folder() + "/src";
  const ResumedRun resumed =
      resume_run(*kept, {tools, "bench", [&] { return folder + "/anew.mcap"; }, {}}, [] { return false; });
  const double all = cpu_seconds() - began;
  const double before_replay = cpu_seconds();
  text::Diagnostics sink;
  const auto replay = history::Replay::make(kept->history, tools, sink);
  while (replay && replay->step()) {
  }
  if (!resumed.live) fmt::print(stderr, "{}\n", resumed.why);
  fmt::print("  back at cycle {} in {:.2f} s of processor time; computed again alone: {:.2f} s\n",
             resumed.live ? resumed.live->run().cycle() : 0, all, cpu_seconds() - before_replay);
  ask_what_if(kept->history, tools);
}

void measure(const Case& one, double seconds, const std::string& folder) {
  double without = 0.0;
  double with = 0.0;
  for (int i = 0; i < 2; ++i) {
    without += carry_out(one, seconds, folder, false);
    fs::remove(folder + "/run.journal");
    with += carry_out(one, seconds, folder, true);
  }
  fmt::print(
      "{}, {:.0f} s: with a journal {:.3f} of the processor time; it has {:.0f} KB, the recording {:.0f} "
      "KB\n",
      one.name, seconds, with / std::max(1e-9, without),
      1e-3 * static_cast<double>(fs::file_size(folder + "/run.journal")),
      1e-3 * static_cast<double>(fs::file_size(folder + "/run.mcap")));
  resume(folder);
}

int run_all(double seconds) {
  std::string folder = (fs::temp_directory_path() / "mlab_resume_XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return 1;
  for (const Case& one : {scouts(), crossing()}) {
    measure(one, seconds, folder);
    for (const char* file : {"/run.journal", "/run.mcap", "/anew.mcap"}) fs::remove(folder + file);
  }
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  return 0;
}

}  // namespace
}  // namespace mlab::console

int main(int argc, char** argv) {
  return mlab::console::run_all(argc > 1 ? std::atof(argv[1]) : 3600.0);
}
