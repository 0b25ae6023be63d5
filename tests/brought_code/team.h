#pragma once

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/permission.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/run/mission_run.h"
#include "mlab/simulated/run.h"

/// Missions whose robots bring procedures of their own.
namespace mlab::brought_code {

namespace fs = std::filesystem;

/// A folder for one test, gone with it.
class Folder {
 public:
  Folder()
      : path_(fs::path(::testing::TempDir()) /
              ("mlab_brought_code_" + std::to_string(getpid()) + "_" + test_name())) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path(const std::string& name = "") const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }

 private:
  static std::string test_name() {
    std::string out = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::ranges::replace(out, '/', '_');  // of its parameter
    return out;
  }

  fs::path path_;
};

/// A mission, `m.mdl`, in which so many robots drive by one network, in `mine.cnl`.
inline void write_mission(const Folder& folder, const std::string& network, int robots) {
  folder.write(
      "map.odl",
      "MISSION-AREA 1000 1000\nCONTROL MEASURES:\nAA Here 0 0 100 0 100 100 0 100\nPP There 900 50\n");
  folder.write("mine.cnl", network);
  std::string mission = "MISSION NAME Test\nOVERLAY map.odl\nNEW-ROBOT mine \"mine.cnl\"\nUNIT <u>";
  for (int i = 0; i < robots; ++i) mission += " mine";
  mission += "\nCOMMAND LIST:\n0. UNIT u START Here 0 10\n1. UNIT u MOVETO There\n";
  folder.write("m.mdl", mission);
}

/// What a mission in this folder may use.
inline robot::ProgramSources sources_in(const std::string& folder, const cell::Permission& permission) {
  return {permission, folder, base::source_folder() + "/src", "test"};
}

/// A run, and what it says.
struct Team {
  text::Diagnostics sink;
  std::vector<std::string> told;
  std::unique_ptr<run::MissionRun> run;

  /// Robots that drive by one network.
  /// @param network  in CNL; has to bring what it uses and is not in the component library
  Team(const Folder& folder, const std::string& network, int robots, const cell::Permission& permission,
       int threads = 1)
      : Team((write_mission(folder, network, robots), "m.mdl"), sources_in(folder.path(), permission),
             threads) {}

  /// Those of a mission file.
  Team(const std::string& mission, const robot::ProgramSources& sources, int threads = 1) {
    const auto plan = mdl::load_mission((fs::path(sources.folder) / mission).string(), sink, {1, {}});
    if (!plan) return;
    run::RunSettings settings;
    settings.seed = 5;
    settings.threads = threads;
    settings.executive.proceed_all = true;
    run = simulated::make_run(plan, sources, settings, sink);
    if (!run) return;
    run->set_observer([this](const mission::Effect& effect) {
      const auto* one = std::get_if<mission::effect::Tell>(&effect);
      if (one != nullptr) told.push_back(one->text);
    });
    run->post(mission::event::Execute{});
  }

  void step(int cycles) const {
    for (int i = 0; i < cycles; ++i) run->step();
  }
  const fleet::FleetRobot& robot(std::uint32_t id) const { return *run->fleet().find({id}); }
  bool was_told(const std::string& words) const {
    for (const std::string& one : told) {
      if (one.find(words) != std::string::npos) return true;
    }
    return false;
  }
  std::string all() const {
    std::string out = text::render(sink);
    for (const std::string& one : told) out += one + "\n";
    return out;
  }
};

/// A network whose robots drive ahead, each a little faster than the one before, and do `body` in each cycle.
inline std::string network_that(const std::string& body, const std::string& outside = "") {
  return (outside.empty() ? std::string() : "init\n" + outside + "\niend\n") +
         "procedure Vector Mine with\nheader\n  double way = 0;\nbody\n  way += 1.0;\n"
         "  output = {1.0, 0.1 * random.uniform(), 0.0};\n" +
         body + "\npend\nnode mine is Mine with nend\nnode wheels is Drive with v = mine; nend\n";
}

}  // namespace mlab::brought_code
