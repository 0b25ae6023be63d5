// A robot whose machine is lost: another one takes its place, on the machine that is left, and the mission goes on.
import { expect, test } from "vitest";
import { Agent } from "./agent.ts";
import { begin } from "./begin.ts";

test("robots of a machine that is lost are replaced, and go on under their orders", async () => {
  const fleet = `replaced-${process.pid}`;
  const north = await Agent.start(fleet, "north");
  await Agent.start(fleet, "south");
  const { console } = await begin({
    mission: "demo_c",
    options: ["--robots", "fleet", "--fleet", fleet, "--speed", "5"],
  });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  await console.passes(2);
  await north.kill();
  const log = await console.panel("Log");
  const stands = log.getByText(/^Robot \d stands: .*the agent on .north/).first();
  await stands.waitFor();
  const lost = /^Robot \d/.exec((await stands.textContent()) ?? "")?.[0] ?? "";

  await console.select(lost);
  const selection = await console.panel("Selection");
  await selection.getByText("Faulted", { exact: true }).waitFor();
  await selection.getByText(/the agent on .north. was silent/).waitFor();
  await selection.getByRole("button", { name: "Read messages" }).click();
  await selection.getByText(/^Messages can't be read: the agent on .north. /).waitFor();
  const replace = selection.getByRole("button", { name: /^Replace/ });
  await replace.click();
  await selection.getByText(/^(Running|Done)$/).waitFor(); // done where it had arrived before its machine was lost
  await selection.getByText("south", { exact: true }).waitFor();
  await expect.poll(() => replace.count()).toBe(0);
  expect(await selection.getByText(/^Messages can't be read/).count()).toBe(0);
  await selection.getByText(/OCCUPY AA-AA1/).waitFor();
  await selection.getByRole("button", { name: "Read messages" }).click();
  await selection.getByText(/a run has begun to talk to this agent/).waitFor();
  await selection.getByText("It has written nothing to standard error.").waitFor();

  // The rest of them at once.
  await page.getByRole("application").first().focus();
  await page.keyboard.press("Control+a");
  await selection.getByText(/^\d faulted$/).waitFor();
  await replace.click();
  await expect.poll(() => selection.getByText(/^\d faulted$/).count()).toBe(0);
  const replaced = (await console.panel("Log")).getByText(
    /is replaced by another ROBOT, on south: its program begins anew/,
  );
  await expect.poll(() => replaced.count()).toBe(2);
});
