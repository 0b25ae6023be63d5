import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("a robot on the map is selected by a click, a unit by a double click", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.startRobots();
  await console.panel("Robots");
  await expect.poll(async () => (await console.place("Robot 2")).x).toBeGreaterThan(0);
  const { x, y } = await console.place("Robot 2");
  await console.panel("Selection");
  const at = await console.onPage(x, y);
  await page.mouse.click(at.x, at.y);
  await page.getByRole("heading", { name: "Robot 2" }).waitFor();
  const again = await console.onPage(x, y);
  await page.mouse.dblclick(again.x, again.y);
  await page.getByRole("heading", { name: /^Unit scouts/ }).waitFor();
});

test("a parameter's slider changes the robot while it runs, and the change can be undone by its name", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.startRobots();
  await console.select("Robot 1");
  const selection = await console.panel("Selection");
  await selection.getByRole("tab", { name: "Parameters" }).click();
  const slider = selection.getByRole("slider").first();
  await slider.waitFor();
  const before = await slider.inputValue();
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  const undo = console.button(/^Undo (?!show|hide)/);
  await undo.waitFor();
  await expect.poll(() => slider.inputValue()).not.toBe(before);
  await page.keyboard.press("Escape");
  await undo.click();
  await console.button(/^Redo /).waitFor();
});

test("why a robot moves as it does is told in sums of its schemas", async () => {
  // So slowly that it still moves when everything has been looked at.
  const { console } = await begin({ mission: "demo_c", options: ["--speed", "1"] });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  await console.select("Robot 1");
  const selection = await console.panel("Selection");
  await selection.getByRole("tab", { name: "Why?" }).click();
  const sum = selection.getByRole("region", { name: /^Sum / }).first();
  await sum.waitFor();
  expect(await sum.getByRole("listitem").count()).toBeGreaterThan(1);
  await sum
    .getByText(/drives it|holds against|turns it aside/)
    .first()
    .waitFor();
  await selection.getByText("OCCUPY AA-AA1", { exact: false }).first().waitFor();
  await selection.getByRole("region", { name: "Waits for" }).getByRole("listitem").first().waitFor();
  await page.getByRole("tab", { name: "Ports" }).click();
  expect(await selection.getByRole("region").count()).toBeGreaterThan(3);
});

test("undoing a parameter gives it the value that it had", async () => {
  const { console } = await begin({ mission: "demo_c" });
  await console.startRobots();
  await console.select("Robot 1");
  const selection = await console.panel("Selection");
  await selection.getByRole("tab", { name: "Parameters" }).click();
  const field = selection.getByRole("textbox", { name: /^base velocity/ });
  await expect.poll(() => field.inputValue()).not.toBe("");
  const before = await field.inputValue();
  await field.fill("3.5");
  await field.press("Enter");
  await console.button(/^Undo .*base_velocity/).waitFor();
  await expect.poll(() => field.inputValue()).toBe("3.5");
  await console.button(/^Undo .*base_velocity/).click();
  await expect.poll(() => field.inputValue()).toBe(before);
  await console.button(/^Redo .*base_velocity/).waitFor();
});
