import { expect, test } from "vitest";
import { begin } from "./begin.ts";

/** The robots run, the unit `scouts` is selected, and a click on the map is a goal. */
async function beginWithCommandTool() {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.startRobots();
  await console.select("scouts");
  await console.panel("Mission");
  await page.keyboard.press("o");
  return { console, page };
}

test("a typed command shows who is meant before it goes out, and becomes a step", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.startRobots();
  await page.keyboard.press("/");
  await page.keyboard.type("UNIT scouts-1 MOVETO ");
  // What could stand there is offered.
  const offered = page.getByRole("listbox", { name: "Completions" });
  await offered.getByRole("option", { name: /OBJ-Tango/ }).waitFor();
  await page.keyboard.type("150 150");
  const verdict = page.locator(".command-verdict");
  await verdict.getByText("Enter sends this to").waitFor();
  await verdict.getByText("scouts-1", { exact: true }).waitFor();
  await verdict
    .getByText(/2 robots|robots 1/)
    .first()
    .waitFor();
  await page.keyboard.press("Enter");
  const typed = console.steps.getByRole("listitem").filter({ hasText: "typed" });
  await typed.filter({ hasText: "MOVETO" }).waitFor();

  // The line is kept.
  await console.commandLine.press("Escape");
  await console.commandLine.press("ArrowUp");
  expect(await console.commandLine.inputValue()).toBe("UNIT scouts-1 MOVETO 150 150");
});

test("a mistyped command is marked with what is expected, and is not sent", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.startRobots();
  await console.commandLine.fill("UNIT scouts MOVETO OBJ-Tangoo");
  await page.getByText("Can't be sent yet").waitFor();
  await page.locator("mark").filter({ hasText: "OBJ-Tangoo" }).waitFor();
  await page
    .locator(".command-verdict")
    .getByText(/OBJ-Tango\b/)
    .first()
    .waitFor();
  await console.commandLine.press("Enter");
  expect(await console.steps.getByRole("listitem").filter({ hasText: "typed" }).count()).toBe(0);
});

test("a unit is sent to a place by mouse, with its formation, as the MDL that it means", async () => {
  const { console, page } = await beginWithCommandTool();
  await page.getByText(/For scouts: click the goal/).waitFor();
  // The heading of the formation by dragging from the goal.
  await console.dragMap([360, 330], [440, 330]);
  const order = page.getByRole("dialog", { name: "Command" });
  await order.getByText(/^UNIT scouts MOVETO 360 330/).waitFor();
  await order
    .getByText(/4 robots|robots 1/)
    .first()
    .waitFor();
  await order
    .getByLabel("Formation")
    .selectOption("Wedge")
    .catch(async () => {
      await order.getByRole("button", { name: /Formation/ }).click();
      await page.getByRole("option", { name: "Wedge" }).click();
    });
  await order.getByText(/FORMATION Wedge/i).waitFor();
  const text = (await order.locator("code").textContent()) ?? "";
  await order.getByRole("button", { name: "Send" }).click();
  await order.waitFor({ state: "detached" });
  const typed = console.steps.getByRole("listitem").filter({ hasText: "typed" });
  await typed.filter({ hasText: "MOVETO" }).filter({ hasText: "Wedge" }).waitFor();
  expect(text).toMatch(/^UNIT scouts MOVETO/);
  await console.panel("Log");
  await page
    .getByRole("log", { name: "Events" })
    .getByText(/MOVETO/)
    .first()
    .waitFor();
});

test("a unit is told by mouse to rally, which takes no formation", async () => {
  const { console, page } = await beginWithCommandTool();
  await page.getByText(/For scouts: click the goal/).waitFor();
  await console.clickMap(360, 330);
  const order = page.getByRole("dialog", { name: "Command" });
  await order.getByText("Rally", { exact: true }).click();
  await order.getByText(/^UNIT scouts RALLY 360 330/).waitFor();
  expect(await order.getByText("Formation").count()).toBe(0);
  await order.getByText("Speed [m/s]").waitFor();
  // The verdict has had its room before, so that Send does not move away under the pointer when it comes.
  const verdict = order.getByRole("status");
  await verdict.getByText(/RALLY 360 330/).waitFor();
  const shown = await verdict.boundingBox();
  const room = await verdict.evaluate((e) => Number.parseFloat(getComputedStyle(e).minHeight));
  expect(shown?.height).toBeLessThanOrEqual(Math.ceil(room));
  await order.getByRole("button", { name: "Send" }).click();
  await order.waitFor({ state: "detached" });
  const typed = console.steps.getByRole("listitem").filter({ hasText: "typed" });
  await typed.filter({ hasText: "RALLY" }).waitFor();
});

test("every command is found by its name", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox", { name: "Search everything" }).fill("emerg");
  await page.getByRole("option", { name: /Emergency stop/ }).waitFor();
  await page.keyboard.press("Enter");
  await console.reaches("Emergency stop");
});

test("the same box finds units, places, steps and files", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.startRobots();
  const find = async (query: string, option: RegExp) => {
    await page.keyboard.press("Control+k");
    const field = page.getByRole("combobox", { name: "Search everything" });
    await field.fill(query);
    await page.getByRole("option", { name: option }).first().waitFor();
    return field;
  };
  const unit = await find("scouts-1", /^scouts-1.*unit/);
  await unit.press("Enter");
  await expect.poll(() => page.getByRole("heading", { name: /scouts-1/ }).count()).toBeGreaterThan(0);
  await (await find("tango", /Tango.*place/)).press("Escape");
  await (await find("step 1", /^Step 1/)).press("Escape");
  await (await find("democ.odl", /democ\.odl.*open text/)).press("Escape");
});

test("a unit shares places that were clicked one after the other; the map and Why? say who has which", async () => {
  const { console, page } = await beginWithCommandTool();
  await console.clickMap(420, 300);
  const order = page.getByRole("dialog", { name: "Command" });
  await order.getByRole("radio", { name: "Visit" }).click();
  await order.getByText("1 place", { exact: true }).waitFor();
  await console.clickMap(300, 240);
  await console.clickMap(250, 420);
  await order.getByText("3 places", { exact: true }).waitFor();
  await order.getByRole("button", { name: "Take the last one back" }).click();
  await order.getByText(/^UNIT scouts VISIT \d+ \d+ \d+ \d+$/).waitFor();
  await order.getByRole("radio", { name: "Patrol" }).click();
  await order.getByText(/^UNIT scouts PATROL \d+ \d+ \d+ \d+$/).waitFor();
  await order.getByRole("radio", { name: "Visit" }).click();
  await order.getByRole("button", { name: "Send" }).click();
  await order.waitFor({ state: "detached" });
  const typed = console.steps.getByRole("listitem").filter({ hasText: "typed" });
  await typed.filter({ hasText: "VISIT" }).waitFor();
  await console.select("Robot 1");
  await console.panel("Selection");
  await page.getByRole("tab", { name: /Why/ }).click();
  await page
    .getByText(/\d of 2 parts (is|are) done, \d on offer/)
    .first()
    .waitFor();
  await page.keyboard.press("x");
  await console.reaches("Paused");
  const view = await console.panel("View");
  const drawn = await console.drawnOnTop();
  await view.getByText("Shared places and pieces").click();
  await expect.poll(() => console.drawnOnTop()).toBeLessThan(drawn - 150);
});
