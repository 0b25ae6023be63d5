// Robots on other machines: where they are, how well they keep up, and what becomes of it when a machine can't be heard.
import { expect, test } from "vitest";
import { Agent } from "./agent.ts";
import { begin } from "./begin.ts";
import { picture } from "./picture.ts";
import { expectWithin } from "./within.ts";

test("a machine that is silent is named, and so is one that has not confirmed the emergency stop", async () => {
  const fleet = `browser-${process.pid}`;
  const agent = await Agent.start(fleet, "north");
  const { console } = await begin({
    mission: "demo_c",
    options: ["--robots", "fleet", "--fleet", fleet, "--real-time"],
  });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  await console.passes(2);
  await console.button(/^Real time/).click();
  await page.getByText("time passes as on the clock").waitFor();
  await page.keyboard.press("Escape");

  await console.select("Robot 1");
  const selection = await console.panel("Selection");
  await selection.getByText("north", { exact: true }).waitFor();

  agent.freeze();
  await page.getByText(/Nothing has been heard of machine north for \d+ s: its robots stand/).waitFor();
  await selection.getByText(/^north, silent for \d+ s/).waitFor();
  await selection.locator(".pill", { hasText: /^Silent \d+ s$/ }).waitFor();
  expect(await selection.locator(".pill.go").count()).toBe(0);
  await selection.getByRole("tab", { name: "Why?" }).click();
  await selection.getByText(/^Silent \d+ s: nothing is heard of machine north/).waitFor();
  await selection.getByRole("tab", { name: "Overview" }).click();
  await picture(page, "silent_machine", { of: "fleet" });
  // On a telephone, too, who it is can be read.
  await page.setViewportSize({ width: 390, height: 844 });
  await console.panel("Selection");
  await expectWithin(selection.getByRole("heading", { name: "Robot 1" }));
  await expectWithin(selection.locator(".pill", { hasText: /^Silent \d+ s$/ }));
  await expectWithin(page.getByText(/Nothing has been heard of machine north for/));
  await picture(page, "silent_machine_narrow", { of: "fleet" });
  await page.setViewportSize({ width: 1280, height: 800 });
  const robots = await console.panel("Robots");
  await robots
    .getByText(/^Silent \d+ s$/)
    .first()
    .waitFor();
  await console.stop.click();
  await page.getByText("EMERGENCY STOP: not confirmed by north.").waitFor();

  agent.thaw();
  await page.getByText("EMERGENCY STOP: all robots stand and take no orders.").waitFor();
  await agent.says("EMERGENCY STOP by");
  await expect.poll(() => page.getByText("Nothing has been heard of machine").count()).toBe(0);
  await console.button("Release the stop").first().click();
  await agent.says("the emergency stop was released by");
  await console.reaches("Paused");
  await console.main.click();
  await console.reaches("Running");
});

test("all machines of the fleet are in one panel, with the way to each; those that are silent say how old that is", async () => {
  const fleet = `browser-m-${process.pid}`;
  const north = await Agent.start(fleet, "north");
  await Agent.start(fleet, "south");
  const { console } = await begin({
    mission: "demo_c",
    options: ["--robots", "fleet", "--fleet", fleet, "--speed", "0.5"],
  });
  const { page } = console;
  const machines = await console.panel("Machines");
  const card = (name: string) => machines.getByRole("listitem", { name: `Machine ${name}`, exact: true });
  await card("south").getByText("There", { exact: true }).waitFor();
  await card("north")
    .getByText(/^\d+\.\d ms there and back/)
    .waitFor();
  await card("north").getByText("none", { exact: true }).waitFor();
  await console.main.click();
  await console.reaches("Running");
  const robots = card("north").getByRole("button", { name: /^Select robot/ });
  await expect.poll(() => robots.count()).toBe(2);
  await expect
    .poll(() =>
      card("south")
        .getByRole("button", { name: /^Select robot/ })
        .count(),
    )
    .toBe(2);
  await robots.first().click();
  await (await console.panel("Robots")).getByRole("row", { selected: true }).first().waitFor();
  await console.panel("Machines");
  await card("north").getByText("There", { exact: true }).waitFor();

  for (const [width, height] of [
    [1920, 1080],
    [768, 1024],
    [390, 844],
  ] as const) {
    await page.setViewportSize({ width, height });
    await console.panel("Machines");
    await expectWithin(card("north").getByRole("heading", { name: "north" }));
    const cut = await machines.evaluate(
      (panel) =>
        [...panel.querySelectorAll("dd, .machine-head")].filter((one) => one.scrollWidth > one.clientWidth + 1).length,
    );
    expect(cut).toBe(0);
    await picture(page, `machines_${width}`, { of: "fleet" });
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  await console.panel("Machines");

  // Nothing else is done while it is silent: on a slow machine the run would give its agent up meanwhile.
  north.freeze();
  const pill = card("north").locator(".pill", { hasText: /^(Silent \d+ s|Gone, heard \d+ s ago)$/ });
  await pill.waitFor();
  expect(await pill.getAttribute("class")).not.toMatch(/go|danger/);
  await page.getByRole("button", { name: /^Machines 1$/ }).waitFor();
  north.thaw();
  await card("north").getByText("There", { exact: true }).waitFor();
  // In lock-step no time passes meanwhile: the list of robots is as honest.
  const silence = (await console.panel("Robots")).getByText(/^Silent \d+ s$/).first();
  north.freeze();
  await silence.waitFor();
  expect(await silence.evaluate((one) => one.scrollWidth - one.clientWidth)).toBeLessThan(2);
  north.thaw();
  await console.panel("Machines");
  await card("north").getByText("There", { exact: true }).waitFor();
});

test("where nobody is in the fleet, the panel says what starts somebody; without a fleet there is no such panel", async () => {
  const fleet = `browser-e-${process.pid}`;
  const { console } = await begin({ mission: "demo_c", options: ["--robots", "fleet", "--fleet", fleet] });
  const machines = await console.panel("Machines");
  await machines.getByText("Nobody is there.").waitFor();
  await machines.getByText(`mlab agent --fleet ${fleet}`).waitFor();
  await picture(console.page, "machines_nobody", { of: "fleet" });
  const embedded = (await begin({ mission: "demo_c" })).console;
  await embedded.reaches("Ready");
  await embedded.button("Selection").waitFor();
  expect(await embedded.button("Machines").count()).toBe(0);
});
