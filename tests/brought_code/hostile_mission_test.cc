// What strangers' files do before any robot moves: while they are read, compiled and loaded.

#include <functional>
#include <set>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "team.h"
#include "world.h"

namespace mlab::brought_code {
namespace {

using cell::testing::code_permitted;
using cell::testing::permitted_without_cell;

constexpr const char* kSecretWord = "the_secret_word";

Team team_of(const World& world, const std::string& program, const cell::Permission& permission,
             const std::string& project) {
  world.write("project/map.odl",
              "MISSION-AREA 1000 1000\nCONTROL MEASURES:\nAA Here 0 0 100 0 100 100 0 100\n");
  world.write(
      "project/m.mdl",
      fmt::format(
          "OVERLAY map.odl\nNEW-ROBOT evil \"{}\"\nUNIT <u> evil\nCOMMAND LIST:\n0. UNIT u START Here 0 10\n",
          program));
  robot::ProgramSources sources = sources_in(world.path("project"), permission);
  sources.project = project;
  return {"m.mdl", sources};
}

/// Code in a static constructor is run by whoever loads it: each of these, one after the other.
const std::string kConstructor = R"(init
#include "attacks.h"
static const int kTried = [] {
  const hostile::World world = WORLD;
  int count = 0;
  for (const char* name : {"make_file", "write_in_project", "append", "fork", "raw_clone", "vfork", "spawn", "system", "popen",
                           "tcp", "udp", "unix_socket", "kill_parent", "write_parent_through_vm", "limit_parent"}) {
    for (const hostile::Attack& attack : hostile::kAttacks) {
      if (std::string(name) == attack.name && attack.run(world)) ++count;
    }
  }
  if (count == 0) std::abort();
  return count;
}();
iend
)";

std::string with_constructor(const World& world) {
  std::string text = kConstructor;
  text.replace(text.find("WORLD"), 5, world.in_code());
  fs::copy_file(base::source_folder() + "/tests/brought_code/hostile/attacks.h",
                world.path("project/attacks.h"));
  return text + network_that("");
}

TEST(HostileMission, ConstructorsReachNothingAndAreTold) {
  if (cell::kIsSanitized) GTEST_SKIP() << "sanitizers want more than a cell gives";
  const World world;
  world.write("project/evil.cnl", with_constructor(world));
  const Team team = team_of(world, "evil.cnl", code_permitted(), "");
  EXPECT_FALSE(team.run);
  EXPECT_EQ(world.traces(), std::set<std::string>{});
  EXPECT_NE(team.all().find("m.mdl:2:"), std::string::npos) << team.all();
  EXPECT_NE(team.all().find("ended with signal 6 (Aborted)"), std::string::npos) << team.all();
}

TEST(HostileMission, ConstructorsReachAllThatWithoutACell) {
  const World world;
  world.write("project/evil.cnl", with_constructor(world));
  const Team team = team_of(world, "evil.cnl", permitted_without_cell(), "");
  EXPECT_TRUE(team.run) << team.all();
  const std::set<std::string> traces = world.traces();
  for (const char* trace : {"made", "changed", "heard", "signalled"})
    EXPECT_TRUE(traces.contains(trace)) << trace;
}

/// Files that want to be read, or to have others read for them. `ROOT` stands for the World's folder.
struct Reading {
  const char* name;
  const char* program;  ///< as the mission names it
  const char* file;     ///< that is written first
  const char* text;
  const char* said;
  bool reads_secret;  ///< without a cell the compiler says the secret word, or puts it into what it makes
};

std::string in_world(std::string text, const World& world) {
  for (std::size_t at = text.find("ROOT"); at != std::string::npos; at = text.find("ROOT"))
    text.replace(at, 4, world.path(""));
  return text;
}

class HostileFile : public ::testing::TestWithParam<Reading> {
 protected:
  static void prepare(const World& world) {
    const Reading& one = GetParam();
    for (const char* name : {"outside/evil.cnl", one.file}) {
      const bool is_own = name == one.file;
      world.write(name, in_world(is_own ? one.text : "", world) +
                            (std::string(name).ends_with(".cnl") ? network_that("") : ""));
    }
    fs::create_symlink(world.path("outside/secret"), world.path("project/link.h"));
    fs::create_symlink(world.path("outside/evil.cnl"), world.path("project/link.cnl"));
  }
  static std::string program(const World& world) { return in_world(GetParam().program, world); }
};

TEST_P(HostileFile, IsRefusedAndToldWithoutAWordOfOthersFiles) {
  if (cell::kIsSanitized && GetParam().reads_secret) GTEST_SKIP() << "sanitizers want more than a cell gives";
  const World world;
  prepare(world);
  const Team team = team_of(world, program(world), code_permitted(), world.path("project"));
  EXPECT_FALSE(team.run) << team.all();
  EXPECT_NE(team.all().find(GetParam().said), std::string::npos) << team.all();
  EXPECT_EQ(team.all().find(kSecretWord), std::string::npos) << team.all();
  EXPECT_EQ(world.traces(), std::set<std::string>{});
}

TEST_P(HostileFile, IsReadWithoutThatWall) {
  const World world;
  prepare(world);
  const Team team = team_of(world, program(world), permitted_without_cell(),
                            GetParam().reads_secret ? world.path("project") : "");
  const bool says_secret = team.all().find(kSecretWord) != std::string::npos;
  EXPECT_TRUE(team.run || says_secret) << team.all();
}

INSTANTIATE_TEST_SUITE_P(
    Hostile, HostileFile,
    ::testing::Values(
        Reading{"Include", "evil.cnl", "project/evil.cnl", "init\n#include \"ROOToutside/secret\"\niend\n",
                "[cpp-error]", true},
        Reading{"IncludeUpwards", "evil.cnl", "project/evil.cnl",
                "init\n#include \"../outside/secret\"\niend\n", "[cpp-error]", true},
        Reading{"IncludeInOtherLetters", "evil.cnl", "project/evil.cnl",
                "init\n%:include \"ROOToutside/secret\"\niend\n", "[cpp-error]", true},
        Reading{"IncludeOfAMacro", "evil.cnl", "project/evil.cnl",
                "init\n#define FILE \"ROOToutside/secret\"\n#include FILE\niend\n", "[cpp-error]", true},
        Reading{"IncludeThroughALink", "evil.cnl", "project/evil.cnl", "init\n#include \"link.h\"\niend\n",
                "[cpp-error]", true},
        Reading{"Assembler", "evil.cnl", "project/evil.cnl",
                "init\nasm(\".incbin \\\"ROOToutside/secret\\\"\");\niend\n", "outside/secret", true},
        Reading{"AbsolutePath", "ROOToutside/evil.cnl", "project/other.cnl", "", "[outside-project]", false},
        Reading{"PathUpwards", "../outside/evil.cnl", "project/other.cnl", "", "[outside-project]", false},
        Reading{"Link", "link.cnl", "project/other.cnl", "", "[outside-project]", false},
        Reading{"UseUpwards", "evil.cdl", "project/evil.cdl",
                "use \"../outside/evil.cnl\";\nrobot evil is MRV2 { movement = Mine(); }\n",
                "[outside-project]", false}),
    [](const auto& one) { return one.param.name; });

TEST(HostileMission, NoFileOfAnotherNameIsReadAsCode) {
  const World world;
  world.write("project/code.odl", network_that(""));
  world.write("project/evil.cdl", "use \"code.odl\";\nrobot evil is MRV2 { movement = Mine(); }\n");
  const Team team = team_of(world, "evil.cdl", permitted_without_cell(), "");
  EXPECT_FALSE(team.run);
  EXPECT_NE(team.all().find("`code.odl` is neither a configuration (.cdl) nor CNL (.cnl)"), std::string::npos)
      << team.all();
}

// It never ends, and would fill any memory.
TEST(HostileMission, NoDeviceIsReadAsCode) {
  if (cell::kIsSanitized) GTEST_SKIP() << "sanitizers want more than a cell gives";
  const World world;
  world.write("project/evil.cnl", "init\n#include \"/dev/zero\"\niend\n" + network_that(""));
  const Team team = team_of(world, "evil.cnl", code_permitted(), "");
  EXPECT_FALSE(team.run);
  EXPECT_NE(team.all().find("[cpp-error]"), std::string::npos) << team.all();
}

}  // namespace
}  // namespace mlab::brought_code
