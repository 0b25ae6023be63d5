// Procedures and missions of strangers, on the way that all go: none reaches anything outside, each is told,
// and the robots of another program go on. What reaches something without a cell is shown to do so there.

#include <iterator>
#include <set>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "hostile/attacks.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "team.h"
#include "world.h"

namespace mlab::brought_code {
namespace {

using cell::testing::code_permitted;
using cell::testing::permitted_without_cell;
using fleet::RobotLife;

/// How an attack shows, and how a person is told of it.
struct Expected {
  const char* name;   ///< of hostile::kAttacks
  const char* trace;  ///< what it leaves in the World without a cell; `got`: it got something for itself;
                      ///< empty: it harms its own process alone
  const char* told;   ///< of its robot, in the cell; empty: its name, and that it was refused
  /// Kernels and containers may refuse it to everybody, or to all but root.
  bool is_always_possible = true;
};

constexpr Expected kExpected[] = {
    {"read_secret", "got", ""},
    {"read_passwords", "got", ""},
    {"read_environment", "got", ""},
    {"read_environment_of_parent", "got", ""},
    {"read_project", "got", ""},
    {"list", "got", ""},
    {"make_file", "made", ""},
    {"write_in_home", "made", ""},
    {"write_in_project", "made", ""},
    {"append", "changed", ""},
    {"truncate", "changed", ""},
    {"remove", "changed", ""},
    {"rename", "changed", ""},
    {"mode", "changed", ""},
    {"make_folder", "made", ""},
    {"symbolic_link", "made", ""},
    {"hard_link", "made", ""},
    {"make_pipe", "made", ""},
    {"make_socket", "made", ""},
    {"posix_memory", "made", ""},
    {"thread", "made", "signal 6 (Aborted), saying:   what():  Operation not permitted"},
    {"fork", "made", ""},
    {"raw_clone", "made", ""},
    {"vfork", "made", ""},
    {"spawn", "made", ""},
    {"system", "made", ""},
    {"popen", "made", ""},
    {"exec", "made", ""},
    {"run_from_memory", "made", ""},
    {"tcp", "heard", ""},
    {"udp", "heard", ""},
    {"unix_socket", "heard", ""},
    {"netlink", "got", ""},
    {"listen", "got", ""},
    {"kill_parent", "signalled", ""},
    {"trace_parent", "marked", "", false},
    {"write_parent_through_proc", "marked", "", false},
    {"write_parent_through_vm", "marked", "", false},
    {"limit_parent", "limited", "", false},
    {"raise_limit", "got", "", false},
    {"dumpable", "got", ""},
    {"outlive", "got", ""},
    {"system_v_memory", "got", ""},
    {"become_another", "got", ""},
    {"own_namespace", "got", "", false},
    {"device_memory", "got", "", false},
    {"io_uring", "got", "", false},
    {"write_percepts", "", "write_percepts: Permission denied"},
    {"grow_shared_memory", "got", "signal 25 (File size limit exceeded)"},
    {"scribble", "", "needed more than 512 MB"},  // it says so itself, as it says anything
    {"disturb_conversation", "", "signal 6 (Aborted)"},
    {"close_everything", "", "signal 6 (Aborted)"},
    {"spin", "", "did not come to an end within 0.3 s of processor time"},
    {"sleep", "", "gave no answer for 0.7 s"},
    {"stop", "", "gave no answer for 0.7 s"},
    {"ignore_signals_and_spin", "", "did not come to an end within 0.3 s of processor time"},
    {"handle_crash_for_ever", "", "did not come to an end within 0.3 s of processor time"},
    {"jump_out_of_crash_for_ever", "", "did not come to an end within 0.3 s of processor time"},
    {"talk_for_ever", "", "in procedure `Attack`"},
    {"complain_for_ever", "", "in procedure `Attack`"},
    {"recurse", "", "signal 11 (Segmentation fault)"},
    {"crash", "", "signal 11 (Segmentation fault)"},
    {"end_at_once", "", "exit status 0"},
    {"exit", "", "exit status 0"},
    {"abort", "", "signal 6 (Aborted)"},
    {"kill_itself", "", "signal 9 (Killed)"},
    {"terminate", "", "signal 6 (Aborted)"},
    {"throw", "", "signal 6 (Aborted), saying:   what():  vector<bool>"},
    {"jump_nowhere", "", "signal"},
    {"new_much", "", "needed more than 512 MB of memory"},
    {"malloc_much", "", "malloc_much: Cannot allocate memory"},
    {"map_much", "", "map_much: Cannot allocate memory"},
    {"grow", "", "needed more than 512 MB of memory"},
};

TEST(Hostile, EveryAttackHasItsExpectation) {
  ASSERT_EQ(std::size(kExpected), std::size(hostile::kAttacks));
  for (std::size_t i = 0; i < std::size(kExpected); ++i)
    EXPECT_STREQ(kExpected[i].name, hostile::kAttacks[i].name);
}

const std::string kPrograms = base::source_folder() + "/tests/brought_code/hostile/";
constexpr const char* kMap =
    "MISSION-AREA 1000 1000\nCONTROL MEASURES:\nAA Here 0 0 100 0 100 100 0 100\nPP There 900 50\n";

/// Robot 1 is the attacker, 2 and 3 are of a program of somebody else's.
class Siege {
 public:
  Siege(const World& world, std::size_t attack, const cell::Permission& permission)
      : team_((write(world, attack), "m.mdl"), sources(world, permission)) {}

  Team& team() { return team_; }
  /// Until the attacker is done, one way or the other.
  void carry_out() {
    for (int i = 0; i < 40 && team_.robot(1).life != RobotLife::kFaulted; ++i) {
      team_.step(1);
      const auto& robot = team_.robot(1);
      got_ = got_ || (robot.life == RobotLife::kRunning &&
                      flow::Program::number(robot.workings().frame, *robot.workings().program->find("attack"))
                              .value_or(0.0) > 0.5);
      if (got_) break;
    }
  }
  bool got() const { return got_; }

 private:
  static robot::ProgramSources sources(const World& world, const cell::Permission& permission) {
    robot::ProgramSources out = sources_in(world.path("project"), permission);
    out.limits.cycle = 0.3;
    out.limits.cycle_wall = 0.7;
    return out;
  }
  static void write(const World& world, std::size_t attack) {
    world.write("project/map.odl", kMap);
    world.write(
        "project/m.mdl",
        fmt::format(
            "OVERLAY map.odl\nNEW-ROBOT evil \"{0}evil.cnl\" (which = {1}, {2})\nNEW-ROBOT good "
            "\"{0}good.cnl\"\n"
            "UNIT <u> evil good good\nCOMMAND LIST:\n0. UNIT u START Here 0 10\n1. UNIT u MOVETO There\n",
            kPrograms, attack, world.parameters()));
  }

  Team team_;
  bool got_ = false;
};

class HostileProcedure : public ::testing::TestWithParam<std::size_t> {
 protected:
  const Expected& expected() const { return kExpected[GetParam()]; }
};

TEST_P(HostileProcedure, ReachesNothingAndIsTold) {
  if (cell::kIsSanitized) GTEST_SKIP() << "sanitizers want more than a cell gives";
  const World world;
  Siege siege(world, GetParam(), code_permitted());
  Team& team = siege.team();
  ASSERT_TRUE(team.run) << team.all();
  siege.carry_out();
  EXPECT_FALSE(siege.got());
  EXPECT_EQ(world.traces(), std::set<std::string>{});
  EXPECT_EQ(team.robot(1).life, RobotLife::kFaulted) << team.all();
  const std::string told =
      *expected().told != '\0' ? expected().told : fmt::format("saying: {}: ", expected().name);
  EXPECT_TRUE(team.was_told(told)) << told << "\n" << team.all();
  // Who writes over everything that is shared wipes out whose turn it was.
  EXPECT_TRUE(team.was_told("procedure `Attack`") || expected().name == std::string("scribble"))
      << team.all();
  const geom::Point before = team.run->fleet().pose(team.robot(2)).position;
  team.step(10);
  for (const std::uint32_t id : {2U, 3U}) EXPECT_EQ(team.robot(id).life, RobotLife::kRunning) << team.all();
  EXPECT_NE(team.run->fleet().pose(team.robot(2)).position, before) << "the others go on";
}

TEST_P(HostileProcedure, SucceedsWithoutACell) {
  if (*expected().trace == '\0') GTEST_SKIP() << "it harms its own process alone";
  const World world;
  Siege siege(world, GetParam(), permitted_without_cell());
  ASSERT_TRUE(siege.team().run) << siege.team().all();
  siege.carry_out();
  std::set<std::string> reached = world.traces();
  if (siege.got()) reached.insert("got");
  if (!reached.contains(expected().trace) && !expected().is_always_possible)
    GTEST_SKIP() << "not possible here without a cell either";
  EXPECT_TRUE(reached.contains(expected().trace)) << siege.team().all();
}

INSTANTIATE_TEST_SUITE_P(Hostile, HostileProcedure, ::testing::Range(std::size_t{0}, std::size(kExpected)),
                         [](const auto& each) { return std::string(kExpected[each.param].name); });

}  // namespace
}  // namespace mlab::brought_code
