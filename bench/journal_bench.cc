// What a journal costs: an hour of robots with recording, without and with the writes that the console makes
// of it; and how long such a run takes to be read and computed again.
//
//     build/bench/bin/journal_bench [ROBOTS] [SECONDS] [THREADS]

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/core.h>

#include "journalled_run.h"
#include "mlab/history/replay.h"
#include "mlab/journal/journal.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/simulated/run.h"

namespace {

namespace fs = std::filesystem;
using namespace mlab;
using bench::cpu_seconds;

std::unique_ptr<run::MissionRun> run_of(int robots) {
  std::string text = "MISSION-AREA 100000 3000\nUNIT <all>";
  for (int i = 0; i < robots; ++i) text += " ROBOT";
  text += "\nCOMMAND LIST:\n0. UNIT all START 100 100 0 40\n1. UNIT all MOVETO 99000 1500\n";
  text::Diagnostics sink;
  const auto mission = mdl::check_mission(std::make_shared<const text::Source>("bench.mdl", text), "", sink);
  auto run = mission ? simulated::make_run(mission, {}, {}, sink) : nullptr;
  if (!run) fmt::print(stderr, "{}", text::render(sink));
  return run;
}

// @param journal  empty: there is none
double carry_out(int robots, std::uint64_t cycles, const std::string& recording, const std::string& journal) {
  const auto run = run_of(robots);
  if (!run) return 0.0;
  fs::remove(recording);
  // Twice a second at the console's usual speed of 10.
  return bench::carry_out(*run, cycles, {"bench.mdl", recording, journal, 50});
}

}  // namespace

int main(int argc, char** argv) {
  const int robots = argc > 1 ? std::atoi(argv[1]) : 100;
  const int seconds = argc > 2 ? std::atoi(argv[2]) : 3600;
  const auto cycles = static_cast<std::uint64_t>(seconds) * 10;
  const std::string folder = (fs::temp_directory_path() / "journal_bench").string();
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string recording = (fs::temp_directory_path() / "journal_bench.mcap").string();
  const double without = carry_out(robots, cycles, recording, "");
  const double with = carry_out(robots, cycles, recording, folder + "/run.journal");
  fs::remove(recording);
  fmt::print(
      "{} robots, {} s: {:.2f} s of processor time with recording, {:.2f} s with a journal, too ({:+.2f} "
      "%)\n",
      robots, seconds, without, with, 100.0 * (with - without) / without);
  const double began = cpu_seconds();
  const auto began_at = std::chrono::steady_clock::now();
  const auto kept = journal::read_journal(folder + "/run.journal");
  if (!kept) {
    fmt::print(stderr, "{}\n", kept.error().why);
    return 1;
  }
  const double read = cpu_seconds();
  text::Diagnostics sink;
  history::ReplayTools tools;
  tools.threads = argc > 3 ? std::atoi(argv[3]) : 1;
  const auto replay = history::Replay::make(kept->history, tools, sink);
  while (replay && replay->step()) {
  }
  const std::chrono::duration<double> by_the_clock = std::chrono::steady_clock::now() - began_at;
  fmt::print(
      "read in {:.3f} s, computed again up to cycle {} in {:.2f} s of processor time; both {:.2f} s by the "
      "clock, {} threads\n",
      read - began, replay ? replay->run().cycle() : 0, cpu_seconds() - read, by_the_clock.count(),
      tools.threads);
  fs::remove_all(folder);
  return replay && !replay->divergence() ? 0 : 1;
}
