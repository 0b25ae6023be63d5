// Robots on other machines: where they are, how well they keep up, and what becomes of it when a machine can't be heard.
import { expect, test } from "vitest";
import { Agent } from "./agent.ts";
import { begin } from "./begin.ts";

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
