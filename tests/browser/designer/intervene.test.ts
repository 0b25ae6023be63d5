// What a person does to robots that run what is drawn: sends them to a state, holds a value, lets them take over a change.
import { expect, test } from "vitest";
import { picture } from "../picture.ts";
import type { DesignerPage } from "./designer.ts";
import { kWander, opened, run, time, turns } from "./running.ts";

// Nothing leads anywhere by itself within this test.
const kTurns = turns(1000);

const active = ({ page }: DesignerPage, state: string) =>
  page.locator(`.react-flow__node[data-id="${state}"] .state.active`);

test("a robot is sent to a state, by the menu of the state and by that of a transition", async () => {
  const { designer } = await opened(kTurns);
  const { page } = designer;
  await designer.on("Turns");
  await designer.node("Moving").click({ button: "right" });
  await page.getByRole("menuitem", { name: "Go to Moving now" }).waitFor();
  expect(await page.getByRole("menuitem", { name: "Go to Moving now" }).getAttribute("aria-disabled")).toBe("true");
  await page.keyboard.press("Escape");
  await run(designer);
  await active(designer, "Waiting").waitFor();
  await designer.node("Moving").click({ button: "right" });
  await page.getByRole("menuitem", { name: "Go to Moving now" }).click();
  await active(designer, "Moving").waitFor();
  // Out of a state in which it is not, nothing leads.
  const transition = (from: string) => page.getByRole("button", { name: new RegExp(`^Transition 1 of ${from}`) });
  await transition("Waiting").click();
  await designer.details
    .getByRole("button", { name: /^Break/ })
    .first()
    .waitFor();
  expect(await designer.details.getByRole("button", { name: "Go from Waiting to Moving now" }).count()).toBe(0);
  await transition("Moving").click();
  await designer.details.getByRole("button", { name: "Go from Moving to Waiting now" }).click();
  await active(designer, "Waiting").waitFor();
  await picture(page, "forced", { of: "designer" });
});

test("a value on a wire is held, shown as held, and released", async () => {
  const { designer } = await opened(kWander);
  const { page, details, simulator } = designer;
  await designer.on("Wander");
  await run(designer);
  await designer.select(designer.named("Noise"));
  const field = details.getByRole("textbox", { name: /^Hold it for .* at \[Vector/ });
  await field.fill("nonsense");
  await details.getByRole("button", { name: "Hold", exact: true }).click();
  await page
    .getByText(/nonsense.* is no vector/)
    .first()
    .waitFor({ timeout: 15_000 });
  await field.fill("0.5, 0");
  await details.getByRole("button", { name: "Hold", exact: true }).click();
  await details.getByText("Held at", { exact: false }).waitFor();
  const held = page.locator(".wire-label.held");
  await expect.poll(() => held.count()).toBe(1);
  await expect.poll(() => held.textContent()).toContain("0.5");
  const list = simulator.getByRole("region", { name: "Held values" });
  await list.getByText("Noise", { exact: false }).first().waitFor();
  await picture(page, "held", { of: "designer" });
  if (process.env.MLAB_TOUR) {
    await page.emulateMedia({ colorScheme: "dark" });
    await picture(page, "held_dark", { of: "designer" });
    await page.emulateMedia({ colorScheme: "light" });
  }
  // Another robot computes it.
  await simulator.getByRole("button", { name: /Values of/ }).click();
  await page.getByRole("option").nth(1).click();
  await expect.poll(() => held.count()).toBe(0);
  await list
    .getByRole("button", { name: /^Release/ })
    .first()
    .click();
  await list.waitFor({ state: "detached" });
});

test("robots take over a change of the text where they are, and it is said what begins anew", async () => {
  const { designer } = await opened(kTurns);
  const { page, simulator } = designer;
  await designer.on("Turns");
  await run(designer);
  await active(designer, "Waiting").waitFor();
  await designer.node("Moving").click({ button: "right" });
  await page.getByRole("menuitem", { name: "Go to Moving now" }).click();
  await active(designer, "Moving").waitFor();
  expect(await designer.button("Take over").count()).toBe(0);
  await page.keyboard.press("t");
  const rewrite = async (text: string) => {
    await designer.text.click();
    await page.keyboard.press("Control+a");
    await page.keyboard.insertText(text);
  };
  await rewrite(kTurns.replace("persistence = 2 s", "persistence = 3 s"));
  const before = await time(designer);
  await designer.button("Take over").click();
  await simulator.getByText("took over a change; nothing begins anew", { exact: false }).waitFor();
  await active(designer, "Moving").waitFor();
  expect(await time(designer)).toBeGreaterThanOrEqual(before);
  await rewrite(kTurns.replaceAll("Moving", "Roaming"));
  await designer.button("Take over").click();
  await simulator.getByText("begins in Waiting: its state Moving is gone", { exact: false }).waitFor();
  await picture(page, "taken_over", { of: "designer" });
  await active(designer, "Waiting").waitFor();
  // An undo is a change like any other.
  await designer.text.press("Control+z");
  await designer.button("Take over").click();
  await simulator.getByText("took over a change", { exact: false }).waitFor();
  await designer.node("Moving").waitFor();
  expect(await time(designer)).toBeGreaterThanOrEqual(before);
});
