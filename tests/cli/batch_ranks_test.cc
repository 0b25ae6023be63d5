// `mlab batch` by several processes: by mpirun, in a Slurm array, by hand; and what becomes of it when some
// are killed.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "command.h"

namespace mlab {
namespace {

/// A batch that several processes do; and the table that it has when one does all.
class Ranks : public Command {
 protected:
  void SetUp() override {
    Command::SetUp();
    ASSERT_EQ(mlab(batch("whole.csv") + " --rank none").status, 0);
    whole_ = text_of(folder_ / "whole.csv");
    ASSERT_EQ(std::ranges::count(whole_, '\n'), 121);
  }
  static std::string batch(const std::string& table, const std::string& mission = "demo_c", int runs = 60) {
    return "batch " + kMissions + mission + "/" + mission + ".mdl --runs " + std::to_string(runs) +
           " --threads 1 --start-time '2026-03-01 08:30' --set base_velocity=4,5 --quiet "
           "--table '" +
           table + "'";
  }
  bool is_left(const std::string& name) const { return fs::exists(folder_ / name); }
  // Shell: until a rank has done runs, or all is done.
  static std::string runs_of(int rank, int lines = 3) {
    return "n=0; until [ $((n += 1)) -gt 3000 ] || [ $(cat t.csv.runs.rank-" + std::to_string(rank) +
           " 2>/dev/null | wc -l) -ge " + std::to_string(lines) + " ] || [ -e t.csv ]; do sleep 0.01; done; ";
  }
  // `count` processes, each with its rank; then the shell does `kill`, and waits for them.
  Outcome together(const std::string& arguments, int count, const std::string& kill = "") const {
    std::string script = "for r in";
    for (int i = 0; i < count; ++i) script += " " + std::to_string(i);
    script += "; do \"$1\" " + arguments + " --rank $r/" + std::to_string(count) +
              " </dev/null & eval p$r=$!; done\n" + kill + "\ns=0; for r in";
    for (int i = 0; i < count; ++i) script += " " + std::to_string(i);
    script += "; do eval wait '$p'$r || s=$?; done; exit $s\n";
    write("together.sh", script);
    return mlab("", "bash together.sh");
  }

  std::string whole_;
};

TEST_F(Ranks, HaveTheTableOfOne) {
  for (const int count : {2, 5}) {
    const Outcome out = together(batch("t.csv"), count);
    EXPECT_EQ(out.status, 0) << out.err;
    EXPECT_EQ(out.err, "");
    EXPECT_TRUE(text_of(folder_ / "t.csv") == whole_) << count << " processes";
    EXPECT_FALSE(is_left("t.csv.runs.rank-0"));
    fs::remove(folder_ / "t.csv");
    // Who comes late, or starts it once more, hears that it is done.
    const Outcome late = mlab(batch("t.csv") + " --rank 0/2");
    EXPECT_EQ(late.status, 0);
    EXPECT_TRUE(has(late.err, "this batch is done; to do it again, remove t.csv.runs")) << late.err;
    fs::remove(folder_ / "t.csv.runs");
  }
}

// One of three does nothing at all; it is killed at the very beginning, or in the middle of runs.
TEST_F(Ranks, DoWhatOneThatDiesLeavesBehind) {
  for (const std::string& moment :
       {std::string("sleep 0.01; "), runs_of(1, 1), runs_of(1, 2), runs_of(1, 9), runs_of(0, 25)}) {
    const Outcome out = together(batch("t.csv"), 3, moment + "kill -9 $p1");
    EXPECT_TRUE(text_of(folder_ / "t.csv") == whole_) << moment << out.err;
    fs::remove(folder_ / "t.csv");
    fs::remove(folder_ / "t.csv.runs");
  }
}

TEST_F(Ranks, AreGoneOnWithByAnyNumber) {
  together(batch("t.csv"), 3, runs_of(1) + "kill -9 $p0 $p1 $p2");
  ASSERT_FALSE(is_left("t.csv")) << "they were too fast to be killed";
  for (const char* rank : {" --rank none", " --rank 0/2"}) {
    const Outcome refused = mlab(batch("t.csv") + rank);
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(has(refused.err, "--resume goes on with them")) << refused.err;
  }
  const Outcome missing = mlab(batch("t.csv") + " --merge");
  EXPECT_EQ(missing.status, 1);
  EXPECT_TRUE(has(missing.err, "of 120 runs ")) << missing.err;
  together(batch("t.csv") + " --resume", 2, runs_of(0, 6) + "kill -9 $p0 $p1");
  const Outcome out = mlab(batch("t.csv") + " --resume --rank none");
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_TRUE(text_of(folder_ / "t.csv") == whole_);
  EXPECT_FALSE(is_left("t.csv.runs.rank-0"));
}

TEST_F(Ranks, OfASlurmArrayAreMerged) {
  const auto task = [&](int id) {
    return mlab(batch("t.csv"),
                "env SLURM_ARRAY_JOB_ID=71 SLURM_ARRAY_TASK_COUNT=2 SLURM_ARRAY_TASK_MIN=4 "
                "SLURM_ARRAY_TASK_STEP=3 SLURM_ARRAY_TASK_ID=" +
                    std::to_string(id));
  };
  EXPECT_EQ(task(4).status, 0);
  EXPECT_FALSE(is_left("t.csv"));
  EXPECT_TRUE(is_left("t.csv.runs.rank-4"));
  EXPECT_EQ(task(7).status, 0);
  const Outcome merged = mlab(batch("t.csv") + " --merge");
  EXPECT_EQ(merged.status, 0) << merged.err;
  EXPECT_TRUE(text_of(folder_ / "t.csv") == whole_);
  const Outcome again = mlab(batch("t.csv") + " --merge");
  EXPECT_EQ(again.status, 1);
  EXPECT_TRUE(has(again.err, "no run of this batch is kept in")) << again.err;
  EXPECT_EQ(task(7).status, 0) << "a task that waited too long has nothing to do";
  EXPECT_FALSE(is_left("t.csv.runs.rank-7"));
}

TEST_F(Ranks, StopEarlyAtTheSameRun) {
  const std::string early =
      "batch " + kMissions +
      "patrol/patrol.mdl --runs 2000 --require 'success >= 0.5' --until decided --start-time "
      "'2026-03-01 08:30' --quiet --threads 1 --table ";
  EXPECT_EQ(mlab(early + "one.csv --rank none").status, 0);
  const Outcome out = together(early + "t.csv", 3);
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_TRUE(text_of(folder_ / "t.csv") == text_of(folder_ / "one.csv"));
}

TEST_F(Ranks, AreRefusedWhereTheyCanNotBeTogether) {
  EXPECT_EQ(mlab(batch("t.csv") + " --rank 3/3").status, 2);
  EXPECT_EQ(mlab(batch("t.csv") + " --rank one").status, 2);
  const Outcome nowhere =
      mlab("batch " + kMissions + "demo_c/demo_c.mdl --runs 2", "env PMI_RANK=1 PMI_SIZE=4 PMI_JOBID=x");
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_TRUE(has(nowhere.err, "this is one of 4 processes")) << nowhere.err;
  // Two batches into one table.
  together(batch("t.csv", "demo_c", 1'000'000), 1,
           "n=0; until [ $((n += 1)) -gt 3000 ] || [ -s t.csv.runs ]; do sleep 0.01; done; \"$1\" " +
               batch("t.csv", "patrol") +
               " --rank 0/2 </dev/null 2>other.txt; echo $? >>other.txt; kill -9 $p0");
  const std::string other = text_of(folder_ / "other.txt");
  EXPECT_TRUE(has(other, "is in use by another batch that runs now\n2\n")) << other;
}

class Mpirun : public Ranks {
 protected:
  void SetUp() override {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): a test program has one thread
    if (std::system("command -v mpirun >/dev/null") != 0) GTEST_SKIP() << "there is no mpirun (openmpi-bin)";
    Ranks::SetUp();
  }
  static std::string mpirun(const std::string& more = "") {
    return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -n 3 " + more;
  }
};

TEST_F(Mpirun, StartsARankForEachShare) {
  const Outcome out = mlab(batch("t 1.csv"), mpirun());
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_TRUE(text_of(folder_ / "t 1.csv") == whole_);
}

TEST_F(Mpirun, GoesOnWithoutARankWhereItIsToldTo) {
  write("rank.sh",
        "if [ $OMPI_COMM_WORLD_RANK = 1 ]; then \"$@\" & " + runs_of(1) + "kill -9 $! $$; fi; exec \"$@\"\n");
  mlab(batch("t.csv"), mpirun("--mca orte_enable_recovery 1 bash rank.sh"));
  EXPECT_TRUE(text_of(folder_ / "t.csv") == whole_);
}

TEST_F(Mpirun, IsStartedAgainWhereItEndedAllOfThem) {
  write("rank.sh",
        "if [ $OMPI_COMM_WORLD_RANK = 0 ]; then \"$@\" & " + runs_of(0) + "kill -9 $! $$; fi; exec \"$@\"\n");
  const Outcome died = mlab(batch("t.csv"), mpirun("bash rank.sh"));
  EXPECT_NE(died.status, 0);
  ASSERT_FALSE(is_left("t.csv"));
  Outcome again;
  // Those that mpirun ended may still be at it when it has ended itself: then they are in use.
  for (int i = 0; i < 20 && again.status != 0; ++i) again = mlab(batch("t.csv") + " --resume", mpirun());
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_TRUE(text_of(folder_ / "t.csv") == whole_);
}

}  // namespace
}  // namespace mlab
