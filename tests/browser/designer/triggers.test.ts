// Triggers by choosing: somebody who knows no name of the library says when a transition is made.
import { expect, test } from "vitest";
import { atRest } from "../at_rest.ts";
import { begin, type DesignerPage } from "./designer.ts";

const kTwoStates = `assemblage Patrol() {
  sequence {
    start Going: Wander();
    Resting: Stand();
  }
}
`;

async function patrol(text = kTwoStates, size = { width: 1280, height: 800 }) {
  const begun = await begin({
    file: "patrol.cdl",
    prepare: (project) => project.write("patrol.cdl", text),
    ...size,
  });
  await begun.designer.on("Patrol");
  await begun.designer.node("Going").waitFor();
  return begun;
}

const written = (designer: DesignerPage) => designer.details.getByRole("textbox", { name: "When", exact: true });
const chooser = ({ page }: DesignerPage, name: string | RegExp) => page.getByRole("combobox", { name });

async function drawn(designer: DesignerPage): Promise<void> {
  const to = designer.node("Resting");
  await designer.wire(designer.output(designer.node("Going")), to);
}

/** By the buttons of the details, and keys alone. */
async function join(designer: DesignerPage, button: string, asked: string, letters: string): Promise<void> {
  await designer.details.getByRole("button", { name: button }).click();
  const field = chooser(designer, asked);
  await field.fill(letters);
  await designer.page.getByRole("option").first().waitFor();
  await field.press("Enter");
}

test("an arrow between two states asks what makes it, and its inputs are fields", async () => {
  const { designer } = await patrol();
  const { page } = designer;
  await drawn(designer);
  const field = chooser(designer, "When does Going end?");
  await field.waitFor();
  expect(await field.evaluate((one) => one === document.activeElement)).toBe(true);
  await page.getByRole("option", { name: /^Near/ }).first().waitFor();
  expect(await page.getByRole("option", { name: /^Wander/ }).count()).toBe(0);
  // By what it does, not by what it is called.
  await field.fill("near");
  await field.press("Enter");
  const distance = designer.details.getByRole("textbox", { name: /^distance/i });
  await distance.waitFor();
  await expect.poll(() => written(designer).inputValue()).toMatch(/^Near\(/);
  await distance.fill("3 m");
  await distance.press("Enter");
  await expect.poll(() => written(designer).inputValue()).toContain("distance = 3 m");
  // Each choice is one step.
  await page.keyboard.press("Escape");
  await designer.button(/^Undo/).click();
  await expect.poll(() => written(designer).inputValue()).not.toContain("distance");
  await designer.button(/^Undo/).click();
  await expect.poll(() => written(designer).inputValue()).toBe("");
});

test("who does not choose yet sees that the trigger is missing, and may choose later", async () => {
  const { designer } = await patrol();
  const { page } = designer;
  await designer.select(designer.node("Going"));
  await page.keyboard.press("c");
  const states = chooser(designer, "Transition from Going to");
  await states.fill("Resting");
  await states.press("Enter");
  await chooser(designer, "When does Going end?").press("Escape");
  const label = page.getByRole("button", { name: "Transition 1 of Going: no trigger yet, to Resting" });
  await label.waitFor();
  await expect.poll(() => label.getAttribute("aria-pressed")).toBe("true");
  await join(designer, "Choose a trigger…", "When does Going end?", "IsAtGoal");
  await page.getByRole("button", { name: /when IsAtGoal\(\), to Resting/ }).waitFor();
});

test("triggers are joined, negated and taken away by buttons", async () => {
  const { designer } = await patrol(
    kTwoStates.replace("Wander();", "Wander();\n      when Near(distance = 2 m) goto Resting;"),
  );
  const { page, details } = designer;
  await page.getByRole("button", { name: /^Transition 1 of Going/ }).click();
  const isWritten = (trigger: string) => expect.poll(() => written(designer).inputValue()).toBe(trigger);
  await join(designer, "And another trigger", "And when?", "IsAtGoal");
  await isWritten("Near(distance = 2 m) and IsAtGoal()");
  await details.getByRole("button", { name: "not IsAtGoal" }).click();
  await isWritten("Near(distance = 2 m) and not IsAtGoal()");
  await details.getByRole("button", { name: "all of these: change to or" }).click();
  await isWritten("Near(distance = 2 m) or not IsAtGoal()");
  await details.getByRole("button", { name: "Remove Near" }).click();
  await isWritten("not IsAtGoal()");
  await details.getByRole("button", { name: "Take the “not” away" }).click();
  await isWritten("IsAtGoal()");
  await details.getByRole("button", { name: "Remove IsAtGoal" }).click();
  await details.getByRole("button", { name: "Choose a trigger…" }).waitFor();
});

test("a trigger beside a part of another one has the focus when it is there", async () => {
  const { designer } = await patrol(
    kTwoStates.replace("Wander();", "Wander();\n      when Near(distance = 2 m) and IsHalted() goto Resting;"),
  );
  await designer.page.getByRole("button", { name: /^Transition 1 of Going/ }).click();
  await join(designer, "IsHalted or another trigger", "Or when?", "IsAtGoal");
  await expect.poll(() => written(designer).inputValue()).toBe("Near(distance = 2 m) and (IsHalted() or IsAtGoal())");
  const focused = designer.page.locator("[data-part='1.1'] :focus");
  await expect.poll(() => focused.count()).toBe(1);
});

test("who knows no name draws two states and what leads from one to the other, without typing", async () => {
  const { designer } = await begin();
  const { page, palette } = designer;
  await designer.newAssemblage("Patrol");
  await designer.place("sequence");
  await page.keyboard.press("f");
  await atRest(() => designer.result.boundingBox());
  await designer.wire(designer.output(designer.named("sequence")), designer.result);
  await designer.node("Waiting").waitFor();
  const entry = (title: string) => palette.getByRole("button", { name: new RegExp(`^${title}`) });
  await entry("Stand").first().click();
  await designer.node("Stand").waitFor();
  await designer.node("Waiting").click();
  await page.keyboard.press("c");
  await page.getByRole("option", { name: /^Stand/ }).click();
  await chooser(designer, "When does Waiting end?").waitFor();
  await page.getByRole("option", { name: /^Near/ }).first().click();
  await page.getByRole("button", { name: /^Transition 1 of Waiting: when Near\(/ }).waitFor();
});

test("a trigger is dropped on an arrow, or goes to the one that is selected", async () => {
  const { designer } = await patrol(
    kTwoStates.replace("Wander();", "Wander();\n      when Constant(value = false) goto Resting;"),
  );
  const { page, palette } = designer;
  const label = page.getByRole("button", { name: /^Transition 1 of Going/ });
  const entry = palette.locator("[data-component=Near]");
  await entry.dragTo(page.locator(".react-flow__pane"), { targetPosition: { x: 200, y: 80 } });
  await page.getByText("Near says when a transition is made: drop it on an arrow, or select one before.").waitFor();
  await entry.dragTo(label);
  await expect.poll(() => written(designer).inputValue()).toBe("Near()");
  await expect.poll(() => page.locator(".transition-label.aimed-at").count()).toBe(0);
  await palette.locator("[data-component=IsAtGoal]").click();
  await expect.poll(() => written(designer).inputValue()).toBe("Near() and IsAtGoal()");
});

test("what is wrong with a trigger is said at its transition", async () => {
  const { designer } = await patrol(
    kTwoStates.replace("Wander();", "Wander();\n      when Near(distance = 2 s) goto Resting;"),
  );
  const label = designer.page.getByRole("button", { name: /^Transition 1 of Going/ });
  await expect.poll(() => label.getAttribute("class")).toContain("has-error");
  await label.click();
  await designer.details.getByRole("list", { name: "What is wrong with the transition" }).waitFor();
});
