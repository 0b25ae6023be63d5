#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/console/testing/browser.h"
#include "mlab/history/history.h"
#include "mlab/history/replay.h"
#include "mlab/history/testing/written_run.h"

namespace mlab::console {
namespace {

using testing::Browser;
using testing::TestSession;

ToServer what_if(std::uint64_t cycle, double seconds = 0.0) {
  ToServer out;
  out.mutable_what_if()->set_cycle(cycle);
  out.mutable_what_if()->set_seconds(seconds);
  return out;
}

ToServer with_order(ToServer out, const std::string& line) {
  out.mutable_what_if()->add_changes()->set_order(line);
  return out;
}

ToServer with_parameter(ToServer out, std::uint32_t robot, const std::string& port,
                        const std::string& value) {
  WhatIf::Parameter& set = *out.mutable_what_if()->add_changes()->mutable_parameter();
  set.add_robots(robot);
  set.set_port(port);
  set.set_value(value);
  return out;
}

// A run of Demo C of half a minute, with an order of the operator in it, paused.
struct Paused {
  TestSession session{"demo_c/demo_c.mdl", 100.0};
  Browser anna{session, "Anna"};

  void run() {
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
    ASSERT_EQ(anna.control(Control::EXECUTE), "");
    ASSERT_TRUE(anna.wait([&] { return anna.status().time() >= 15.0; }));
    ASSERT_EQ(anna.type("UNIT scouts MOVETO ATK-AP1"), "");
    ASSERT_TRUE(anna.wait([&] { return anna.status().time() >= 30.0; }));
    ASSERT_EQ(anna.control(Control::PAUSE), "");
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::PAUSED; }));
  }
  /// Once nothing of it is missing.
  const OtherFuture& future(const ToServer& asked) {
    EXPECT_EQ(Browser::error_of(anna.ask(asked)), "");
    anna.wait([&] {
      const OtherFuture& told = anna.other_future();
      const bool is_it = told.name() != "" && told.from_cycle() == asked.what_if().cycle() &&
                         told.changes_size() == asked.what_if().changes_size();
      return is_it && !told.is_under_way();
    });
    return anna.other_future();
  }
};

// As from a file.
std::shared_ptr<history::History> as_read(const history::testing::WrittenRun& written) {
  auto history = std::make_shared<history::History>();
  for (const wire::HistoryEntry& entry : written.entries()) EXPECT_FALSE(history->add(entry));
  return history;
}

std::shared_ptr<history::History> recording(std::uint64_t seed, int cycles, const std::string& line = "") {
  history::testing::WrittenRun written("demo_c/demo_c.mdl", seed, true);
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < cycles; ++i) {
    if (i == 100 && !line.empty()) written.type(line);
    written.step();
  }
  written.end();
  return as_read(written);
}

TEST(OtherFutures, WithoutAChangeAreTheRunItself) {
  Paused paused;
  paused.run();
  for (const std::uint64_t cycle : {0U, 100U, 200U}) {
    const OtherFuture& future = paused.future(what_if(cycle));
    EXPECT_EQ(future.problem(), "");
    EXPECT_FALSE(future.has_parting()) << future.parting().cycle();
    EXPECT_EQ(future.own().cycle(), future.other().cycle());
    EXPECT_EQ(future.own().digest(), future.other().digest());
    EXPECT_EQ(future.robots_size(), 4);
    for (const OtherFuture::Robot& robot : future.robots()) EXPECT_EQ(robot.most_apart(), 0.0);
  }
}

TEST(OtherFutures, PartWithAnotherOrder) {
  Paused paused;
  paused.run();
  const double before = paused.anna.status().time();
  const OtherFuture& future = paused.future(with_order(what_if(100, 40.0), "UNIT scouts STOP"));
  EXPECT_EQ(future.problem(), "");
  EXPECT_EQ(future.from_cycle(), 100U);
  ASSERT_TRUE(future.has_parting());
  EXPECT_GT(future.parting().cycle(), 100U);
  EXPECT_LT(future.parting().cycle(), 130U);
  ASSERT_EQ(future.robots_size(), 4);
  EXPECT_GT(future.robots(0).most_apart(), 0.1);
  EXPECT_EQ(future.robots(0).x_size(), future.times_size());
  EXPECT_EQ(future.robots(0).apart(0), 0.0F);
  EXPECT_EQ(future.changes(0), "the order `UNIT scouts STOP`");
  // The run knows nothing of it.
  EXPECT_EQ(paused.anna.status().time(), before);
  EXPECT_FALSE(paused.anna.has_log("STOP"));
}

TEST(OtherFutures, PartWithAnotherParameter) {
  Paused paused;
  paused.run();
  ToServer read;
  read.mutable_read_changeable()->set_cycle(100);
  read.mutable_read_changeable()->set_robot(1);
  const Reply reply = paused.anna.ask(read);
  ASSERT_EQ(Browser::error_of(reply), "");
  const Changeable& changeable = reply.changeable();
  EXPECT_EQ(changeable.why_no_parameters(), "");
  EXPECT_GT(changeable.texts_size(), 1);
  std::string port;
  for (const Changeable::Parameter& one : changeable.parameters()) {
    if (one.port().path().find("base_velocity") != std::string::npos) port = one.port().path();
  }
  ASSERT_NE(port, "") << changeable.ShortDebugString().substr(0, 2000);
  const OtherFuture& future = paused.future(with_parameter(what_if(100), 1, port, "0.3"));
  EXPECT_EQ(future.problem(), "");
  ASSERT_TRUE(future.has_parting());
  EXPECT_GT(future.parting().cycle(), 100U);
}

bool has_told(const google::protobuf::RepeatedPtrField<Log::Entry>& told, const std::string& part) {
  return std::ranges::any_of(told, [&](const Log::Entry& entry) { return entry.text().contains(part); });
}

TEST(OtherFutures, TellWhatIsToldThereAlone) {
  Paused paused;
  paused.run();
  const OtherFuture& future = paused.future(with_order(what_if(100, 20.0), "UNIT scouts START AA-AA1 0 20"));
  EXPECT_EQ(future.problem(), "");
  const auto refused = std::ranges::find_if(future.told_other(), [](const Log::Entry& entry) {
    return entry.text().contains("can't be started again");
  });
  ASSERT_NE(refused, future.told_other().end()) << future.ShortDebugString().substr(0, 2000);
  EXPECT_TRUE(refused->is_alert());
  EXPECT_GE(refused->time(), 10.0);
  EXPECT_LT(refused->time(), 11.0);
  EXPECT_FALSE(has_told(future.told_own(), "can't be started again"));
  EXPECT_FALSE(paused.anna.has_log("can't be started again")) << "the run knows nothing of it";
  // What was told in both is in neither list, and what was told before they depart neither.
  for (const auto* told : {&future.told_own(), &future.told_other()}) {
    for (const Log::Entry& entry : *told) EXPECT_GE(entry.time(), 10.0) << entry.text();
  }
  EXPECT_FALSE(has_told(future.told_own(), "MOVETO ATK-AP1")) << "what people did later comes in there, too";
}

TEST(OtherFutures, OfTheRunItselfTellNothingApart) {
  Paused paused;
  paused.run();
  const OtherFuture& future = paused.future(what_if(100));
  EXPECT_TRUE(future.told_own().empty()) << future.told_own(0).text();
  EXPECT_TRUE(future.told_other().empty()) << future.told_other(0).text();
}

TEST(OtherFutures, MayBeOfSeveralChanges) {
  Paused paused;
  paused.run();
  const OtherFuture& future = paused.future(
      with_order(with_order(with_parameter(what_if(100, 20.0), 1, "base_velocity", "0.3"), "ROBOT 2 STOP"),
                 "ROBOT 3 STOP"));
  EXPECT_EQ(future.problem(), "");
  ASSERT_EQ(future.changes_size(), 3);
  EXPECT_EQ(future.changes(2), "the order `ROBOT 3 STOP`");
  ASSERT_EQ(future.robots_size(), 4);
  for (const int robot : {0, 1, 2}) EXPECT_GT(future.robots(robot).most_apart(), 0.5) << robot;
}

// As an editor says it, and before anything is computed.
TEST(OtherFutures, SayWhereAnotherTextIsWrong) {
  Paused paused;
  paused.run();
  ToServer read;
  read.mutable_read_changeable()->set_cycle(100);
  read.mutable_read_changeable()->set_robot(1);
  const Reply reply = paused.anna.ask(read);
  ToServer asked = what_if(100, 10.0);
  for (const Changeable::Text& text : reply.changeable().texts()) {
    if (!text.path().ends_with(".mdl")) continue;
    WhatIf::Text& other = *asked.mutable_what_if()->add_changes()->mutable_text();
    other.set_path(text.path());
    other.set_text(text.text() + "  99. UNIT scouts MOVETO ATK-AP77\n");
  }
  ASSERT_EQ(asked.what_if().changes_size(), 1);
  const std::string error = Browser::error_of(paused.anna.ask(asked));
  EXPECT_NE(error.find("demo_c.mdl:"), std::string::npos) << error;
  EXPECT_NE(error.find("ATK-AP77"), std::string::npos) << error;
  EXPECT_NE(error.find("did you mean"), std::string::npos) << error;
  EXPECT_EQ(paused.anna.other_future().name(), "");
  *asked.mutable_what_if()->add_changes() = asked.what_if().changes(0);
  EXPECT_NE(Browser::error_of(paused.anna.ask(asked)).find("two texts are given for"), std::string::npos);
}

TEST(OtherFutures, SayWhatIsNonsense) {
  Paused paused;
  paused.run();
  const auto error = [&](const ToServer& asked) { return Browser::error_of(paused.anna.ask(asked)); };
  EXPECT_EQ(error(with_parameter(what_if(100), 9, "speed", "1")), "there is no robot 9");
  EXPECT_EQ(error(with_parameter(what_if(100), 1, "nothing", "1")),
            "the program of robot 1 has no parameter `nothing`");
  EXPECT_NE(error(with_order(what_if(100), "UNIT scouts FLYTO ATK-AP1")).find("column 13"),
            std::string::npos);
  EXPECT_NE(error(with_order(what_if(100), " ")).find("the order is empty"), std::string::npos);
  EXPECT_NE(error(what_if(100'000)).find("cycle 100000 has not come"), std::string::npos);
  EXPECT_NE(error(what_if(10, -3.0)).find("expected 0 to 7200 s"), std::string::npos);
  ToServer text;
  text.mutable_what_if()->add_changes()->mutable_text()->set_path("/etc/passwd");
  EXPECT_NE(error(text).find("there is no text `/etc/passwd`"), std::string::npos);
  const std::string no_number = error(with_parameter(what_if(100), 1, "base_velocity", "fast"));
  EXPECT_TRUE(no_number.starts_with("`fast` is no number: `base_velocity` takes a number")) << no_number;
  EXPECT_EQ(paused.anna.control(Control::RESUME), "");
}

TEST(OtherFutures, AreForgottenOnTheWayAndWithTheRun) {
  Paused paused;
  paused.run();
  ASSERT_EQ(Browser::error_of(paused.anna.ask(what_if(10, 3600.0))), "");
  ToServer forget;
  forget.mutable_forget_future();
  ASSERT_EQ(Browser::error_of(paused.anna.ask(forget)), "");
  ASSERT_TRUE(paused.anna.wait([&] { return paused.anna.other_future().name().empty(); }));
  EXPECT_NE(paused.future(what_if(10, 20.0)).name(), "");
  ASSERT_EQ(paused.anna.control(Control::RESTART), "");
  EXPECT_TRUE(paused.anna.wait([&] { return paused.anna.other_future().name().empty(); }));
}

TEST(OtherFutures, AreSavedAsRecordings) {
  Paused paused;
  paused.run();
  paused.future(with_order(what_if(100, 20.0), "UNIT scouts STOP"));
  ToServer save;
  save.mutable_save_future();
  const Reply reply = paused.anna.ask(save);
  ASSERT_EQ(Browser::error_of(reply), "");
  EXPECT_EQ(reply.recording().name(), "what_if_10.0s.mcap");
  EXPECT_EQ(reply.recording().content().substr(1, 4), "MCAP");
  EXPECT_GT(reply.recording().content().size(), 2000U);
}

TEST(OtherFutures, ShowTwoRecordingsBesideEachOther) {
  TestSession session("", 50.0, [&](SessionSettings& settings) {
    settings.recording = {"a", recording(3, 400)};
    settings.against = {"b", recording(3, 300, "UNIT scouts STOP")};
  });
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.other_future().robots_size() == 4; }));
  const OtherFuture& future = anna.other_future();
  EXPECT_EQ(future.name(), "b");
  EXPECT_TRUE(future.is_recording());
  EXPECT_EQ(future.own().cycle(), 400U);
  EXPECT_EQ(future.other().cycle(), 300U);
  for (const OtherFuture::End* end : {&future.own(), &future.other()})
    EXPECT_NE(end->outcome(), "goes on")
        << "a recording says how it ended, also one that is as long as it is wanted";
  EXPECT_TRUE(future.remarks().empty());
  ASSERT_TRUE(future.has_parting());
  EXPECT_GT(future.parting().cycle(), 100U);
  // One's own comes in its place, for as long as it is there.
  ASSERT_EQ(Browser::error_of(anna.ask(what_if(50, 10.0))), "");
  ASSERT_TRUE(anna.wait(
      [&] { return anna.other_future().name() == "What if" && !anna.other_future().is_under_way(); }));
  ToServer forget;
  forget.mutable_forget_future();
  ASSERT_EQ(Browser::error_of(anna.ask(forget)), "");
  EXPECT_TRUE(anna.wait([&] { return anna.other_future().name() == "b"; }));
}

TEST(OtherFutures, EndAsTheRecordingDidWhereNothingIsChanged) {
  history::testing::WrittenRun written("demo_c/demo_c.mdl", 3, true);
  written.run().post(mission::event::Execute{});
  while (written.step()) {
  }
  ASSERT_TRUE(written.run().is_over());
  written.end("done");
  TestSession session("", 50.0,
                      [&](SessionSettings& settings) { settings.recording = {"a", as_read(written)}; });
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.time_line().last_cycle() > 0; }));
  ASSERT_EQ(Browser::error_of(anna.ask(what_if(0))), "");
  ASSERT_TRUE(anna.wait([&] { return anna.other_future().has_other(); }));
  EXPECT_FALSE(anna.other_future().has_parting());
  EXPECT_EQ(anna.other_future().own().outcome(), "done");
  EXPECT_EQ(anna.other_future().other().outcome(), "done");
  // What the last cycle says is said in both.
  for (const auto* told : {&anna.other_future().told_own(), &anna.other_future().told_other()})
    EXPECT_TRUE(told->empty()) << told->at(0).text();
}

// So many cycles that not each of them is sampled.
TEST(OtherFutures, AreApartByWhatAllCyclesSay) {
  const auto own = recording(3, 1500);
  const auto other = recording(3, 1500, "UNIT scouts STOP");
  double most = 0.0;
  double at = 0.0;
  {
    text::Diagnostics none;
    const auto one = history::Replay::make(own, {}, none);
    const auto two = history::Replay::make(other, {}, none);
    ASSERT_TRUE(one && two);
    while (one->step() && two->step()) {
      const geom::Point here = one->run().fleet().pose(*one->run().fleet().find({1})).position;
      const geom::Point there = two->run().fleet().pose(*two->run().fleet().find({1})).position;
      if (!(geom::distance(here, there) > most)) continue;
      most = geom::distance(here, there);
      at = one->run().time();
    }
  }
  TestSession session("", 50.0, [&](SessionSettings& settings) {
    settings.recording = {"a", own};
    settings.against = {"b", other};
  });
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.other_future().robots_size() == 4; }));
  ASSERT_LT(anna.other_future().times_size(), 1000);
  EXPECT_EQ(anna.other_future().robots(0).robot(), 1U);
  EXPECT_EQ(anna.other_future().robots(0).most_apart(), most);
  EXPECT_EQ(anna.other_future().robots(0).most_apart_at(), at);
}

TEST(OtherFutures, SayThatTwoRecordingsBeganOtherwise) {
  TestSession session("", 50.0, [&](SessionSettings& settings) {
    settings.recording = {"a", recording(3, 50)};
    settings.against = {"b", recording(4, 50)};
  });
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.other_future().has_own(); }));
  ASSERT_EQ(anna.other_future().remarks_size(), 1);
  EXPECT_EQ(anna.other_future().remarks(0), "seed: 3 and 4");
}

}  // namespace
}  // namespace mlab::console
