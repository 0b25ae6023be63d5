// Breakpoints in words, as moments are found by.
import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("a breakpoint in words halts the run, and what is not understood or can't happen is told", async () => {
  const { console } = await begin({ mission: "demo_c", options: ["--speed", "20"] });
  const { page } = console;
  await console.reaches("Ready");
  const panel = await console.panel("Breakpoints");
  const field = panel.getByRole("combobox", { name: "Pause when" });
  const set = async (condition: string) => {
    await field.fill(condition);
    await field.press("Enter");
  };
  await field.fill("any robot in");
  await page.getByRole("option", { name: /^any robot in contact/ }).waitFor();
  await set("robot three in contact");
  await panel
    .getByRole("alert")
    .filter({ hasText: /a robot.s number, but saw .three/ })
    .waitFor();
  expect(await field.inputValue()).toBe("robot three in contact");
  const list = panel.getByRole("list", { name: "Breakpoints that are set" });
  await set("robot 1 distance-driven > 3");
  await list.getByText("robot 1 distance-driven > 3", { exact: true }).waitFor();
  expect(await panel.getByRole("alert").count()).toBe(0);
  await set("robot 9 in contact");
  await list.getByText("There is no robot 9").waitFor();
  await console.main.click();
  await console.reaches("Paused");
  await panel
    .getByRole("status")
    .filter({ hasText: /^Distance-driven of robot 1 was 3/i })
    .waitFor();
  await list.getByText("1×").waitFor();
  await (await console.panel("Log")).getByText(/^Distance-driven of robot 1 was 3/i).waitFor();
  await console.panel("Breakpoints"); // there is no room for both
  await panel.getByRole("button", { name: "Remove all" }).click();
  await list.waitFor({ state: "detached" });
  await console.main.click();
  await console.reaches("Running");
});
