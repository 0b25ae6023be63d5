// The time line of a run: how long the first pass takes, how fast one comes to any moment afterwards, and how
// much memory that takes. For a unit of four robots, for ten minutes of a thousand robots, and for an hour of
// ten robots whose procedure is computed in a cell.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <malloc.h>
#include <unistd.h>

#include <fmt/core.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/history/history.h"
#include "mlab/history/history_writer.h"
#include "mlab/history/timeline.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/run/crew.h"
#include "mlab/simulated/run.h"
#include "mlab/text/diagnostic.h"

namespace mlab::history {
namespace {

namespace fs = std::filesystem;

struct Case {
  const char* name;
  std::string mission;  ///< its text
  std::string overlay;  ///< of `map.odl` beside it
  double seconds;       ///< of the run
};

// Of wall clock and of this process's processor time [s]: cells compute in other processes.
struct Clock {
  double wall = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  double processor = [] {
    std::timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }();

  Clock since() const {
    const Clock now;
    return {now.wall - wall, now.processor - processor};
  }
};

std::size_t allocated() {
  return ::mallinfo2().uordblks + ::mallinfo2().hblkhd;
}

std::string robots(int count, const char* type) {
  std::string out;
  for (int i = 0; i < count; ++i) out += fmt::format(" {}", type);
  return out;
}

// Units of 25 standard robots, which go to and fro between rocks.
Case thousand() {
  Case out{"1,000 robots, 600 s", "OVERLAY map.odl\n", "MISSION-AREA 2400 2400\n\nCONTROL MEASURES:\n\n",
           600.0};
  const auto x = [](int unit) { return 150 + 300 * (unit % 8); };
  const auto y = [](int unit) { return 150 + 440 * (unit / 8); };
  std::string start;
  std::string go;
  std::string back;
  for (int unit = 0; unit < 40; ++unit) {
    const char* const more = unit == 39 ? "\n" : " AND\n     ";
    out.mission += fmt::format("UNIT <u{}>{}\n", unit, robots(25, "ROBOT"));
    out.overlay += fmt::format("OBJ S{} {} {} 100\nOBJ G{} {} {} 100\nOBSTACLE {} {} 6\n", unit, x(unit),
                               y(unit), unit, x(unit), y(unit) + 260, x(unit) + 10, y(unit) + 140);
    start += fmt::format("UNIT u{} START OBJ-S{} 0 10{}", unit, unit, more);
    go += fmt::format("UNIT u{} MOVETO OBJ-G{} FORMATION Wedge{}", unit, unit, more);
    back += fmt::format("UNIT u{} MOVETO OBJ-S{} FORMATION Column{}", unit, unit, more);
  }
  out.mission += "\nCOMMAND LIST:\n\n  0. " + start;
  for (int step = 1; step < 20; ++step)
    out.mission += fmt::format("  {}. {}", step, step % 2 == 1 ? go : back);
  return out;
}

std::string keeper_folder() {
  return base::source_folder() + "/examples/14_behavior";
}

// Of whom each goes round a pond of his own, by a procedure that the mission brings.
Case hour() {
  return {
      "10 robots in a cell, 3,600 s",
      fmt::format("OVERLAY map.odl\nNEW-ROBOT keeper \"keeper.cdl\" (distance = 6)\nUNIT <all>{}\n\nCOMMAND "
                  "LIST:\n\n  0. UNIT all START OBJ-Gate\n  1. UNIT all MOVETO OBJ-Pond UNTIL TIMEOUT 3600\n",
                  robots(10, "keeper")),
      "MISSION-AREA 100 100\n\nCONTROL MEASURES:\n\nOBJ Gate 20 20 10\nOBJ Pond 50 50 10\nOBSTACLE 50 50 3\n",
      3600.0};
}

Case four() {
  Case out{"4 robots, 600 s", "OVERLAY map.odl\nUNIT <u>" + robots(4, "ROBOT") + "\n\nCOMMAND LIST:\n\n",
           "MISSION-AREA 600 600\n\nCONTROL MEASURES:\n\nOBJ A 100 100 50\nOBJ B 500 500 50\nOBSTACLE 300 "
           "310 20\n",
           600.0};
  out.mission += "  0. UNIT u START OBJ-A 0 10\n";
  for (int step = 1; step < 20; ++step)
    out.mission +=
        fmt::format("  {}. UNIT u MOVETO OBJ-{} FORMATION Wedge\n", step, step % 2 == 1 ? "B" : "A");
  return out;
}

ReplayTools tools() {
  ReplayTools out;
  out.permission = cell::testing::code_permitted();
  out.include_root = base::source_folder() + "/src";
  return out;
}

// The case carried out, and what was written of it.
std::shared_ptr<const History> history_of(const Case& one, const fs::path& folder) {
  std::error_code ignored;
  for (const char* file : {"keeper.cdl", "circle.cnl"})
    fs::copy_file(keeper_folder() + "/" + file, folder / file, fs::copy_options::overwrite_existing, ignored);
  const auto write = [&](const char* name, const std::string& text) {
    std::FILE* const file = std::fopen((folder / name).c_str(), "w");
    if (file == nullptr) return;
    std::fwrite(text.data(), 1, text.size(), file);
    std::fclose(file);
  };
  write("map.odl", one.overlay);
  write("case.mdl", one.mission);
  text::Diagnostics sink;
  const robot::ProgramSources sources{tools().permission, folder.string(), tools().include_root};
  mdl::LoadOptions options;
  options.societies = robot::society_reader(sources);
  const auto mission = mdl::load_mission((folder / "case.mdl").string(), sink, options);
  const auto crew = mission ? run::make_crew(mission, sources, sink) : nullptr;
  if (!crew) {
    fmt::print(stderr, "{}\n", text::render(sink));
    return nullptr;
  }
  run::RunSettings settings;
  settings.executive.proceed_all = true;
  const auto run = simulated::make_run(crew, settings);
  auto out = std::make_shared<History>();
  HistoryWriter writer([&](const wire::HistoryEntry& entry) {
    if (const auto problem = out->add(entry)) fmt::print(stderr, "{}\n", *problem);
  });
  run->set_observer([&](const mission::Effect& effect) { writer.see(effect); });
  writer.begin(*run, {"bench", {}, 0, 0.0});
  run->post(mission::event::Execute{});
  while (run->time() < one.seconds && run->step() == run::MissionRun::Progress::kStepped) writer.note_cycle();
  writer.end("interrupted");
  return out;
}

std::string shown(std::vector<double>& seconds) {
  std::ranges::sort(seconds);
  return fmt::format("median {:.1f} ms, worst {:.1f} ms", 1e3 * seconds[seconds.size() / 2],
                     1e3 * seconds.back());
}

template <class Next>
void seek(Timeline& line, const char* what, Next&& next) {
  std::vector<double> wall;
  std::vector<double> processor;
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t cycle = next(i);
    const Clock begin;
    if (const auto problem = line.go_to(cycle)) fmt::print(stderr, "{}\n", *problem);
    const Clock took = begin.since();
    wall.push_back(took.wall);
    processor.push_back(took.processor);
  }
  fmt::print("  {}: {}; processor time: {}\n", what, shown(wall), shown(processor));
}

void measure_checkpoint(Timeline& line, std::uint64_t cycle) {
  static_cast<void>(line.go_to(cycle));
  const Clock begin;
  const auto checkpoint = line.run().save();
  if (checkpoint)
    fmt::print("  a checkpoint: {} bytes, {:.2f} ms of processor time\n", checkpoint->bytes(),
               1e3 * begin.since().processor);
}

void tell_memory(const Timeline& line, const char* when) {
  fmt::print("  {}: {} checkpoints, {:.1f} MB\n", when, line.checkpoints().size(),
             1e-6 * static_cast<double>(line.checkpoints().bytes()));
}

void measure(const Case& one, const fs::path& folder) {
  const auto history = history_of(one, folder);
  if (!history) return;
  const std::size_t before = allocated();
  text::Diagnostics sink;
  const auto line = Timeline::make(history, tools(), {}, sink);
  if (!line) {
    fmt::print(stderr, "{}\n", text::render(sink));
    return;
  }
  const Clock begin;
  while (line->advance(0.01)) {
  }
  const Clock pass = begin.since();
  const std::uint64_t last = history->last_cycle();
  fmt::print("{}, {} cycles\n  first pass: {:.2f} s, {:.2f} s of processor time\n", one.name, last, pass.wall,
             pass.processor);
  tell_memory(*line, "after it");
  std::mt19937_64 random(1);
  seek(*line, "to any moment", [&](int) { return 1 + random() % last; });
  seek(*line, "back one by one", [&](int i) { return last / 2 - static_cast<std::uint64_t>(i); });
  measure_checkpoint(*line, last / 2);
  tell_memory(*line, "in the end");
  fmt::print("  of the heap, with both runs: {:.1f} MB\n\n",
             1e-6 * static_cast<double>(allocated() - before));
}

int run_all() {
  std::string folder = (fs::temp_directory_path() / "mlab_timeline_XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return 1;
  for (const Case& one : {four(), thousand(), hour()}) measure(one, folder);
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  return 0;
}

}  // namespace
}  // namespace mlab::history

int main() {
  return mlab::history::run_all();
}
