// Probes and breakpoints stay with what they were set on: over reloads, in every window, and when it is renamed.
import { expect, onTestFinished, test } from "vitest";
import { Mlab } from "../mlab.ts";
import { begin, type DesignerPage, look } from "./designer.ts";

const kTurns = `assemblage Turns() {
  sequence {
    start Waiting: Stand();
      when Wait(delay = 1 s) and not IsHalted() goto Moving;
    Moving: Noise(persistence = 2 s);
      when Wait(delay = 1 s) goto Waiting;
  }
}
`;

const opened = (text: string) =>
  begin({ file: "one.cdl", prepare: (project) => project.write("one.cdl", text), width: 1600, height: 900 });

const transition = ({ page }: DesignerPage, from: string) =>
  page.getByRole("button", { name: new RegExp(`^Transition 1 of ${from}`) });

async function breakAt(designer: DesignerPage, from: string, item: RegExp): Promise<void> {
  await transition(designer, from).click({ button: "right" });
  await designer.page.getByRole("menuitem", { name: item }).click();
}

test("a breakpoint on a transition goes with its states, is lost with them, and comes back", async () => {
  const { designer } = await opened(kTurns);
  await designer.on("Turns");
  await designer.run();
  await breakAt(designer, "Waiting", /^Break Waiting → Moving/);
  await designer.simulator.getByRole("alert").getByRole("button", { name: "Show" }).waitFor();
  await designer.page.reload();
  await designer.on("Turns");
  const entry = designer.breakpoints.getByRole("button", { name: "Waiting → Moving", exact: true });
  await entry.waitFor();
  // Renamed in the drawing: what runs next halts at it.
  await designer.select(designer.node("Waiting"));
  await designer.page.keyboard.press("F2");
  const dialog = designer.page.getByRole("dialog");
  await dialog.getByRole("textbox").fill("Idling");
  await dialog.getByRole("textbox").press("Enter");
  await designer.node("Idling").waitFor();
  // The run stands at the breakpoint: it begins anew with the new text.
  await designer.page.locator("[data-tour=run]").click();
  await designer.breakpoints.getByRole("button", { name: "Idling → Moving", exact: true }).waitFor();
  await designer.simulator
    .getByRole("alert")
    .getByText(/goes from Idling to Moving/)
    .waitFor();
  await transition(designer, "Idling").click();
  await designer.page.keyboard.press("Delete");
  await designer.breakpoints.getByText("Lost: not in the drawing").waitFor();
  await designer.page.keyboard.press("Control+z");
  await designer.breakpoints.getByRole("button", { name: "Idling → Moving", exact: true }).waitFor();
});

test("a run pauses when a condition within a trigger becomes true", async () => {
  const { designer } = await opened(kTurns);
  await designer.on("Turns");
  await designer.run();
  await breakAt(designer, "Waiting", /^Break when Wait\(delay = 1 s\)$/);
  await designer.simulator.getByText("Paused", { exact: true }).waitFor();
  await designer.simulator
    .getByRole("alert")
    .getByText(/Waiting.*Wait is true/)
    .waitFor();
});

test("a run pauses when a sentence becomes true, and what is not understood is told at its field", async () => {
  const { designer } = await opened(kTurns);
  const { page } = designer;
  await designer.on("Turns");
  await designer.run();
  const field = designer.breakpoints.getByRole("combobox", { name: "Pause when" });
  await field.fill("robot three in contact");
  await field.press("Enter");
  await designer.breakpoints
    .getByRole("alert")
    .filter({ hasText: /a robot.s number, but saw .three/ })
    .waitFor();
  await field.fill("any robot in");
  await page.getByRole("option", { name: /^any robot in contact/ }).waitFor();
  await field.fill("any robot in state Moving");
  expect(await designer.breakpoints.getByRole("alert").count()).toBe(0);
  await field.press("Enter");
  await designer.simulator
    .getByRole("alert")
    .getByText(/came into state Moving/)
    .waitFor();
  await page.reload();
  await designer.on("Turns");
  await designer.breakpoints.getByText("any robot in state Moving", { exact: true }).waitFor();
  await designer.breakpoints.getByRole("button", { name: "Remove the breakpoint any robot in state Moving" }).click();
  await designer.breakpoints.getByText(/^None\./).waitFor();
});

test("probes are there after a reload and in every window", async () => {
  const { designer, mlab } = await opened(kTurns);
  await designer.on("Turns");
  await designer.run();
  await designer.node("Moving").dblclick();
  await designer.on("Turns.Moving");
  await designer.select(designer.named("Noise"));
  await designer.details.getByRole("button", { name: "Pin a probe" }).click();
  await designer.probes.locator(".live-arrow").waitFor();
  await designer.page.reload();
  await designer.probes.locator(".live-arrow").waitFor();
  const other = await look(mlab.url, { width: 1600, height: 900 });
  await other.on("Turns");
  await other.page
    .getByRole("button", { name: /^Simulator/ })
    .first()
    .click();
  await other.probes.getByRole("button", { name: /^Take away the probe/ }).click();
  await designer.probes.waitFor({ state: "detached" });
});

test("breakpoints and probes are set before anything runs, and hold when it does", async () => {
  const { designer } = await opened(kTurns);
  const { page } = designer;
  await designer.on("Turns");
  await breakAt(designer, "Waiting", /^Break Waiting → Moving/);
  await page.getByRole("button", { name: /^Transition 1 of Waiting.*with a breakpoint$/ }).waitFor();
  expect(await page.locator(".break-dot").count()).toBe(1);
  await transition(designer, "Waiting").click({ button: "right" });
  await page.getByRole("menuitem", { name: /^Remove the breakpoint Waiting → Moving/ }).waitFor();
  await page.keyboard.press("Escape");
  await designer.node("Moving").dblclick();
  await designer.on("Turns.Moving");
  await designer.select(designer.named("Noise"));
  await designer.details.getByRole("button", { name: "Pin a probe" }).click();
  await designer.details.getByRole("button", { name: "Take the probe away" }).waitFor();
  await designer.probes.getByText("–").waitFor();
  await page.locator("[data-tour=run]").click();
  await designer.simulator
    .getByRole("alert")
    .getByText(/goes from Waiting to Moving/)
    .waitFor();
  await designer.button("Go on").first().click();
  await designer.probes.locator(".live-arrow").waitFor();
  await designer.breakpoints.getByRole("button", { name: /^Remove the breakpoint/ }).click();
  await page.keyboard.press("Escape");
  await designer.toDeclaration("Turns");
  await transition(designer, "Waiting").waitFor();
  expect(await page.locator(".break-dot").count()).toBe(0);
});

test("a breakpoint outlives its server, and holds in the next", async () => {
  const { designer, mlab, project } = await opened(kTurns);
  await designer.on("Turns");
  await breakAt(designer, "Waiting", /^Break Waiting → Moving/);
  await designer.page.locator(".break-dot").waitFor();
  await designer.page.goto("about:blank");
  const state = await mlab.kill();
  const next = await Mlab.edit([project.path("one.cdl"), "--project", project.folder], state);
  onTestFinished(async () => {
    await next.stop();
  });
  const after = await look(next.url, { width: 1600, height: 900 });
  await after.on("Turns");
  await after.page.locator(".break-dot").waitFor();
  await after.page.locator("[data-tour=run]").click();
  await after.simulator
    .getByRole("alert")
    .getByText(/goes from Waiting to Moving/)
    .waitFor();
});

test("how many robots run is taken over by a run of its own, which is offered", async () => {
  const { designer } = await opened(kTurns);
  const { page } = designer;
  await designer.on("Turns");
  await designer.run();
  await designer.simulator.getByText("3 robots").waitFor();
  expect(await designer.button("Run the change").count()).toBe(0);
  await designer.button("What runs").click();
  const count = page.getByRole("textbox", { name: "Robots" });
  await count.fill("7");
  await count.press("Enter");
  await designer.button("Run the change").waitFor(); // the number has come about
  await count.press("Escape");
  await designer.button("Run the change").click();
  await designer.simulator.getByText("7 robots").waitFor();
  await designer.button("Run the change").waitFor({ state: "detached" });
});

test("a breakpoint on what was tried alone holds inside of a robot, too", async () => {
  const inside = "assemblage Both() {\n  cooperate {\n    1: Turns();\n    0.1: Noise();\n  }\n}\n";
  const body = "class Body {\n  actuator base: DriveAndSpin() binds movement;\n}\n";
  const robot = `${body}robot Rover is Body {\n  movement = Both();\n}\n`;
  const { designer } = await opened(`${kTurns}${inside}${robot}`);
  const { page, simulator } = designer;
  const choose = async (name: string) => {
    await designer.button("What runs").click();
    await page.locator(".run-setup .choice").first().click();
    await page.getByRole("option", { name: new RegExp(`^${name}`) }).click();
    await page.keyboard.press("Escape");
  };
  await designer.goTo("Turns");
  await choose("Turns");
  await designer.run();
  await breakAt(designer, "Moving", /^Break Moving → Waiting/);
  const notice = simulator.getByRole("alert");
  await notice.getByText(/movement goes from Moving to Waiting/i).waitFor();
  await choose("Rover");
  await page.locator("[data-tour=run]").click();
  await notice.getByText(/Turns goes from Moving to Waiting/).waitFor();
  expect(await page.locator(".break-dot").count()).toBe(1);
});
