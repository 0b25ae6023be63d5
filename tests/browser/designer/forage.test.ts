// The forage of Figures 6 to 9, from an empty canvas: the states by keyboard and mouse, the robot, the society.
import { expect, test } from "vitest";
import { atRest } from "../at_rest.ts";
import { begin, type DesignerPage } from "./designer.ts";

const kForage = `assemblage Forage(attractor: object_class = Mine) {
  sequence {
    start Searching: Wander();
      when Detect(attractor) goto Acquiring;
    Acquiring: Acquire(attractor);
      when Holding(attractor) goto Delivering;
      when not Detect(attractor) goto Searching;
    Delivering: Deliver();
      when not Holding(attractor) goto Searching;
  }
}

robot Forager is MRV2 {
  movement = Forage();
}

society Foragers: team of 5 Forager;
`;

async function stateDoes(designer: DesignerPage, state: string, member: string): Promise<void> {
  await designer.select(designer.node(state));
  const field = designer.details.getByRole("textbox", { name: "What the robot does in it" });
  await field.fill(member);
  await field.press("Control+Enter");
  await expect.poll(() => field.inputValue()).toBe(member);
}

/** By keyboard: the state is selected, C, the other state, and then its trigger, typed. */
async function transition(designer: DesignerPage, from: string, to: string, trigger: string): Promise<void> {
  const { page } = designer;
  const before = await page.locator(".transition-label").count();
  await designer.select(designer.node(from));
  await page.keyboard.press("c");
  const field = page.getByRole("combobox", { name: `Transition from ${from} to` });
  await field.fill(to);
  await field.press("Enter");
  await page.getByRole("combobox", { name: `When does ${from} end?` }).press("Escape");
  await expect.poll(() => page.locator(".transition-label").count()).toBe(before + 1);
  await page
    .getByRole("button", { name: new RegExp(`^Transition \\d of ${from}: .*, to ${to}$`) })
    .last()
    .click();
  const when = designer.details.getByRole("textbox", { name: "When" });
  await when.fill(trigger);
  await when.press("Control+Enter");
  await page.getByRole("button", { name: `when ${trigger}, to ${to}` }).waitFor();
}

async function rename(designer: DesignerPage, from: string, to: string): Promise<void> {
  await designer.select(designer.node(from));
  await designer.page.keyboard.press("F2");
  const dialog = designer.page.getByRole("dialog", { name: `Rename ${from}` });
  await dialog.getByRole("textbox", { name: "Name" }).fill(to);
  await dialog.getByRole("textbox", { name: "Name" }).press("Enter");
  await designer.node(to).waitFor();
}

test("the forage of Figures 6 to 9 is built from an empty canvas", async () => {
  const { designer, project } = await begin();
  const { page } = designer;
  await designer.newAssemblage("Forage");
  await designer.details.getByRole("button", { name: "Add a parameter" }).click();
  const dialog = page.getByRole("dialog");
  await dialog.getByRole("textbox", { name: "Name" }).fill("attractor");
  await dialog.getByRole("button", { name: /Type$/ }).click();
  await page.getByRole("option", { name: "object_class" }).click();
  await dialog.getByRole("textbox", { name: "Default" }).fill("Mine");
  await dialog.getByRole("button", { name: "Add", exact: true }).click();
  await dialog.waitFor({ state: "detached" });

  await designer.place("sequence");
  await page.keyboard.press("f");
  await atRest(() => designer.result.boundingBox());
  await designer.wire(designer.output(designer.named("sequence")), designer.result);
  await designer.node("Waiting").waitFor();
  await rename(designer, "Waiting", "Searching");
  await stateDoes(designer, "Searching", "Wander()");
  await designer.details.getByText("Final: no way out on purpose").click();
  await designer.place("Acquire");
  await rename(designer, "Acquire", "Acquiring");
  await stateDoes(designer, "Acquiring", "Acquire(attractor)");
  await designer.place("Deliver");
  await rename(designer, "Deliver", "Delivering");
  await transition(designer, "Searching", "Acquiring", "Detect(attractor)");
  await transition(designer, "Acquiring", "Delivering", "Holding(attractor)");
  await transition(designer, "Acquiring", "Searching", "not Detect(attractor)");
  await transition(designer, "Delivering", "Searching", "not Holding(attractor)");

  await designer.toFile();
  await designer.declare("Robot", "Forager");
  await designer.place("Forage");
  await designer.wire(designer.output(designer.named("Forage")), designer.page.locator('[data-handleid="v"].target'));
  await designer.hasWires(1);
  await page.locator(".react-flow__pane").click({ position: { x: 300, y: 500 } });
  await designer.details.getByRole("button", { name: /Robot class/ }).click();
  await page.getByRole("option", { name: /^MRV2/ }).click();
  await designer.details.getByText("It has all that the robot needs.").waitFor();

  await designer.toFile();
  await designer.declare("Society", "Foragers");
  await designer.details.getByRole("textbox", { name: "How many" }).fill("5");
  await designer.details.getByRole("textbox", { name: "How many" }).press("Enter");
  await expect.poll(() => designer.verdict.textContent()).not.toMatch(/error/);

  await designer.saveAs("forager");
  await expect.poll(() => project.read("forager.cdl").split("\nlayout ")[0]).toBe(kForage);
});
