#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/recording/recorded_binding.h"
#include "mlab/recording/recording_binding.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/run/crew.h"
#include "mlab/run/mission_run.h"
#include "mlab/run/report.h"
#include "mlab/simulated/run.h"

namespace mlab::testing {

/// A file that goes with the test.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& name)
      : path_((std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + name)).string()) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  const std::string& path() const { return path_; }
  std::string read() const {
    std::ifstream in(path_, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
  }
  void write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }

 private:
  std::string path_;
};

/// What the robots of one of the project's missions are made of; all questions are answered with yes.
struct Plan {
  std::shared_ptr<const run::Crew> crew;
  run::RunSettings settings;

  explicit Plan(const std::string& mission, std::uint64_t seed = 3, int threads = 1) {
    const auto file =
        std::filesystem::path(base::source_folder()) / "missions" / mission / (mission + ".mdl");
    text::Diagnostics sink;
    const robot::ProgramSources sources = {cell::testing::code_permitted(), file.parent_path().string()};
    mdl::LoadOptions options;
    options.seed = seed;
    options.societies = robot::society_reader(sources);
    const auto plan = mdl::load_mission(file.string(), sink, options);
    if (plan) crew = run::make_crew(plan, sources, sink);
    EXPECT_TRUE(crew) << text::render(sink);
    settings.seed = seed;
    settings.threads = threads;
    settings.executive.proceed_all = true;
  }
};

inline void carry_out(run::MissionRun& run, int cycles) {
  run.post(mission::event::Execute{});
  for (int i = 0; i < cycles && run.step() == run::MissionRun::Progress::kStepped; ++i) {
  }
}

/// What happened, without what differs from run to run.
inline std::string report_of(const run::MissionRun& run) {
  return run::report_json(run, {}, run::RunEnd::kTimeIsUp);
}

/// Carries a mission out in simulation, and writes what the robots sense into a file. @return its report
inline std::string record(const Plan& plan, int cycles, const std::string& path) {
  auto file = recording::PerceptsWriter::create(path, plan.settings.seed, plan.crew->mission->name);
  EXPECT_TRUE(file);
  const std::shared_ptr<recording::PerceptsWriter> writer = std::move(*file);
  auto bodies = std::make_unique<recording::RecordingBinding>(
      simulated::make_bodies(*plan.crew->mission, plan.settings), writer);
  run::MissionRun run(plan.crew, plan.settings, std::move(bodies));
  carry_out(run, cycles);
  EXPECT_FALSE(writer->finish());
  return report_of(run);
}

/// The same mission on what is in a file.
struct Replay {
  const recording::RecordedBinding* bodies = nullptr;
  std::unique_ptr<run::MissionRun> run;

  Replay(const Plan& plan, const std::string& path) {
    auto file = recording::PerceptsReader::open(path);
    EXPECT_TRUE(file) << file.error().message;
    if (!file) return;
    auto recorded = std::make_unique<recording::RecordedBinding>(std::move(*file), plan.settings.threads);
    bodies = recorded.get();
    run = std::make_unique<run::MissionRun>(plan.crew, plan.settings, std::move(recorded));
  }
};

}  // namespace mlab::testing
