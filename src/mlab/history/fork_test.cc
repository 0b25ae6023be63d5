#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/history/branch.h"
#include "mlab/history/testing/meddler.h"
#include "mlab/history/testing/written_run.h"
#include "mlab/history/timeline.h"

namespace mlab::history {
namespace {

using testing::all_of;
using testing::Meddler;
using testing::WrittenRun;

ReplayTools fork_tools() {
  return {cell::testing::code_permitted(), base::source_folder() + "/src", "test", {}, 1};
}

// The whole line is known, with a checkpoint after each cycle, however long one takes.
std::unique_ptr<Timeline> known_line(const WrittenRun& written) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  text::Diagnostics sink;
  auto out = Timeline::make(written.history(), fork_tools(), {.spacing = 0.0, .most_share = kAny}, sink);
  EXPECT_NE(out, nullptr) << text::render(sink);
  while (out && out->advance(1.0)) {
  }
  return out;
}

struct Compared {
  std::uint64_t parted = 0;  ///< the first cycle in which it is not the run itself; 0: there is none
  std::uint64_t cycles = 0;  ///< that were compared
};

// A future that departs late is computed from a checkpoint, and is the same as computed from its beginning.
Compared expect_as_from_the_beginning(Timeline& line, const WrittenRun& written, const Departure& departure,
                                      std::uint64_t cycles) {
  EXPECT_FALSE(line.go_to(departure.cycle));
  const auto made = branch(*written.history(), departure, line.run().mission());
  EXPECT_TRUE(made);
  if (!made) return {};
  made->history->reach(departure.cycle + cycles, line.run().time() + 1000.0);
  Timeline::Fork fork = line.fork(made->history, departure.cycle);
  EXPECT_GT(fork.other->run().cycle() + 60, departure.cycle) << "from a checkpoint near to it";
  EXPECT_EQ(fork.own->run().cycle(), fork.other->run().cycle());
  text::Diagnostics sink;
  const auto whole = Replay::make(made->history, fork_tools(), sink);
  while (whole->run().cycle() < fork.other->run().cycle()) EXPECT_TRUE(whole->step());
  Compared out;
  while (whole->step()) {
    EXPECT_TRUE(fork.other->step());
    const std::uint64_t now = all_of(fork.other->run());
    EXPECT_EQ(now, all_of(whole->run())) << "cycle " << whole->run().cycle();
    const bool is_known = fork.own->step();
    if (is_known) {
      EXPECT_EQ(all_of(fork.own->run()), written.values()[fork.own->run().cycle() - 1]);
    }
    ++out.cycles;
    if (out.parted == 0 && is_known && now != all_of(fork.own->run())) out.parted = whole->run().cycle();
    if (::testing::Test::HasFailure()) return out;
  }
  EXPECT_FALSE(fork.other->step());
  return out;
}

TEST(Fork, ThatDepartsLateIsTheSameAsFromTheBeginningWhateverPeopleDid) {
  for (std::uint32_t seed = 1; seed <= 2; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    WrittenRun written("demo_c/demo_c.mdl", seed);
    written.run().post(mission::event::Execute{});
    Meddler meddler(written, seed);
    for (int i = 0; i < 80; ++i) {
      meddler.meddle();
      for (int cycles = meddler.below(12); cycles > 0; --cycles) written.step();
    }
    written.end();
    const std::uint64_t last = written.history()->last_cycle();
    ASSERT_GT(last, 150U);
    const auto line = known_line(written);
    ASSERT_NE(line, nullptr);
    for (const bool with_later : {true, false}) {
      for (const std::uint64_t cycle : {std::uint64_t{0}, last / 3, last - 40, last}) {
        SCOPED_TRACE("departs after cycle " + std::to_string(cycle));
        expect_as_from_the_beginning(*line, written, {cycle, 0.0, {}, {}, with_later},
                                     with_later ? last - cycle : 40);
        if (HasFailure()) return;
      }
    }
  }
}

TEST(Fork, DepartsWithAnOrderAndWithAnotherText) {
  WrittenRun written("demo_c/demo_c.mdl", 3, true);
  written.run().post(mission::event::Execute{});
  while (written.run().cycle() < 300 && written.step()) {
  }
  const auto line = known_line(written);
  ASSERT_NE(line, nullptr);
  const Compared order =
      expect_as_from_the_beginning(*line, written, {250, 25.0, {}, {"UNIT scouts STOP"}, true}, 50);
  EXPECT_GT(order.parted, 250U);
  EXPECT_LT(order.parted, 260U);
  ASSERT_FALSE(line->go_to(250));
  const text::SourcePtr mission = line->run().mission().source;
  const Compared text = expect_as_from_the_beginning(
      *line, written,
      {250, 25.0, {{mission->name(), std::string(mission->text()) + "\n-- more\n"}}, {}, true}, 50);
  EXPECT_EQ(text.parted, 0U) << "a remark changes nothing";
  EXPECT_GE(text.cycles, 50U);
}

TEST(Fork, IsTheSameWhereProceduresRunInACell) {
  WrittenRun written("forage/forage.mdl", 3, true);
  written.run().post(mission::event::Execute{});
  while (written.run().cycle() < 300 && written.step()) {
  }
  const auto line = known_line(written);
  ASSERT_NE(line, nullptr);
  const std::uint64_t last = written.history()->last_cycle();
  ASSERT_GT(last, 60U);
  const Compared same = expect_as_from_the_beginning(*line, written, {last - 50, 0.0, {}, {}, true}, 50);
  EXPECT_EQ(same.parted, 0U);
  EXPECT_GE(same.cycles, 50U);
}

}  // namespace
}  // namespace mlab::history
