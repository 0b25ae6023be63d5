// The tour of docs/operator.md, step by step. MLAB_TOUR=FOLDER also writes its pictures there (`npm run tour`).
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Project } from "./begin.ts";
import { Console } from "./console.ts";
import { Mlab } from "./mlab.ts";
import { openPage } from "./open_page.ts";
import { picture, untilThereIsMore } from "./picture.ts";

let pages: Page[] = [];
let servers: Mlab[] = [];
let projects: Project[] = [];
let tour: Console;

/** A console beside a new mlab: with a mission that comes with mlab, or without any. */
async function open(mission: string, prepare?: (project: Project) => void): Promise<Console> {
  const project = new Project(mission);
  prepare?.(project);
  const file = mission === "" ? [] : [project.path(`${mission}.mdl`)];
  const mlab = await Mlab.start(...file, "--project", project.folder);
  projects.push(project);
  servers.push(mlab);
  return look(mlab);
}

async function look(mlab: Mlab): Promise<Console> {
  const page = await openPage();
  pages.push(page);
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  const console = new Console(page);
  await page.goto(mlab.url);
  await page.getByText("Operator: ").waitFor();
  return console;
}

async function closeAll(): Promise<void> {
  for (const page of pages) await page.context().close();
  for (const mlab of servers) await mlab.stop();
  for (const project of projects) project.remove();
  [pages, servers, projects] = [[], [], []];
}

beforeAll(async () => {
  tour = await open("demo_c");
});
afterAll(closeAll);

const proceed = { name: /^PROCEED/ };

test("without a mission the console offers what there is to open", async () => {
  const empty = await open("");
  await empty.page.getByRole("heading", { name: "Which mission?" }).waitFor();
  await empty.page.getByRole("region", { name: "Examples" }).getByText("demo_c").first().waitFor();
  await picture(empty.page, "start");
});

test("a mission that is opened shows its map, its steps and one button that starts it", async () => {
  await tour.reaches("Ready");
  await tour.steps.getByText("0 of 12 done").waitFor();
  await tour.main.getByText("Execute").waitFor();
  await tour.camera();
  await picture(tour.page, "ready");
});

test("a unit that has arrived asks whether to proceed", async () => {
  await tour.main.click();
  for (let asked = 0; asked < 2; ++asked) {
    const question = tour.questions.locator("[data-question]").first();
    await question.waitFor({ timeout: 120_000 });
    expect(await question.textContent()).toContain("scouts");
    if (asked === 1) await picture(tour.page, "question");
    if (asked === 1) await tour.setSpeed("×2");
    const id = await question.getAttribute("data-question");
    await question.getByRole("button", proceed).click();
    await tour.questions.locator(`[data-question="${id}"]`).waitFor({ state: "detached" });
  }
});

test("on the way the steps, the trails and the selected robot show how it goes", async () => {
  const { page } = tour;
  const current = tour.steps.locator("[aria-current=step]");
  await current.filter({ hasText: "PP-Delta1" }).waitFor({ timeout: 90_000 });
  await untilThereIsMore(page, 4000);
  await page.keyboard.press("Escape");
  await tour.select("Robot 2");
  await tour.panel("Mission");
  const selection = await tour.panel("Selection");
  await selection.getByText("To the goal").waitFor();
  await picture(page, "mission");
  await page.keyboard.press("x");
  await tour.reaches("Paused");
});

test("why a robot moves as it does is told by its schemas", async () => {
  const { page } = tour;
  const selection = await tour.panel("Selection");
  await selection.getByRole("tab", { name: "Why?" }).click();
  await selection.getByRole("region", { name: /^Sum / }).first().waitFor();
  await page.keyboard.press(".");
  await tour.camera();
  await picture(page, "why");
  await selection.getByRole("tab", { name: "Parameters" }).click();
  await selection.getByRole("slider").first().waitFor();
  await picture(page, "parameters");
  await selection.getByRole("tab", { name: "Overview" }).click();
  await page.keyboard.press("f");
});

test("the map is drawn with military symbols, in the dark, with what is wanted on it", async () => {
  const { page } = tour;
  const view = await tour.panel("View");
  await view.getByText("Dark", { exact: true }).click();
  await view.getByText("Military", { exact: true }).click();
  await view.getByText("All", { exact: true }).click();
  await view.getByText("Stay", { exact: true }).click();
  await tour.camera();
  await picture(page, "view");
  for (let edits = 0; edits < 3; ++edits) await page.keyboard.press("Control+z");
  await view.getByText("Light", { exact: true }).click();
  await tour.panel("Selection");
});

test("a command is typed, with who is meant by it", async () => {
  const { page } = tour;
  await page.keyboard.press("/");
  await page.keyboard.type("UNIT scouts-1 MOVETO ");
  await page
    .getByRole("listbox", { name: "Completions" })
    .getByRole("option", { name: /OBJ-Tango/ })
    .waitFor();
  await page.keyboard.type("420 300");
  await page.locator(".command-verdict").getByText("Enter sends this to").waitFor();
  await picture(page, "typed");
  await tour.commandLine.fill("");
  await page.keyboard.press("Escape");
});

test("a command is given by mouse, as the text that it means", async () => {
  const { page } = tour;
  await tour.panel("Robots");
  await tour.select("scouts");
  await tour.panel("Mission");
  await page.keyboard.press("o");
  await page.getByText(/For scouts: click the goal/).waitFor();
  await tour.dragMap([640, 300], [740, 300]);
  const order = page.getByRole("dialog", { name: "Command" });
  await order.getByText(/^UNIT scouts MOVETO 640 300/).waitFor();
  await order.getByLabel("Formation").selectOption("Wedge");
  await order.getByText(/FORMATION Wedge/).waitFor();
  await picture(page, "order");
  await page.keyboard.press("Escape");
  await order.waitFor({ state: "detached" });
  await page.keyboard.press("s");
});

test("a mistake in the text is underlined while it is typed", async () => {
  const { page } = tour;
  const panel = await tour.panel("Text");
  const text = panel.getByRole("textbox", { name: /^Text of / });
  await text.getByText("OBJ-Tango").first().click();
  await page.keyboard.press("Control+End");
  await page.keyboard.insertText("\n 12. UNIT scuots STOP\n");
  await panel
    .getByRole("list", { name: "Problems" })
    .getByText(/scuots/)
    .first()
    .waitFor();
  await picture(page, "text");
  await text.press("Control+z");
  await panel.getByRole("list", { name: "Problems" }).waitFor({ state: "detached" });
});

test("the world is edited while the mission runs, and undone by name", async () => {
  const { page } = tour;
  await tour.panel("Log"); // the text takes the keys no more
  await page.keyboard.press("8");
  const world = await tour.panel("World");
  await world.getByRole("button", { name: "Add obstacle" }).click();
  await tour.dragMap([690, 330], [712, 330]);
  await tour.button(/^Undo add obstacle/).waitFor();
  await world.getByRole("region", { name: "Selected thing" }).waitFor();
  await picture(page, "world");
  await tour.button(/^Undo add obstacle/).click();
  await tour.button("Put the tool away").click();
});

test("a robot or a unit is steered by hand", async () => {
  const { page } = tour;
  await tour.panel("Robots");
  await tour.select("scouts-1");
  await tour.panel("Mission");
  const steer = await tour.panel("Teleoperation");
  await steer.getByRole("button", { name: "Steer scouts-1" }).click();
  const card = steer.getByRole("region", { name: "Teleoperation of scouts-1" });
  await card.waitFor();
  if (await tour.state.filter({ hasText: "Paused" }).isVisible()) await tour.main.click();
  await tour.reaches("Running");
  const box = await card.getByRole("application", { name: "Stick of scouts-1" }).boundingBox();
  if (!box) throw new Error("the stick is not shown");
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.75 * box.width, box.y + 0.2 * box.height, { steps: 5 });
  await card.getByText(/by pointer/).waitFor();
  await picture(page, "steer", { pointerStays: true });
  await page.mouse.up();
  await card.getByText("let go: stands").waitFor();
  await card.getByRole("button", { name: "End teleoperation" }).click();
  await card.waitFor({ state: "detached" });
});

test("numbers are plotted over time", async () => {
  await tour.panel("Robots");
  await tour.select("scouts-2");
  await tour.panel("Mission");
  const plots = await tour.panel("Plots");
  await plots.getByRole("button", { name: "Distance to goal" }).click();
  const strip = plots.getByRole("region", { name: /^Plot of Distance to goal/i });
  await strip.locator("canvas").waitFor();
  const begin = await tour.runTime.textContent();
  await untilThereIsMore(tour.page, 12_000);
  await expect.poll(() => tour.runTime.textContent()).not.toBe(begin);
  await picture(tour.page, "plots");
});

test("the log tells what happened, and where", async () => {
  const log = await tour.panel("Log");
  await log.locator(".log-row").first().waitFor();
  await log
    .getByRole("button", { name: /: show on the map$/ })
    .first()
    .waitFor();
  await picture(tour.page, "log");
});

test("of several people one is the operator, and hands over", async () => {
  const server = servers[0];
  if (!server) throw new Error("the tour has no mlab");
  const other = await look(server);
  await other.watching.waitFor();
  await other.page
    .getByRole("button", { name: /Ask for control/ })
    .first()
    .click();
  await tour.page
    .getByRole("button", { name: /^Operator: you|asks for control/ })
    .first()
    .waitFor();
  await other.panel("Robots");
  await picture(other.page, "watching");
});

test("the emergency stop is one button and one key, from anywhere", async () => {
  await tour.page.keyboard.press("Control+.");
  await tour.reaches("Emergency stop");
  await picture(tour.page, "stop");
  await tour.button("Release the stop").first().click();
  await tour.reaches("Paused");
});

test("every command is found by its name", async () => {
  await tour.page.keyboard.press("Escape");
  await tour.page.keyboard.press("Control+k");
  await tour.page.getByRole("dialog", { name: "Search everything" }).waitFor();
  await picture(tour.page, "commands");
  await tour.page.keyboard.press("Escape");
});

test("an overlay is drawn on an empty map", async () => {
  const drawing = await open("");
  const { page } = drawing;
  await drawing.button("New mission").click();
  const dialog = page.getByRole("dialog", { name: "New mission" });
  await dialog.getByLabel("Name").fill("first");
  await dialog.getByRole("button", { name: "Create" }).click();
  await dialog.waitFor({ state: "detached" });
  const draw = await drawing.panel("Draw");
  for (const [kind, from, to] of [
    ["Assembly area", [150, 250], [210, 250]],
    ["Objective", [800, 600], [870, 600]],
  ] as const) {
    await draw.getByRole("button", { name: kind }).click();
    await drawing.dragMap([...from], [...to]);
    await draw.getByRole("region", { name: new RegExp(`^${kind}`) }).waitFor();
  }
  await draw.getByRole("button", { name: "Axis of advance" }).click();
  await drawing.clickMap(300, 300);
  await drawing.clickMap(500, 500);
  await drawing.clickMap(700, 560);
  await draw.getByRole("status").waitFor();
  await drawing.panel("Text");
  await drawing.camera();
  await picture(page, "draw");
});

const kGuarded = `MISSION NAME "Guarded"
OVERLAY demo_c.odl
FAILSAFE OUTSIDE Field REVERSE INSIDE
FAILSAFE LINK-LOST AFTER 5 RETURN
FAILSAFE IN-CONTACT AFTER 2 HOLD
UNIT <scouts> ROBOT ROBOT
COMMAND LIST:
  0. UNIT scouts START 120 100 0 -40
  1. UNIT scouts MOVETO 300 80 FORMATION Line
`;
const kField = `MISSION-AREA 320 200
CONTROL MEASURES:
BOUNDARY Field 20 20 200 20 200 180 20 180 20 20
`;

test("failsafes show how they stand, and what they would do", async () => {
  const guarded = await open("demo_c", (project) => {
    project.write("demo_c.mdl", kGuarded);
    project.write("demo_c.odl", kField);
  });
  const { page } = guarded;
  await guarded.main.click();
  const failsafes = await guarded.panel("Failsafes");
  await guarded.select("Robot 1");
  const fence = failsafes.getByTestId("failsafe-1");
  await fence.getByText("Active", { exact: true }).waitFor();
  await failsafes.getByRole("button", { name: "Try it" }).click();
  const answer = failsafes.getByRole("status");
  await answer.getByText("OUTSIDE Field REVERSE INSIDE acts.").waitFor();
  await fence.scrollIntoViewIfNeeded();
  await picture(page, "failsafes");
  await answer.getByText(/it stands, .* 3\.\d m before the line\.$/).waitFor();
});

test("what if: another future on the same map, and how far it is from the run", async () => {
  const asking = await open("demo_c");
  const { page } = asking;
  await asking.main.click();
  await asking.reaches("Running");
  await asking.setSpeed("Max");
  await asking.questions.getByRole("button", proceed).first().waitFor({ timeout: 60_000 });
  const line = page.getByRole("region", { name: "Time line" });
  const goTo = async (time: string) => {
    await line.getByRole("textbox", { name: "Time that is shown" }).fill(time);
    await page.keyboard.press("Enter");
  };
  await goTo("10");
  await line.getByRole("button", { name: "What if…" }).click();
  const asked = page.getByRole("region", { name: "What if", exact: true });
  await asked.getByRole("radio", { name: "Order" }).click();
  await asked.getByRole("textbox", { name: "Order, as it is typed" }).fill("UNIT scouts-2 MOVETO PP-Charlie");
  await asked.getByRole("textbox", { name: "For how long" }).fill("1:00");
  await asked.getByRole("button", { name: "Compute" }).click();
  await asked.getByText(/They part at/).waitFor();
  await goTo("16");
  await expect.poll(() => asking.time()).toBeCloseTo(16, 1);
  await picture(page, "what_if");
});
