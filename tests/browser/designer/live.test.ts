// Running what is drawn: robots move beside the canvas, wires show values, breakpoints pause, parameters go back to the
// text.
import { expect, test } from "vitest";
import { begin, type DesignerPage } from "./designer.ts";
import { kWander, opened, run, time, turns } from "./running.ts";

const kTurns = turns(1);

/** The time, once it stands: the last cycle's may come a moment later. */
async function standsAt(designer: DesignerPage): Promise<number> {
  let before = -1;
  for (;;) {
    const now = await time(designer);
    if (now === before) return now;
    before = now;
    await designer.page.waitForTimeout(500);
  }
}

async function pause(designer: DesignerPage): Promise<void> {
  await designer.button("Pause").click();
  await designer.simulator.getByText("Paused", { exact: true }).waitFor();
}

test("what is drawn runs, and every wire shows its value", async () => {
  const { designer } = await opened(kWander);
  await designer.on("Wander");
  await run(designer);
  await designer.simulator.getByText("3 robots", { exact: true }).waitFor();
  const labels = designer.page.locator(".wire-label.live");
  await expect.poll(() => labels.count()).toBeGreaterThanOrEqual(4);
  // Movements are arrows.
  const arrow = designer.page.locator(".wire-label.live .live-arrow").first();
  await arrow.waitFor();
  const drawn = () => arrow.evaluate((one) => one.outerHTML);
  const before = await drawn();
  await expect.poll(drawn).not.toBe(before);
  await pause(designer);
  const still = await standsAt(designer);
  await designer.button("One cycle").click();
  await expect.poll(() => time(designer)).toBeCloseTo(still + 0.1, 5);
  await designer.button("Go on").click();
  await expect.poll(() => time(designer)).toBeGreaterThan(still + 0.5);
  await designer.button(/^Stop/).click();
  await designer.simulator.getByText("Ready", { exact: true }).waitFor();
});

test("the active state glows, and a breakpoint on a transition pauses, says which, and leads there", async () => {
  const { designer } = await opened(kTurns);
  await designer.on("Turns");
  await run(designer);
  await designer.page.locator(".state.active").first().waitFor();
  await designer.page.getByRole("button", { name: /^Transition 1 of Waiting/ }).click({ button: "right" });
  await designer.page.getByRole("menuitem", { name: "Break Waiting → Moving" }).click();
  await designer.breakpoints.getByRole("button", { name: "Waiting → Moving", exact: true }).waitFor();
  const notice = designer.simulator.getByRole("alert");
  await notice.getByRole("button", { name: "Show" }).waitFor();
  await designer.simulator.getByText("Paused", { exact: true }).waitFor();
  await notice.getByRole("button", { name: "Show" }).click();
  await expect
    .poll(() => designer.page.getByRole("button", { name: /^Transition 1 of Waiting/ }).getAttribute("aria-pressed"))
    .toBe("true");
  await designer.breakpoints.getByRole("switch").press("Space");
  await expect.poll(() => designer.breakpoints.getByRole("switch").isChecked()).toBe(false);
  await notice.getByRole("button", { name: "Go on" }).click();
  const paused = await time(designer);
  await expect.poll(() => time(designer)).toBeGreaterThan(paused + 3);
  await designer.breakpoints.getByRole("button", { name: "Remove the breakpoint Waiting → Moving" }).click();
  await designer.breakpoints.getByText("None.").waitFor();
});

test("a parameter of the running robots is changed, and written back to the text", async () => {
  const { designer, project } = await opened(kWander);
  await designer.on("Wander");
  await run(designer);
  await designer.select(designer.named("Noise"));
  // One field; what it changes is chosen beside it.
  const field = designer.details.getByRole("textbox", { name: /persistence/ });
  await designer.details.getByRole("radio", { name: "The text" }).click();
  await expect.poll(() => field.inputValue()).toBe("2 s");
  await designer.details.getByRole("radio", { name: "The robots, now" }).click();
  await expect.poll(() => field.inputValue()).toBe("2");
  expect(await field.count()).toBe(1);
  await field.fill("7");
  await field.press("Enter");
  await designer.details.getByRole("button", { name: /^Write persistence = 7 to the text/ }).click();
  await designer.named("Noise").getByText("7 s").waitFor();
  await designer.page.locator("body").press("Control+s");
  await expect.poll(() => project.read("one.cdl")).toContain("persistence = 7 s");
  // It is what runs already: nothing has to be run anew.
  await designer.button("Pause").waitFor();
  expect(await designer.button("Run the change").count()).toBe(0);
});

test("the movement field is read as it is switched on, live, and says why it can't be", async () => {
  const { designer } = await opened(kWander);
  const { simulator } = designer;
  await designer.on("Wander");
  await run(designer);
  await designer.button("Movement field of the selection").click();
  const note = simulator.getByText("Movement field of Wander", { exact: false });
  await note.waitFor();
  await simulator.getByText("Running", { exact: true }).waitFor(); // nobody had to pause it
  await designer.select(designer.named("Noise"));
  await simulator.getByText("Movement field of Noise", { exact: false }).waitFor();
  await designer.toFile();
  await simulator.getByText("No movement field: The page of a file gives no movement").waitFor();
});

test("a new configuration keeps its run when it is saved", async () => {
  const { designer } = await begin({ width: 1600, height: 900 });
  await designer.newAssemblage("Wander");
  await designer.place("Noise");
  await designer.wire(designer.output(designer.node("Noise")), designer.result);
  await designer.hasWires(1);
  await run(designer);
  await designer.saveAs("kept");
  await designer.page.getByText("kept.cdl").first().waitFor();
  await designer.button("Pause").waitFor();
  expect(await designer.simulator.getByText("another mission").count()).toBe(0);
  const before = await time(designer);
  await expect.poll(() => time(designer)).toBeGreaterThan(before + 0.5);
  await designer.page.locator(".wire-label.live").first().waitFor();
  expect(await designer.button("Run the change").count()).toBe(0);
});

test("a probe stays in sight on other pages", async () => {
  const { designer } = await opened(kWander);
  await designer.on("Wander");
  await run(designer);
  await designer.select(designer.named("Noise"));
  await designer.details.getByRole("button", { name: "Pin a probe" }).click();
  await designer.probes
    .getByRole("button", { name: /Noise$/ })
    .first()
    .waitFor();
  await designer.toFile();
  await designer.probes.locator(".live-arrow").waitFor();
});

test("start places are set with the mouse on the map", async () => {
  const { designer } = await opened(kWander);
  await designer.on("Wander");
  await designer.button("What runs").click();
  await designer.button("Show on the map, without running").click();
  await designer.page.keyboard.press("Escape");
  const map = designer.simulator.getByRole("application", { name: /^Map/ });
  await map.waitFor();
  await designer.button("Set where robots start").click();
  await map.click({ position: { x: 200, y: 150 } });
  await map.click({ position: { x: 240, y: 200 } });
  await designer.button("What runs").click();
  await designer.page.getByText("2 start places are set on the map.").waitFor();
});

test("what does not compile says so, and leads to the problem", async () => {
  const { designer } = await opened("assemblage Bad() {\n  cooperate {\n    1: Nosie();\n  }\n}\n");
  await designer.on("Bad");
  await expect.poll(() => designer.verdict.textContent()).toMatch(/\d error/);
  await designer.page.locator("[data-tour=run]").click();
  await designer.page.getByText("It does not compile").first().waitFor();
  await designer.problems.waitFor();
  await expect.poll(() => designer.page.locator(".react-flow__node.selected").count()).toBe(1);
});

test("the same run goes on in the console, which becomes the operator", async () => {
  const { designer } = await opened(kWander);
  await designer.on("Wander");
  await run(designer);
  const coming = designer.page.context().waitForEvent("page");
  await designer.button("Open in the console").click();
  const other = await coming;
  await other.getByTestId("run-time").waitFor();
  await expect.poll(() => other.getByTestId("main-button").isEnabled()).toBe(true);
  await other.close();
});
