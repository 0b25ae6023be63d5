import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("robots that stand in the way of a rock and get no nearer are told as stuck, and dismissed", async () => {
  const { console } = await begin({
    mission: "demo_c",
    // Robots that plan their ways go round it.
    prepare: (project) => {
      project.write("demo_c.mdl", project.read("demo_c.mdl").replace(/^UNIT/m, "SET NAVIGATION REACTIVE\nUNIT"));
    },
  });
  const { page } = console;
  await console.startRobots();
  await console.panel("World");
  await console.button("Add obstacle").click();
  // Where the first of them stands, and the unit's column wants to be.
  await console.dragMap([140, 170], [154, 170]);
  const alerts = page.getByRole("region", { name: "Alerts" });
  await alerts.getByText("Robot 1 was moved: an obstacle appeared where it stood").waitFor();
  expect(await alerts.locator(".toast").count()).toBe(1);
  await console.setSpeed("×10");
  await console.main.click();
  const stuck = alerts.locator(".toast").filter({ hasText: /Robot \d is stuck: no nearer to done/ });
  await stuck.first().waitFor({ timeout: 60_000 });
  await console.main.filter({ hasText: "Pause" }).click();
  await console.reaches("Paused");
  expect(await alerts.locator(".toast").count()).toBe(1);
  await alerts.getByRole("button", { name: / more$/ }).click();
  await console.panel("Robots");
  await page.getByRole("row").filter({ hasText: "Stuck" }).first().waitFor();

  // It leads to the place.
  for (let i = 0; i < 3; ++i) await console.button("Zoom in").click();
  const before = await console.camera();
  await stuck.first().getByRole("button", { name: "Show" }).click();
  await expect
    .poll(async () => {
      const now = await console.camera();
      return Math.hypot(now.x - before.x, now.y - before.y);
    })
    .toBeGreaterThan(20);

  const count = await alerts.locator(".toast").count();
  await alerts.getByRole("button", { name: "Dismiss", exact: true }).first().click();
  await expect.poll(() => alerts.locator(".toast").count()).toBe(count - 1);
  const all = alerts.getByRole("button", { name: /dismiss all/i });
  if (await all.isVisible()) await all.click();
  else await alerts.getByRole("button", { name: "Dismiss", exact: true }).click();
  await expect.poll(() => alerts.locator(".toast").count()).toBe(0);
});

test("a robot that touches something is told, with the place", async () => {
  const { console } = await begin({
    mission: "demo_c",
    // They do not give way to a rock, which lies before the first of them.
    prepare: (project) => {
      project.write("democ.odl", `${project.read("democ.odl")}\nOBSTACLE 180 170 12\nPP Beyond 260 170 5\n`);
      project.write(
        "demo_c.mdl",
        `MISSION NAME "Blind"
OVERLAY democ.odl
SET NAVIGATION REACTIVE
NEW-ROBOT blind "robot" green (navigation_avoid_obstacle_gain = 0)
UNIT <scouts> (<scouts-1> blind blind) (<scouts-2> blind blind)
COMMAND LIST:
  0. UNIT scouts START AA-AA1 0 20
  1. UNIT scouts MOVETO PP-Beyond
`,
      );
    },
  });
  const { page } = console;
  await console.reaches("Ready");
  await console.main.click();
  await page
    .getByRole("region", { name: "Alerts" })
    .getByText(/Robot \d+ touched something at \(\d+/)
    .first()
    .waitFor({ timeout: 30_000 });
  const log = await console.panel("Log");
  await log
    .getByText(/touched something at/)
    .first()
    .waitFor();
});

test("a robot whose program fails is told as lost, and is so in the list", async () => {
  const { console } = await begin({
    mission: "demo_c",
    prepare: (project) => {
      project.write(
        "broken.cnl",
        `node ahead is MoveAhead with nend
node far is ScaleVector with v = ahead; multiplier = 1e300; nend
node farther is ScaleVector with v = far; multiplier = 1e300; nend
node wheels is Drive with v = farther; base_velocity = 1; max_velocity = 1; nend
`,
      );
      project.write(
        "demo_c.mdl",
        `MISSION NAME "Broken"
OVERLAY democ.odl
NEW-ROBOT broken "broken.cnl"
UNIT <scouts> (<scouts-1> ROBOT broken) (<scouts-2> ROBOT ROBOT)
COMMAND LIST:
  0. UNIT scouts START AA-AA1 0 20
  1. UNIT scouts MOVETO ATK-AP1
`,
      );
    },
  });
  const { page } = console;
  await console.reaches("Ready");
  await console.main.click();
  const alert = page.getByRole("region", { name: "Alerts" }).locator(".toast").filter({ hasText: "Robot 2 stands" });
  const more = page.getByRole("region", { name: "Alerts" }).getByRole("button", { name: / more$/ });
  await more.or(alert.first()).first().waitFor();
  if (await more.isVisible()) await more.click();
  await alert.first().waitFor();
  expect(await alert.first().textContent()).toContain("no number, first at “farther”");
  const log = await console.panel("Log");
  await log.locator(".log-row").filter({ hasText: "Lost" }).filter({ hasText: "Robot 2" }).first().waitFor();
  await console.panel("Robots");
  await page.getByRole("row").filter({ hasText: "Robot 2" }).filter({ hasText: "Faulted" }).waitFor();
  expect(await page.getByRole("row").filter({ hasText: "Faulted" }).count()).toBe(1);
});
