#include "mlab/history/branch.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/history/digest.h"
#include "mlab/history/replay.h"
#include "mlab/history/testing/written_run.h"

namespace mlab::history {
namespace {

using testing::all_of;
using testing::WrittenRun;

ReplayTools branch_tools() {
  return {cell::testing::code_permitted(), base::source_folder() + "/src", "test", {}, 1};
}

std::unique_ptr<Replay> replay_of(const std::shared_ptr<History>& history) {
  text::Diagnostics problems;
  return Replay::make(history, branch_tools(), problems);
}

// With an order, another version of the mission and a pause on the way.
void carry_out_with_people(WrittenRun& written) {
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < 100; ++i) written.step();
  written.type("UNIT scouts MOVETO ATK-AP1");
  for (int i = 0; i < 100; ++i) written.step();
  written.run().post(mission::event::Pause{});
  written.run().post(mission::event::Resume{});
  for (int i = 0; i < 200; ++i) written.step();
}

TEST(Branch, WithoutAChangeIsTheRunItself) {
  for (const char* const file : {"demo_c/demo_c.mdl", "forage/forage.mdl"}) {
    WrittenRun written(file, 3, true);
    if (std::string(file).starts_with("demo_c"))
      carry_out_with_people(written);
    else
      written.run().post(mission::event::Execute{});
    while (written.run().cycle() < 500 && written.step()) {
    }
    const auto original = written.history();
    for (const std::uint64_t cycle : {0U, 1U, 100U, 150U, 200U}) {
      const auto made = branch(*original, {cycle, 0.0, {}, {}, true}, written.run().mission());
      ASSERT_TRUE(made) << made.error();
      made->history->reach(written.run().cycle(), written.run().time());
      const auto replay = replay_of(made->history);
      ASSERT_NE(replay, nullptr);
      std::size_t at = 0;
      while (replay->step())
        ASSERT_EQ(all_of(replay->run()), written.values().at(at++)) << file << " " << cycle;
      EXPECT_FALSE(replay->divergence()) << replay->divergence()->why;
      EXPECT_EQ(digest_of(replay->run()), digest_of(written.run())) << file << " " << cycle;
    }
  }
}

TEST(Branch, DepartsWithAnOrder) {
  WrittenRun written("demo_c/demo_c.mdl", 3, true);
  carry_out_with_people(written);
  const auto made =
      branch(*written.history(), {50, 5.0, {}, {"UNIT scouts STOP"}, true}, written.run().mission());
  ASSERT_TRUE(made) << made.error();
  made->history->reach(400, 40.0);
  const auto replay = replay_of(made->history);
  ASSERT_NE(replay, nullptr);
  std::uint64_t parted = 0;
  while (replay->step()) {
    const std::uint64_t cycle = replay->run().cycle();
    if (parted == 0 && all_of(replay->run()) != written.values().at(cycle - 1)) parted = cycle;
  }
  EXPECT_GT(parted, 50U);
  EXPECT_LT(parted, 55U);
}

TEST(Branch, LeavesOutWhatPeopleDidAfterwards) {
  WrittenRun written("demo_c/demo_c.mdl", 3, true);
  carry_out_with_people(written);
  const auto made = branch(*written.history(), {50, 5.0, {}, {}, false}, written.run().mission());
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(made->history->inputs().size(), 1U);
  EXPECT_EQ(made->history->last_cycle(), 50U);
}

TEST(Branch, TakesAnotherTextOfAProgram) {
  WrittenRun written("forage/forage.mdl", 3, true);
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < 100; ++i) written.step();
  text::SourcePtr program;
  for (const std::uint32_t id : written.history()->version_at(50).texts()) {
    const text::SourcePtr text = written.history()->text(id);
    if (text->name().ends_with("forager.cdl")) program = text;
  }
  ASSERT_NE(program, nullptr);
  const std::string other = std::string(program->text()) + "\n";
  const auto made =
      branch(*written.history(), {50, 5.0, {{program->name(), other}}, {}, true}, written.run().mission());
  ASSERT_TRUE(made) << made.error();
  EXPECT_TRUE(made->takes_over);
  made->history->reach(120, 12.0);
  const auto replay = replay_of(made->history);
  ASSERT_NE(replay, nullptr);
  while (replay->step()) {
  }
  EXPECT_FALSE(replay->divergence()) << replay->divergence()->why;
  EXPECT_EQ(replay->run().takeovers().size(), 1U);
}

TEST(Branch, SaysWhereAnotherTextIsWrongBeforeItIsComputed) {
  WrittenRun written("forage/forage.mdl", 3, true);
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < 100; ++i) written.step();
  std::string path;
  for (const std::uint32_t id : written.history()->version_at(50).texts()) {
    const std::string& name = written.history()->text(id)->name();
    if (name.ends_with("forager.cdl")) path = name;
  }
  const auto made = branch(*written.history(),
                           {50, 5.0, {{path, "configuration Forager {\n  robot x: Nothing;\n}\n"}}, {}, true},
                           written.run().mission());
  ASSERT_TRUE(made) << made.error();
  const auto replay = replay_of(made->history);
  ASSERT_NE(replay, nullptr);
  EXPECT_FALSE(replay->why_not_understood(49));
  const auto why = replay->why_not_understood(50);
  ASSERT_TRUE(why);
  EXPECT_TRUE(why->starts_with("another version of the mission can't be made: forager.cdl:")) << *why;
}

TEST(Branch, SaysWhatIsNonsense) {
  WrittenRun written("demo_c/demo_c.mdl", 3, true);
  const auto error = [&](const Departure& departure) {
    const auto made = branch(*written.history(), departure, written.run().mission());
    return made ? std::string() : made.error();
  };
  EXPECT_NE(error({0, 0.0, {}, {"UNIT scouts FLYTO ATK-AP1"}, true}).find("column 13"), std::string::npos);
  EXPECT_EQ(error({0, 0.0, {}, {"UNIT scouts FLYTO ATK-AP1"}, true}).find(".mdl:"), std::string::npos);
  EXPECT_EQ(error({0, 0.0, {{"nowhere.cdl", ""}}, {}, true}),
            "there is no text `nowhere.cdl` that the mission of that moment is made from");
}

}  // namespace
}  // namespace mlab::history
