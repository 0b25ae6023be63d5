// Several consoles on one fleet, each with a run of its own: what one does and what becomes of it, the others show.
import { expect, test } from "vitest";
import { Agent } from "./agent.ts";
import { begin } from "./begin.ts";
import { expectWithin } from "./within.ts";

const onFleet = (fleet: string) => ({
  mission: "demo_c",
  options: ["--robots", "fleet", "--fleet", fleet, "--speed", "0.1"],
});

test("the emergency stop of one console is that of the other, and a console that is killed leaves the machines to it", async () => {
  const fleet = `browser-two-${process.pid}`;
  const north = await Agent.start(fleet, "north");
  const first = await begin(onFleet(fleet));
  const second = await begin(onFleet(fleet));
  for (const { console } of [first, second]) {
    await console.main.click();
    await console.reaches("Running");
  }
  const machines = await second.console.panel("Machines");
  const robots = machines.getByRole("listitem", { name: "Machine north", exact: true }).locator(".machine-robots");
  await robots.getByText("4 robots of other runs").waitFor();

  // Whoever pulls it, and whoever releases it.
  await first.console.stop.click();
  await second.console.page.getByText("EMERGENCY STOP: all robots stand and take no orders.").waitFor();
  await second.console.button("Release the stop").first().click();
  await north.says("the emergency stop was released by");
  for (const { console } of [first, second]) await console.reaches("Paused");
  await second.console.main.click();
  await second.console.reaches("Running");

  await first.mlab.kill();
  await expect.poll(() => robots.getByText("of other runs").count()).toBe(0);
  await second.console.passes(0.3);
  await first.console.page
    .getByText(/mlab does not answer|connection|ended/i)
    .first()
    .waitFor();
  // What its page complains of is that nobody answers it.
  first.console.troubles.length = 0;
});

test("on a telephone the panels of a fleet all have their place below the map, with their names", async () => {
  const fleet = `browser-rail-${process.pid}`;
  await Agent.start(fleet, "north");
  const { console } = await begin(onFleet(fleet));
  await console.reaches("Ready");
  const buttons = console.page.locator("nav.rail").getByRole("button");
  for (const width of [390, 360]) {
    await console.page.setViewportSize({ width, height: 844 });
    await expectWithin(console.button("Machines"));
    expect(await buttons.count()).toBe(9);
    for (const one of await buttons.all()) {
      await expectWithin(one);
      const name = one.locator("span").first();
      const beyond = await name.evaluate((word) => {
        const own = word.getBoundingClientRect();
        const around = word.closest("button")!.getBoundingClientRect();
        return Math.max(around.left - own.left, own.right - around.right);
      });
      expect(beyond).toBeLessThanOrEqual(0);
    }
  }
});
