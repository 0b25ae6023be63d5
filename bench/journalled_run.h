#pragma once

#include <cstdint>
#include <ctime>
#include <memory>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/history/recorder.h"
#include "mlab/journal/journal.h"
#include "mlab/run/mission_run.h"

namespace mlab::bench {

/// Of this process [s].
inline double cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

/// Where a run is written to, and how often.
struct Written {
  std::string mission;      ///< as the journal calls it
  std::string recording;    ///< a file that is not there yet
  std::string journal;      ///< likewise; empty: there is none
  std::uint64_t apart = 1;  ///< cycles between two writes into the journal
};

/// Carries a run out as the console does, recorded and with a journal, and leaves it as a kill leaves it.
/// @return  processor time [s]
inline double carry_out(run::MissionRun& run, std::uint64_t cycles, const Written& to) {
  std::unique_ptr<journal::Journal> journal;
  if (!to.journal.empty()) {
    if (auto made = journal::Journal::create(to.journal)) journal = std::move(*made);
  }
  journal::Batch batch;
  wire::JournalSession session;
  session.set_mission(to.mission);
  session.set_recording(to.recording);
  batch.session = session.SerializeAsString();
  history::Recorder recorder([&] { return std::string(to.recording); }, run, {"bench", {}, 1, 0.0},
                             [&](const wire::HistoryEntry& entry) {
                               if (journal && !entry.has_poses() && !entry.has_event() && !entry.has_end())
                                 batch.entries.push_back(entry.SerializeAsString());
                             });
  run.set_observer([&](const mission::Effect& effect) { recorder.see(effect); });
  const double began = cpu_seconds();
  run.post(mission::event::Execute{});
  while (run.cycle() < cycles && run.step() == run::MissionRun::Progress::kStepped) {
    recorder.note_cycle();
    if (!journal || run.cycle() % to.apart != 0) continue;
    batch.progress.emplace();
    batch.progress->set_cycle(run.cycle());
    batch.progress->set_time(run.time());
    if (const auto written = journal->write(batch); !written) fmt::print(stderr, "{}\n", written.error());
    batch = {};
  }
  run.set_observer({});
  return cpu_seconds() - began;
}

}  // namespace mlab::bench
