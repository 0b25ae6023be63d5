// A robot that a failsafe holds: its facts say so, and an order takes over.
import type { Locator } from "playwright-core";
import { expect, test } from "vitest";
import { begin } from "./begin.ts";

const kMission = `MISSION NAME "fenced"
OVERLAY demo_c.odl
FAILSAFE OUTSIDE Field HOLD
UNIT <a> ROBOT
COMMAND LIST:
  0. UNIT a START 100 100
  1. UNIT a MOVETO 400 100
`;
const kOverlay = `MISSION-AREA 500 200
CONTROL MEASURES:
BOUNDARY Field 20 20 200 20 200 180 20 180
`;

test("a robot that is held before a fence says so, and drives back by an order", async () => {
  const { console } = await begin({
    mission: "demo_c",
    prepare: (folder) => {
      folder.write("demo_c.mdl", kMission);
      folder.write("demo_c.odl", kOverlay);
    },
    options: ["--speed", "20"],
  });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  await (await console.panel("Log")).getByText(/Robot 1: .FAILSAFE OUTSIDE Field HOLD. acts/).waitFor();
  await console.select("Robot 1");
  const selection = await console.panel("Selection");
  const held = selection.getByTestId("failsafe");
  await held.getByText("FAILSAFE OUTSIDE Field HOLD").waitFor();
  await console.type("UNIT a MOVETO 60 100");
  await held.waitFor({ state: "detached" });
  await selection.getByText(/MOVETO 60 100/).waitFor();
  await (await console.panel("Log")).getByText(/Robot 1: .FAILSAFE OUTSIDE Field HOLD. is over/).waitFor();
  expect(await page.getByText("no progress").count()).toBe(0);
});

const kGuarded = `MISSION NAME "guarded"
OVERLAY demo_c.odl
FAILSAFE OUTSIDE Field HOLD
FAILSAFE LINK-LOST AFTER 5 RETURN
FAILSAFE IN-CONTACT AFTER 0.5 STOP
UNIT <a> ROBOT ROBOT
COMMAND LIST:
  0. UNIT a START 198 100 -60 0
  1. ROBOT 1 MOVETO 400 100 SPEED 0.3
`;

const guarded = (folder: { write(name: string, text: string): void }) => {
  folder.write("demo_c.mdl", kGuarded);
  folder.write("demo_c.odl", kOverlay);
};

test("a row of the table goes from armed over near to active before the eyes of who looks at it", async () => {
  const { console } = await begin({ mission: "demo_c", prepare: guarded, options: ["--speed", "1"] });
  await console.reaches("Ready");
  await console.select("Robot 1");
  const panel = await console.panel("Failsafes");
  const fence = panel.getByTestId("failsafe-1");
  await fence.getByText("OUTSIDE Field").waitFor();
  await fence.getByText("Off", { exact: true }).waitFor();
  await console.main.click();
  await fence.getByText("Armed", { exact: true }).waitFor();
  await panel.getByTestId("failsafe-2").getByText("looked at in real time only").waitFor();
  await fence.getByText("Near", { exact: true }).waitFor();
  await fence.getByText(/^0\.\d m to the line$/).waitFor();
  await fence.getByText("Active", { exact: true }).waitFor();

  // Of a unit the robot that is worst off; and in the facts of one robot how many rows stand how.
  await console.select("a");
  await fence.getByText("Active 1 of 2").waitFor();
  await fence.getByText(/^Robot 1: 0\.\d m to the line$/).waitFor();
  await console.select("Robot 2");
  await fence.getByText("Armed", { exact: true }).waitFor();
  const selection = await console.panel("Selection");
  await selection.getByRole("button", { name: "2 armed, 1 off" }).click();
  await panel.waitFor();
  await fence.getByText("What it means").click();
  await fence.getByText(/^The robot is about to leave the area/).waitFor();
  await fence.getByRole("button", { name: "demo_c.mdl, line 3" }).click();
  await console.page.getByRole("region", { name: "Text", exact: true }).waitFor();
});

/** Whether a person sees it without scrolling. */
const isInSight = (shown: Locator) =>
  shown.evaluate((element) => {
    const { left, top, bottom } = element.getBoundingClientRect();
    const seen = document.elementFromPoint(left + 2, (top + bottom) / 2);
    return seen !== null && element.contains(seen);
  });

test("conditions that a person sets are tried, and the run stays as it is", async () => {
  const { console } = await begin({ mission: "demo_c", prepare: guarded });
  await console.reaches("Ready");
  const panel = await console.panel("Failsafes");
  await panel.getByText("Select a robot or a unit").waitFor();
  const whatIf = panel.getByRole("region", { name: "What if?" });
  const answer = whatIf.getByRole("status");
  const tryIt = whatIf.getByRole("button", { name: "Try it" });
  await whatIf.getByText(/^Tried with Robot 1/).waitFor();
  await tryIt.click();
  await answer.getByText("OUTSIDE Field HOLD acts.").waitFor();
  await answer.getByText(/it stands, 4\.\d m from where it was, (at|0\.\d m before) the line\.$/).waitFor();

  await expect.poll(() => isInSight(answer.getByText("OUTSIDE Field HOLD acts."))).toBe(true);

  await whatIf.getByText("At a fence").click();
  await answer.waitFor({ state: "detached" });
  await whatIf.getByText("Link lost").click();
  await whatIf.getByText("nobody looks at it in this run").waitFor();
  await whatIf.getByText("In contact").click();
  const lengths = whatIf.getByRole("textbox", { name: "for [s]" });
  await lengths.nth(1).fill("0.2");
  await lengths.nth(1).press("Enter");
  await answer.getByText("LINK-LOST AFTER 5 RETURN acts.").waitFor();
  await answer.getByText(/^IN-CONTACT AFTER 0.5 STOP \(\d+ %\)$/).waitFor();

  // An answer goes with the first key, and nothing is tried while a number is wrong.
  await lengths.nth(1).fill("601");
  await answer.waitFor({ state: "detached" });
  await whatIf.getByText("At most 600.").waitFor();
  await whatIf.getByText("To be put right first: In contact.").waitFor();
  expect(await tryIt.isDisabled()).toBe(true);
  await lengths.nth(1).press("Enter");
  await lengths.nth(1).fill("1");
  expect(await answer.count()).toBe(0);
  await tryIt.click();
  await answer.getByText("IN-CONTACT AFTER 0.5 STOP is met, and acts").waitFor();
  await answer.getByText(/Its program has ended\.$/).waitFor();
  await console.reaches("Ready");
  expect(await console.time()).toBe(0);
});

test("a mission without failsafes says how one is written", async () => {
  const { console } = await begin({ mission: "demo_c" });
  await console.reaches("Ready");
  const panel = await console.panel("Failsafes");
  await panel.getByText("This mission has no failsafes.").waitFor();
  await panel.getByText(/FAILSAFE LINK-LOST AFTER 5 RETURN/).waitFor();
  await panel.getByRole("button", { name: "Open the text" }).click();
  await console.page.getByRole("region", { name: "Text", exact: true }).waitFor();
});

const kLongType = "a_type_of_robots_with_a_very_long_name_x";
const kOfTypes = `MISSION NAME "types"
OVERLAY demo_c.odl
NEW-ROBOT ${kLongType} "robot"
FAILSAFE FOR ${kLongType} OUTSIDE Field HOLD
FAILSAFE OUTSIDE Yard CONTINUE
UNIT <a> ROBOT
UNIT <b> ${kLongType}
COMMAND LIST:
  0. UNIT a START 100 100 AND UNIT b START 100 80
`;

test("what if offers the fences that are the robot's, in a panel that long names don't widen", async () => {
  const { console } = await begin({
    mission: "demo_c",
    prepare: (folder) => {
      folder.write("demo_c.mdl", kOfTypes);
      folder.write("demo_c.odl", `${kOverlay}BOUNDARY Yard 10 10 300 10 300 190 10 190\n`);
    },
  });
  await console.reaches("Ready");
  const panel = await console.panel("Failsafes");
  const whatIf = panel.getByRole("region", { name: "What if?" });
  const offered = () => whatIf.getByRole("combobox", { name: "Fence" }).locator("option").allTextContents();
  await expect.poll(offered).toEqual(["2. Yard"]);
  await whatIf.getByRole("textbox", { name: "Distance [m]" }).fill("2");
  await whatIf.getByRole("textbox", { name: "Distance [m]" }).press("Enter");
  await whatIf.getByRole("status").getByText("OUTSIDE Yard CONTINUE acts.").waitFor();
  await whatIf.getByText("What its program wants goes on but for the way out: the fence holds.").waitFor();

  await console.select("Robot 2");
  await whatIf.getByRole("status").waitFor({ state: "detached" });
  await expect.poll(offered).toEqual(["1. Field", "2. Yard"]);
  await panel.getByText(`of ${kLongType} only`).waitFor();
  const overhang = async () => {
    const body = (await console.panel("Failsafes")).locator(".failsafes");
    return body.evaluate((one) => one.scrollWidth - one.clientWidth, undefined, { timeout: 2000 }).catch(() => -1);
  };
  for (const width of [1280, 768]) {
    await console.page.setViewportSize({ width, height: 900 });
    await expect.poll(overhang, { timeout: 60_000 }).toBe(0);
  }
});

const kSteered = `MISSION NAME "steered"
OVERLAY demo_c.odl
FAILSAFE PERCEPTS-STALE AFTER 1 STOP
FAILSAFE OPERATOR-ABSENT AFTER 2 RETURN
UNIT <a> ROBOT
COMMAND LIST:
  0. UNIT a START 60 100
  1. UNIT a MOVETO 90 100
  2. UNIT a TELEOPERATE 150 100
`;

test("a robot that nobody steers goes home, and its row says why it does or doesn't count", async () => {
  const { console } = await begin({
    mission: "demo_c",
    prepare: (folder) => {
      folder.write("demo_c.mdl", kSteered);
      folder.write("demo_c.odl", kOverlay);
    },
    options: ["--speed", "4"],
  });
  await console.reaches("Ready");
  await console.select("Robot 1");
  const panel = await console.panel("Failsafes");
  const stale = panel.getByTestId("failsafe-1");
  const absent = panel.getByTestId("failsafe-2");
  await stale.getByText("looked at in real time only").waitFor();
  await absent.getByText("looked at under teleoperation only").waitFor();

  const whatIf = panel.getByRole("region", { name: "What if?" });
  await whatIf.getByText("Percepts stale").click();
  await whatIf.getByText("Operator absent").click();
  await whatIf.getByRole("button", { name: "Try it" }).click();
  await whatIf.getByRole("status").getByText("OPERATOR-ABSENT AFTER 2 RETURN acts").waitFor();

  await console.main.click();
  const told = /Robot 1: .FAILSAFE OPERATOR-ABSENT AFTER 2 RETURN. acts/;
  await console.page.getByText(told).first().waitFor();
  await console.panel("Failsafes"); // it made place for Steer
  await absent.getByText("Active", { exact: true }).waitFor();
});
