// A robot that a failsafe holds: its facts say so, and an order takes over.
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
