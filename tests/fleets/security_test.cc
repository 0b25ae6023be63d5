// Secured fleets: members work together as others do, and nobody else sees them or stops them.

#include "fleets.h"

namespace mlab::testing {
namespace {

namespace fs = std::filesystem;
using network::Host;
using network::Process;

const char* const kKeys = "/tmp/state/mlab/keys/alpha";
const char* const kOwn = "/tmp/state/mlab/keys/alpha/own";

class SecuredFleet : public Fleets {
 protected:
  struct Said {
    std::string ending;
    std::string output;
    std::string errors;
  };
  /// The command on a host, until it ends.
  Said mlab(Host& host, std::vector<std::string> words) {
    words.insert(words.begin(), MLAB_COMMAND);
    Process out = host.start(words, {.environment = {{"XDG_STATE_HOME", kAgentState}}});
    const auto ending = out.wait(kFleetPatience);
    return {ending ? ending->words() : "none", out.output(), out.errors()};
  }
  Said fleet(Host& host, const std::vector<std::string>& more) {
    std::vector<std::string> words = {"fleet", "alpha", "--network", host.address()};
    words.insert(words.end(), more.begin(), more.end());
    return mlab(host, words);
  }
  void make_keys(Host& host) {
    const Said made = mlab(host, {"keys", "alpha"});
    ASSERT_EQ(made.ending, "exit status 0") << made.errors;
  }
  /// A new identity, made on one host and brought to another.
  void bring(const std::string& name, Host& from, Host& to) {
    const Said made = mlab(from, {"keys", "alpha", "--add", name});
    ASSERT_EQ(made.ending, "exit status 0") << made.errors;
    bring_made(name, from, to);
  }
  static void bring_made(const std::string& name, Host& from, Host& to) {
    fs::create_directories(to.path(kOwn));
    for (const fs::directory_entry& one : fs::directory_iterator(from.path(std::string(kKeys) + "/" + name)))
      fs::copy_file(one.path(), fs::path(to.path(kOwn)) / one.path().filename());
  }
  static constexpr std::chrono::seconds kTwoYears = 730 * 24h;
  /// What `mlab keys alpha` makes on `base` so long ago.
  void make_keys_before(std::chrono::seconds ago, const std::vector<std::string>& more) {
    base().set_clock(-ago);
    std::vector<std::string> words = {MLAB_COMMAND, "keys", "alpha"};
    words.insert(words.end(), more.begin(), more.end());
    Process out =
        base().start(words, {.environment = {{"XDG_STATE_HOME", kAgentState}}, .follows_clock = true});
    const auto ending = out.wait(kFleetPatience);
    EXPECT_TRUE(ending && ending->words() == "exit status 0") << out.errors();
    base().set_clock(0s);
  }
  /// What `base` has withdrawn, told to another host.
  void bring_withdrawals(Host& to) {
    fs::copy_file(base().path(std::string(kKeys) + "/authority/withdrawn.crl"),
                  fs::path(to.path(kOwn)) / "withdrawn.crl", fs::copy_options::overwrite_existing);
  }
  Process secured_agent(const std::string& host) {
    Process out = net().host(host).start({MLAB_COMMAND, "agent", "--fleet", "alpha", "--name", host,
                                          "--network", net().host(host).address(), "--secure"},
                                         {.environment = {{"XDG_STATE_HOME", kAgentState}}});
    EXPECT_TRUE(out.prints("waits for runs", kFleetPatience)) << out.output() << out.errors();
    return out;
  }
  bool sees(Host& host, const std::string& agent) {
    for (const auto end = network::Clock::now() + kFleetPatience; network::Clock::now() < end;) {
      if (fleet(host, {"--once", "--secure"}).output.contains(agent)) return true;
    }
    return false;
  }
  /// A fleet of two agents, with keys of `base`.
  void make_members(std::uint64_t seed) {
    make_network(seed);
    ASSERT_NO_FATAL_FAILURE(make_keys(base()));
    ASSERT_NO_FATAL_FAILURE(bring("north", base(), net().host("north")));
    ASSERT_NO_FATAL_FAILURE(bring("south", base(), net().host("south")));
  }
};

// What a run tells of itself but for how fast it was.
Json outcome_in(Json report) {
  if (report.is_object()) report.erase("performance");
  return report;
}

TEST_F(SecuredFleet, GivesTheReportOfTheEmbeddedRunThoughPacketsAreLost) {
  ASSERT_NO_FATAL_FAILURE(make_members(41));
  net().set({.loss = 0.05, .delay = 1ms, .jitter = 500us});
  const Process north = secured_agent("north");
  const Process south = secured_agent("south");
  EXPECT_EQ(north.errors(), "") << "nobody else can have robots computed there";
  const std::string errand = base::source_folder() + "/tests/fleets/errand/errand.mdl";
  Process far = run(errand, {"--secure", kOwn});
  const auto ending = far.wait(2 * kFleetPatience);
  ASSERT_TRUE(ending) << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 0") << far.output() << far.errors();
  const Said embedded = mlab(base(), {"run", errand, "--headless", "--proceed", "--quiet", "--threads", "1",
                                      "--report", "/tmp/embedded.json"});
  ASSERT_EQ(embedded.ending, "exit status 0") << embedded.errors;
  const Json expected = outcome_in(report_in(base().path("/tmp/embedded.json")));
  EXPECT_TRUE(expected.is_object());
  EXPECT_EQ(expected.dump(2), outcome_in(report()).dump(2));
}

TEST_F(SecuredFleet, IsNeitherSeenNorStoppedByStrangers) {
  make_network(42);
  Host& north_host = net().host("north");
  Host& stranger = net().host("south");
  ASSERT_NO_FATAL_FAILURE(make_keys(base()));
  ASSERT_NO_FATAL_FAILURE(bring("north", base(), north_host));
  ASSERT_NO_FATAL_FAILURE(make_keys(stranger));  // of the same fleet's name, by another authority
  const Process north = secured_agent("north");
  ASSERT_TRUE(sees(base(), "north"));
  for (const std::vector<std::string>& secure : {std::vector<std::string>{}, {"--secure"}}) {
    std::vector<std::string> words = secure;
    words.emplace_back("--once");
    const Said looked = fleet(stranger, words);
    EXPECT_TRUE(looked.output.contains("nobody is there")) << looked.output << looked.errors;
    words.back() = "--stop";
    const Said stopped = fleet(stranger, words);
    EXPECT_EQ(stopped.ending, "exit status 1") << stopped.output;
    EXPECT_TRUE(stopped.errors.contains("nobody is there in the fleet `alpha`")) << stopped.errors;
  }
  EXPECT_FALSE(fleet(base(), {"--once", "--secure"}).output.contains("STOPPED"));
  EXPECT_FALSE(north.output().contains("EMERGENCY STOP")) << north.output();
  EXPECT_EQ(fleet(base(), {"--stop", "--secure"}).ending, "exit status 0") << "members can stop it";
  EXPECT_TRUE(north.prints("EMERGENCY STOP by base", kFleetPatience)) << north.output();
}

TEST_F(SecuredFleet, RefusesAMemberThatWasWithdrawn) {
  ASSERT_NO_FATAL_FAILURE(make_members(43));
  Host& south = net().host("south");
  const Process north = secured_agent("north");
  ASSERT_TRUE(sees(south, "north"));
  const Said withdrawn = mlab(base(), {"keys", "alpha", "--withdraw", "south"});
  ASSERT_EQ(withdrawn.ending, "exit status 0") << withdrawn.errors;
  bring_withdrawals(net().host("north"));
  EXPECT_TRUE(north.prints("somebody was withdrawn from the fleet: joins it anew", kFleetPatience))
      << north.output() << north.errors();
  EXPECT_TRUE(sees(base(), "north")) << "it is back";
  const Said looked = fleet(south, {"--once", "--secure"});
  EXPECT_TRUE(looked.output.contains("nobody is there")) << looked.output << looked.errors;
  bring_withdrawals(south);
  const Said told = fleet(south, {"--once", "--secure"});
  EXPECT_EQ(told.ending, "exit status 2");
  EXPECT_TRUE(told.errors.contains("was withdrawn: it takes part no more")) << told.errors;
}

TEST_F(SecuredFleet, TellsARunThatSomebodyWasWithdrawn) {
  ASSERT_NO_FATAL_FAILURE(make_members(47));
  const Process south = secured_agent("south");
  Process far =
      run(base::source_folder() + "/tests/fleets/errand/errand.mdl", {"--secure", kOwn, "--speed", "real"});
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience)) << far.output() << far.errors();
  EXPECT_FALSE(far.output().contains("withdrawn"));
  ASSERT_EQ(mlab(base(), {"keys", "alpha", "--withdraw", "south"}).ending, "exit status 0");
  EXPECT_TRUE(
      far.prints("somebody was withdrawn from the fleet `alpha`, and this run still trusts whom it trusted "
                 "when it began: its agents are `south`",
                 kFleetPatience))
      << far.output();
}

// An identity is good for two years: what was made a little less long ago runs out soon.
TEST_F(SecuredFleet, LeavesOneWhoseIdentityRunsOutAndSaysSo) {
  make_network(48);
  Host& north_host = net().host("north");
  make_keys_before(kTwoYears - 1h, {});
  make_keys_before(kTwoYears - 40s, {"--add", "north"});
  bring_made("north", base(), north_host);
  Process north = secured_agent("north");
  EXPECT_TRUE(
      north.prints("warning: the identity by which it belongs to the fleet runs out in less", kFleetPatience))
      << north.output();
  const Said keys = mlab(base(), {"keys", "alpha"});
  EXPECT_TRUE(
      keys.errors.contains("the identity `north` runs out in less than a day: `mlab keys alpha --withdraw"))
      << keys.errors;
  const Process far = run(mission("patrol"), {"--secure", kOwn, "--speed", "real"});
  EXPECT_TRUE(far.prints("this machine's identity in the fleet `alpha` runs out in", kFleetPatience))
      << far.output() << far.errors();
  const auto ending = north.wait(2 * kFleetPatience);
  ASSERT_TRUE(ending) << north.output();
  EXPECT_EQ(ending->words(), "exit status 2") << "nobody needs to start it again";
  EXPECT_TRUE(north.errors().contains("runs out at this moment")) << north.errors();
  EXPECT_TRUE(far.prints("the agent on `north` has left the fleet", kFleetPatience)) << far.output();
  std::this_thread::sleep_for(3s);
  const Said late = fleet(north_host, {"--once", "--secure"});
  EXPECT_EQ(late.ending, "exit status 2");
  EXPECT_TRUE(
      late.errors.contains("`mlab keys alpha --withdraw north` and then `mlab keys alpha --add north`"))
      << late.errors;
}

// Whoever is heard by nobody any more goes on, says why, and ends as the mission does; whatever its clock
// says by then.
TEST_F(SecuredFleet, ARunWhoseIdentityHasRunOutSaysSoAndGoesOn) {
  make_network(49);
  make_keys_before(kTwoYears - 30s, {});
  ASSERT_NO_FATAL_FAILURE(bring("north", base(), net().host("north")));
  const Process north = secured_agent("north");
  const std::vector<std::string> words = {MLAB_COMMAND,
                                          "run",
                                          mission("patrol"),
                                          "--headless",
                                          "--proceed",
                                          "--robots",
                                          "fleet",
                                          "--fleet",
                                          "alpha",
                                          "--network",
                                          base().address(),
                                          "--secure",
                                          kOwn,
                                          "--speed",
                                          "real",
                                          "--patience",
                                          "20"};
  Process far = base().start(words, {.follows_clock = true});
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience)) << far.output() << far.errors();
  base().set_clock(-1h);
  EXPECT_TRUE(far.prints("this machine's identity in the fleet `alpha` has run out: no agent hears this run",
                         kFleetPatience))
      << far.output();
  EXPECT_TRUE(far.prints("hears nothing of this run any more: this machine's identity", kFleetPatience))
      << far.output();
  const auto ending = far.wait(2 * kFleetPatience);
  ASSERT_TRUE(ending) << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 1") << far.output() << far.errors();
}

TEST_F(SecuredFleet, AnAgentWaitsUntilItsMachinesClockIsSet) {
  ASSERT_NO_FATAL_FAILURE(make_members(50));
  Host& north_host = net().host("north");
  north_host.set_clock(-900 * 24h);
  Process north = north_host.start({MLAB_COMMAND, "agent", "--fleet", "alpha", "--name", "north", "--network",
                                    north_host.address(), "--secure"},
                                   {.environment = {{"XDG_STATE_HOME", kAgentState}}, .follows_clock = true});
  EXPECT_TRUE(north.prints("waits until this machine's clock is set", kFleetPatience))
      << north.output() << north.errors();
  EXPECT_TRUE(north.errors().contains("is this machine's clock right?")) << north.errors();
  EXPECT_FALSE(north.output().contains("waits for runs"));
  north_host.set_clock(0s);
  EXPECT_TRUE(north.prints("waits for runs", kFleetPatience)) << north.output() << north.errors();
  EXPECT_FALSE(north.prints("somebody was withdrawn", 3s)) << "nobody was";
}

TEST_F(SecuredFleet, TakesOverAListThatIsNewerThanItsMachinesClockSays) {
  ASSERT_NO_FATAL_FAILURE(make_members(51));
  Host& north_host = net().host("north");
  north_host.set_clock(-20h);  // its identity counts from a day before it was made
  Process north = north_host.start({MLAB_COMMAND, "agent", "--fleet", "alpha", "--name", "north", "--network",
                                    north_host.address(), "--secure"},
                                   {.environment = {{"XDG_STATE_HOME", kAgentState}}, .follows_clock = true});
  ASSERT_TRUE(north.prints("waits for runs", kFleetPatience)) << north.output() << north.errors();
  base().set_clock(24h);
  Process withdraws = base().start({MLAB_COMMAND, "keys", "alpha", "--withdraw", "south"},
                                   {.environment = {{"XDG_STATE_HOME", kAgentState}}, .follows_clock = true});
  ASSERT_TRUE(withdraws.wait(kFleetPatience)) << withdraws.errors();
  bring_withdrawals(north_host);
  ASSERT_TRUE(north.prints("somebody was withdrawn from the fleet: joins it anew", kFleetPatience))
      << north.output() << north.errors();
  EXPECT_TRUE(sees(base(), "north")) << north.output() << north.errors();
}

TEST_F(SecuredFleet, HasNoHalfMadeIdentityAfterAFullDisk) {
  make_network(45);
  for (const std::size_t pages : {3U, 5U, 7U, 8U, 9U, 10U, 12U, 20U}) {
    const std::string disk = fmt::format("/tmp/disk{}", pages);
    ASSERT_EQ(base().mount_disk(disk, pages * 4096), "");
    const auto keys_on = [&](const std::string& folder, const std::vector<std::string>& more) {
      std::vector<std::string> words = {MLAB_COMMAND, "keys", "alpha"};
      words.insert(words.end(), more.begin(), more.end());
      Process out = base().start(words, {.environment = {{"XDG_STATE_HOME", folder}}});
      const auto ending = out.wait(kFleetPatience);
      return Said{ending ? ending->words() : "none", out.output(), out.errors()};
    };
    const Said full = keys_on(disk, {});
    const fs::path own = base().path(disk + "/mlab/keys/alpha/own");
    EXPECT_EQ(full.ending == "exit status 0", fs::exists(own / "identity.crt")) << pages << full.errors;
    EXPECT_EQ(keys_on(disk, {}).ending, full.ending) << "it is no better the second time: " << pages;
    // On a disk that has place what is there is made whole.
    fs::copy(base().path(disk), base().path(disk + "-larger"), fs::copy_options::recursive);
    const Said larger = keys_on(disk + "-larger", {});
    EXPECT_EQ(larger.ending, "exit status 0") << pages << larger.errors;
    EXPECT_TRUE(larger.output.contains("this machine's identity, which --secure uses")) << larger.output;
    EXPECT_TRUE(fs::exists(base().path(disk + "-larger/mlab/keys/alpha/own/identity.crt")));
    fs::remove_all(base().path(disk + "-larger"));
  }
}

TEST_F(SecuredFleet, SaysHowAWithdrawnOwnIdentityIsMadeAnew) {
  make_network(46);
  ASSERT_NO_FATAL_FAILURE(make_keys(base()));
  const Said withdrawn = mlab(base(), {"keys", "alpha", "--withdraw", "own"});
  EXPECT_TRUE(withdrawn.output.contains("`mlab keys alpha --add own` makes another")) << withdrawn.output;
  EXPECT_TRUE(mlab(base(), {"keys", "alpha"}).output.contains("`mlab keys alpha --add own` makes"));
  const Said joined = fleet(base(), {"--once", "--secure"});
  EXPECT_EQ(joined.ending, "exit status 2");
  EXPECT_TRUE(joined.errors.contains("`mlab keys alpha --add own` makes its identity")) << joined.errors;
  EXPECT_EQ(mlab(base(), {"keys", "alpha", "--add", "own"}).ending, "exit status 0");
  EXPECT_TRUE(
      mlab(base(), {"keys", "alpha"}).output.contains("this machine's identity, which --secure uses"));
}

TEST_F(SecuredFleet, IsNotMadeByAMistakeUnnoticed) {
  make_network(47);
  const Said refused = mlab(base(), {"keys", "alpha", "--add", "a b"});
  EXPECT_EQ(refused.ending, "exit status 2");
  EXPECT_TRUE(refused.errors.contains("`a b` can't be the name of an identity")) << refused.errors;
  const Said first = mlab(base(), {"keys", "alpha", "--add", "north"});
  EXPECT_TRUE(first.errors.contains("there were no keys of a fleet `alpha` here")) << first.errors;
  EXPECT_EQ(mlab(base(), {"keys", "alpha", "--add", "south"}).errors, "");
}

TEST_F(SecuredFleet, IsNotJoinedWithoutAnIdentity) {
  make_network(44);
  const Said joined = mlab(base(), {"agent", "--fleet", "alpha", "--secure"});
  EXPECT_EQ(joined.ending, "exit status 2");
  EXPECT_TRUE(
      joined.errors.contains("there is no folder `/tmp/state/mlab/keys/alpha/own`: `mlab keys alpha`"))
      << joined.errors;
}

}  // namespace
}  // namespace mlab::testing
