// Orders to one unit, or to robots, while the others go on.
import { expect, test } from "vitest";
import { begin } from "./begin.ts";
import { expectWithin } from "./within.ts";

const kMission = `MISSION NAME "two units"
MISSION-AREA 2000 2000
SET SEED 1
UNIT <a> ROBOT ROBOT
UNIT <b> ROBOT ROBOT
COMMAND LIST:
  0. UNIT a START 100 100 0 40 AND UNIT b START 100 400 0 40
  1. UNIT a MOVETO 1900 100 AND UNIT b MOVETO 1900 400
  2. UNIT a MOVETO 1900 200
`;

test("an order names every unit and what becomes of it, and ends only what its robots do", async () => {
  const { console } = await begin({
    mission: "demo_c",
    prepare: (project) => project.write("demo_c.mdl", kMission),
    options: ["--speed", "1"],
  });
  const { page } = console;
  await console.button("Execute").click();
  await console.reaches("Running");
  await console.passes(1);
  await console.steps
    .getByText(/MOVETO 1900 400/)
    .first()
    .waitFor();

  // Typed, for one robot: the others are named.
  await console.commandLine.fill("ROBOT 2 MOVETO 100 1500");
  const others = page.locator(".command-verdict").getByRole("list", { name: "The others" });
  await others.getByText("goes on with MOVETO 1900 100 without robot 2, 1 left").waitFor();
  await others.getByText("goes on with MOVETO 1900 400").waitFor();
  await console.commandLine.press("Enter");
  await page.locator(".command-verdict").getByText("Sent to").waitFor();
  await console.commandLine.press("Escape");

  // Each one's row says what it follows.
  const robots = await console.panel("Robots");
  await console.rowOf(robots, "Robot 2").getByText("MOVETO 100 1500").waitFor();
  await console.rowOf(robots, "Robot 1").getByText("MOVETO 1900 100").waitFor();
  await console.rowOf(robots, "a").getByText("MOVETO 1900 100, 1 robot left").waitFor();
  await console.rowOf(robots, "b").getByText("MOVETO 1900 400").waitFor();

  // By mouse, for the robots that are selected: those of two units.
  await console.rowOf(robots, "Robot 1").click();
  await console.rowOf(robots, "Robot 3").click({ modifiers: ["Control"] });
  await console.panel("Mission");
  await page.keyboard.press("o");
  await page.getByText(/For robots 1, 3: click the goal/).waitFor();
  await console.dragMap([600, 900], [600, 900]);
  const order = page.getByRole("dialog", { name: "Command" });
  await order.getByText(/^ROBOTS 1 3 MOVETO/).waitFor();
  await order.getByText("ends MOVETO 1900 100").waitFor();
  await order.getByText("goes on with MOVETO 1900 400 without robot 3, 1 left").waitFor();
  await order.getByText("goes on with MOVETO 100 1500").waitFor();
  await order.getByRole("button", { name: "Send" }).click();
  await order.waitFor({ state: "detached" });
  await console.panel("Robots");
  await console
    .rowOf(robots, "Robot 3")
    .getByText(/robots 1, 3: MOVETO/)
    .waitFor();
  await console.rowOf(robots, "b").getByText("MOVETO 1900 400, 1 robot left").waitFor();

  // Both orders and the step run side by side; nothing of the step is lost but unit a's command.
  await console.panel("Mission");
  const rows = console.steps.getByRole("listitem");
  expect(await rows.filter({ hasText: "typed" }).filter({ hasText: "MOVETO" }).count()).toBe(2);
  await rows.filter({ hasText: "1900 400" }).first().waitFor();
});

test("the card of an order says which part of it is odd, and its buttons lie within the smallest window", async () => {
  const units = ["b", "c", "d", "e", "f", "g"];
  const { console } = await begin({
    mission: "demo_c",
    prepare: (project) =>
      project.write(
        "demo_c.mdl",
        `MISSION NAME "many units"\nMISSION-AREA 1000 1000\nSET SEED 1\nOBSTACLE 600 600 40\n${["a", ...units]
          .map((name) => `UNIT <${name}> ROBOT ROBOT\n`)
          .join("")}COMMAND LIST:\n  0. ${["a", ...units]
          .map((name, i) => `UNIT ${name} START 100 ${100 + 100 * i} 20 0`)
          .join(" AND ")}\n  1. ${["a", ...units]
          .map((name, i) => `UNIT ${name} MOVETO 900 ${100 + 100 * i}`)
          .join(" AND ")}\n`,
      ),
    options: ["--speed", "1"],
  });
  const { page } = console;
  await console.button("Execute").click();
  await console.reaches("Running");
  await console.passes(1);
  await console.select("a");
  await console.panel("Mission");
  await page.keyboard.press("o");
  await page.getByText(/For a: click the goal/).waitFor();
  await console.dragMap([600, 600], [600, 600]);
  const order = page.getByRole("dialog", { name: "Command" });
  await order.getByText(/in an obstacle of radius 40 m: no robot can stand there/).waitFor();
  expect(await order.locator("mark").textContent()).toMatch(/^600(\.0)? 600(\.0)?$/);
  await order.getByText("goes on with MOVETO 900 700").waitFor();
  for (const [width, height] of [
    [1280, 800],
    [1280, 600],
    [640, 400],
    [390, 844],
    [320, 568],
  ] as const) {
    await page.setViewportSize({ width, height });
    for (const name of ["Send", "Cancel", "Edit as text"]) {
      await expectWithin(order.getByRole("button", { name, exact: true }));
    }
  }
});
