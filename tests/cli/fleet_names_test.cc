// Names of fleets and agents, and the hints that are given where nobody is there.

#include <string>

#include "command.h"

namespace mlab {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(Command, FleetsAndAgentsHaveNames) {
  for (const std::string command :
       {"fleet \"\" --once", "keys \"\"", "agent --fleet \"\"", "agent --name \"\"",
        "run x.mdl --headless --robots fleet --fleet \"\""}) {
    const Outcome o = mlab(command, "timeout 30");
    EXPECT_EQ(o.status, 2) << command << o.out;
    EXPECT_TRUE(has(o.err, "`` can't be a name here: expected 1 to 64 letters, digits, `-`, `_` and `.`"))
        << command << ": " << o.err;
  }
}

TEST_F(Command, NoNameIsAPath) {
  for (const std::string command :
       {"fleet .. --once", "fleet . --once", "fleet ../x --once", "keys ..", "agent --fleet ..",
        "agent --name ..", "agent --fleet a/b", "run x.mdl --headless --robots fleet --fleet .."}) {
    const Outcome o = mlab(command, "timeout 30");
    EXPECT_EQ(o.status, 2) << command << o.out;
    EXPECT_TRUE(has(o.err,
                    "can't be a name here: expected 1 to 64 letters, digits, `-`, `_` and `.`, not dots "
                    "alone"))
        << command << ": " << o.err;
  }
}

// Whoever leaves a name out must not get a fleet that is not secured.
TEST_F(Command, NoOptionIsTakenForAName) {
  for (const std::string command :
       {"agent --fleet --secure", "agent --fleet alpha --name --secure", "fleet alpha --log --secure",
        "run x.mdl --headless --robots fleet --fleet --secure"}) {
    const Outcome o = mlab(command, "timeout 30");
    EXPECT_EQ(o.status, 2) << command << o.out;
    EXPECT_TRUE(has(o.err, "`--secure` can't be a name here: it begins as an option does"))
        << command << ": " << o.err;
  }
}

TEST_F(Command, NamesThatCanNotBeAreShownOnOneLine) {
  for (const std::string command : {"fleet $'a\\nb\\x1b[2J' --once", "keys $'a\\nb\\x1b[2J'",
                                    "agent --fleet $'a\\nb\\x1b[2J'", "agent --name $'a\\nb\\x1b[2J'"}) {
    write("try.sh", "exec '" MLAB_COMMAND "' " + command);
    const Outcome o = mlab("--version > /dev/null; timeout 30 bash try.sh");
    EXPECT_EQ(o.status, 2) << command << o.out;
    EXPECT_TRUE(has(o.err, "`a\\x0ab\\x1b[2J` can't be a name here")) << command << ": " << o.err;
    EXPECT_FALSE(has(o.err, "\x1b")) << command;
  }
}

TEST_F(Command, HintsCanBePasted) {
  const Outcome o =
      mlab("fleet nobody-" + std::to_string(::getpid()) + " --once --network 127.0.0.1", "timeout 60");
  EXPECT_TRUE(has(o.out, " --network 127.0.0.1` starts an agent")) << o.out << o.err;
}

TEST_F(Command, WhatIsAskedOfAFleetIsNotAskedAsJson) {
  for (const std::string option : {"--stop", "--release", "--log north"}) {
    const Outcome o = mlab("fleet nobody-" + std::to_string(::getpid()) + " --json " + option, "timeout 60");
    EXPECT_EQ(o.status, 2) << option << o.out;
    EXPECT_TRUE(has(o.err, "--json excludes ")) << o.err;
  }
}

TEST_F(Command, WhereNobodyIsSeenTheOptionsThatMayShowSomebodyAreNamed) {
  const std::string fleet = "nobody-" + std::to_string(::getpid());
  const std::string before = "XDG_STATE_HOME=\"$PWD/state\" timeout 60";
  const Outcome open = mlab("fleet " + fleet + " --once", before);
  EXPECT_TRUE(has(open.out, "another interface than loopback is seen with the same `--network`")) << open.out;
  EXPECT_FALSE(has(open.out, "--secure")) << open.out;
  ASSERT_EQ(mlab("keys " + fleet, before).status, 0);
  const Outcome stop = mlab("fleet " + fleet + " --stop", before);
  EXPECT_EQ(stop.status, 1);
  EXPECT_TRUE(has(stop.err, "is seen with the same `--network`")) << stop.err;
  EXPECT_TRUE(has(stop.err, "secured members are seen with `--secure`")) << stop.err;
}

TEST_F(Command, AHostIsNotedOnlyWhereItDoesNotCount) {
  write("hosts.mdl",
        "NEW-ROBOT scout \"robot\" green \"north\"\nUNIT <a> scout\nCOMMAND LIST:\n0. UNIT b START Here\n");
  const Outcome here = mlab("run hosts.mdl --headless", "timeout 60");
  EXPECT_TRUE(has(here.err, "host-needs-fleet")) << here.err;
  const Outcome there = mlab(
      "run hosts.mdl --headless --robots fleet --fleet nobody-" + std::to_string(::getpid()), "timeout 60");
  EXPECT_FALSE(has(there.err, "host-needs-fleet")) << there.err;
  EXPECT_TRUE(has(there.err, "unknown-unit")) << there.err;
}

}  // namespace
}  // namespace mlab
