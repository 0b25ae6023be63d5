// Names in the console's texts: where they are declared, where they are used, other names for them.
import { expect, test } from "vitest";
import { begin, look } from "./begin.ts";
import type { Console } from "./console.ts";
import { expectWithin } from "./within.ts";

const kMission = `OVERLAY "map.odl"
NEW-ROBOT scout "robots.cdl#Scout" (urge = 0.7)
UNIT <pair> scout scout
COMMAND LIST:
  0. UNIT pair START 100 100 0 40
  1. UNIT pair MOVETO PP-Far
`;
const kOther = `OVERLAY "map.odl"
UNIT <trio> ROBOT
COMMAND LIST:
  0. UNIT trio START 100 100
  1. UNIT trio MOVETO PP-Far
`;
const kMap = `MISSION-AREA 2000 1000
CONTROL MEASURES:
PP Far 1900 100
PP Near 200 100
`;
const kRobots = `robot Scout(urge: gain = 0.5, far: Point = place("Far")) is Scout {
  movement = cooperate {
    urge: Noise();
    1: MoveToGoal(DetectGoal(far));
  };
}
robot Idler is Scout {
  movement = Wander();
}
`;

async function project(size = { width: 1280, height: 900 }) {
  const begun = await begin({
    mission: "",
    size,
    options: ["--speed", "0.1"],
    prepare: (made) => {
      made.write("far.mdl", kMission);
      made.write("other.mdl", kOther);
      made.write("map.odl", kMap);
      made.write("robots.cdl", kRobots);
    },
  });
  const { page } = begun.console;
  await page.getByText("far.mdl").first().click();
  await begun.console.reaches("Ready");
  return begun;
}

/** Puts the cursor into a word of the text that is shown. */
async function into(console: Console, word: string, options: { modifiers?: ["Control"] } = {}) {
  const panel = await console.panel("Text");
  const line = panel.locator(".cm-line").filter({ hasText: word }).first();
  await line.waitFor();
  const position = await line.evaluate((element, wanted) => {
    const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const at = (node.textContent ?? "").indexOf(wanted);
      if (at < 0) continue;
      const range = document.createRange();
      range.setStart(node, at);
      range.setEnd(node, at + wanted.length);
      const word = range.getBoundingClientRect();
      const all = element.getBoundingClientRect();
      return { x: word.x + word.width / 2 - all.x, y: word.y + word.height / 2 - all.y };
    }
    return null;
  }, word);
  if (!position) throw new Error(`${word} is not on the page`);
  await line.click({ position, ...options });
  return panel;
}

function textOf(console: Console, name: string) {
  return console.page.getByRole("textbox", { name: `Text of ${name}` });
}

test("F12 and a click with Ctrl go to the overlay, to a configuration, and into the library", async () => {
  const { console } = await project();
  const { page } = console;
  await into(console, "PP-Far");
  await page.keyboard.press("F12");
  await textOf(console, "map.odl").waitFor();
  await expect.poll(() => page.evaluate(() => getSelection()?.toString())).toBe("Far");
  await page.getByRole("tab", { name: "far.mdl" }).click();
  const panel = await into(console, "urge", { modifiers: ["Control"] });
  await textOf(console, "robots.cdl, read only").waitFor();
  await panel.getByText("Not of this mission: read only").waitFor();
  await into(console, "Wander");
  await panel.getByRole("button", { name: "The name at the cursor" }).click();
  await page.getByRole("menuitem", { name: /^Go to the definition/ }).click();
  await page.getByRole("textbox", { name: /^Text of library:.*wander\.cdl, read only$/ }).waitFor();
  await panel.getByText("Of the library: read only").waitFor();
  await panel.getByRole("button", { name: "Close", exact: true }).click();
  await textOf(console, "far.mdl").waitFor();
  await into(console, "MOVETO");
  await page.keyboard.press("F12");
  await page.getByText("This is declared in no text that could be shown.").waitFor();
});

test("Shift F12 lists the uses in all files, and a click goes there", async () => {
  const { console } = await project();
  const { page } = console;
  await into(console, "PP-Far");
  await page.keyboard.press("Shift+F12");
  const uses = page.getByRole("region", { name: /^Uses of / });
  await uses.getByText(/4 places in 4 files/).waitFor();
  await uses.getByRole("button", { name: /far: Point/ }).click();
  await textOf(console, "robots.cdl, read only").waitFor();
  await uses.getByRole("button", { name: /1900 100/ }).click();
  await textOf(console, "map.odl").waitFor();
  await uses.getByRole("button", { name: "Hide the uses" }).click();
  await uses.waitFor({ state: "detached" });
});

test("F2 shows what changes in all files before it is done, and Undo takes it back as a whole", async () => {
  const { console, project: files } = await project();
  const { page } = console;
  await into(console, "PP-Far");
  await page.keyboard.press("F2");
  const dialog = page.getByRole("dialog", { name: /^Rename / });
  const field = dialog.getByRole("textbox", { name: "Name" });
  await field.fill("Near");
  await dialog.getByText(/far\.mdl, line 6/).waitFor();
  const button = dialog.getByRole("button", { name: "Rename", exact: true });
  expect(await button.isDisabled()).toBe(true);
  await field.fill("");
  expect(await button.isDisabled()).toBe(true);
  await field.fill("two words");
  await dialog.getByText(/is no name in this language/).waitFor();
  await field.fill("Gate");
  await dialog.getByText("4 places in 4 files").waitFor();
  await dialog.getByRole("region", { name: "robots.cdl" }).getByText("far: Point").waitFor();
  await page.keyboard.press("Enter");
  await page.getByText(/^Renamed .* to Gate/).waitFor();
  await dialog.waitFor({ state: "detached" });
  await textOf(console, "far.mdl").getByText("PP-Gate").waitFor();
  expect(files.read("far.mdl")).toContain("MOVETO PP-Gate");
  expect(files.read("other.mdl")).toContain("MOVETO PP-Gate");
  expect(files.read("robots.cdl")).toContain('place("Gate")');
  await console.reaches("Ready");
  await console.button(/^Undo rename/).click();
  await textOf(console, "far.mdl").getByText("PP-Far").waitFor();
  await expect.poll(() => files.read("other.mdl")).toBe(kOther);
  expect(files.read("robots.cdl")).toBe(kRobots);
  expect(files.read("map.odl")).toBe(kMap);
});

test("what is in the way is shown", async () => {
  const { console } = await project();
  const { page } = console;
  await into(console, "PP-Far");
  await page.keyboard.press("F2");
  const place = page.getByRole("dialog", { name: "Rename Far" });
  await place.getByRole("textbox", { name: "Name" }).fill("Near");
  await place.getByRole("button", { name: "Show what is in the way" }).click();
  await place.waitFor({ state: "detached" });
  await expect.poll(() => page.evaluate(() => getSelection()?.toString())).toBe("Far");
});

test("who watches looks things up and can't rename", async () => {
  const { console, mlab } = await project();
  await console.button("Operator: you").waitFor();
  const other = await look(mlab, { width: 1280, height: 900 });
  await other.watching.waitFor();
  await into(other, "PP-Far");
  await other.page.keyboard.press("F2");
  await other.page.getByText("Only the operator can rename: take control first.").waitFor();
  await other.page.keyboard.press("F12");
  await textOf(other, "map.odl").waitFor();
});

test("everything is within reach on a telephone", async () => {
  const { console } = await project({ width: 390, height: 780 });
  const { page } = console;
  const panel = await into(console, "PP-Far");
  const menu = panel.getByRole("button", { name: "The name at the cursor" });
  await menu.click();
  await page.getByRole("menuitem", { name: /^Find uses/ }).click();
  const uses = page.getByRole("region", { name: /^Uses of / });
  await expectWithin(uses.getByRole("button", { name: "Hide the uses" }));
  await menu.click();
  await page.getByRole("menuitem", { name: /^Rename/ }).click();
  const dialog = page.getByRole("dialog", { name: /^Rename / });
  await dialog.getByRole("textbox", { name: "Name" }).fill("Gate");
  await dialog.getByText("4 places in 4 files").waitFor();
  await expectWithin(dialog.getByRole("button", { name: "Rename", exact: true }));
});
