import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("a mistake in the mission is underlined as it is typed, mended and saved", async () => {
  const { console, project } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  const panel = await console.panel("Text");
  const text = panel.getByRole("textbox", { name: /^Text of / });
  await text.getByText("OBJ-Tango").first().waitFor();
  await text.click();
  await page.keyboard.press("Control+End");
  await page.keyboard.insertText("\n 12. UNIT scuots STOP");
  const problems = panel.getByRole("list", { name: "Problems" });
  await problems
    .getByText(/scuots/)
    .first()
    .waitFor();
  await text.locator(".cm-lintRange-error").first().waitFor();
  await page.getByText("The mission text has errors. What runs is the last version without.").waitFor();

  await page.keyboard.press("Shift+Home");
  await page.keyboard.insertText("12. UNIT scouts STOP");
  await text.locator(".cm-lintRange-error").waitFor({ state: "detached" });
  // No error any more, but what is odd is still said.
  await problems.getByText("gets a command after it was stopped").waitFor();
  expect(await problems.getByText(/scuots/).count()).toBe(0);
  await console.panel("Mission");
  await console.steps.getByText(/ of 13 done/).waitFor();
  await panel.getByRole("button", { name: "Save", exact: true }).click();
  await console.button("Not saved").waitFor({ state: "detached" });
  expect(project.read("demo_c.mdl")).toContain("12. UNIT scouts STOP");
  expect(project.read("demo_c.mdl")).toContain("-- Demo C: four scouts");
});

test("a mission with errors opens with its errors, and runs once they are mended", async () => {
  const { console } = await begin({
    mission: "demo_c",
    prepare: (project) =>
      project.write("demo_c.mdl", project.read("demo_c.mdl").replace("ATK-AP1 FORMATION", "ATK-AP9 FORMATION")),
  });
  const { page } = console;
  await console.reaches("Has errors");
  await console.main.getByText("Show the errors").click();
  const panel = page.getByRole("region", { name: "Text", exact: true });
  await panel
    .getByRole("list", { name: "Problems" })
    .getByText(/ATK-AP9/)
    .first()
    .waitFor();
  await panel.getByRole("list", { name: "Problems" }).getByRole("button").first().click();
  await page.keyboard.press("Home");
  await page.keyboard.press("Shift+End");
  await page.keyboard.insertText("2. UNIT scouts MOVETO ATK-AP1 FORMATION Column");
  await console.reaches("Ready");
  expect(await panel.getByRole("list", { name: "Problems" }).count()).toBe(0);
});

test("an edit during a run is taken up, and the mission is continued from a step", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.startRobots();
  await page.getByRole("button", { name: "Actions of step 9" }).click();
  await page.getByRole("menuitem", { name: "Show in the text" }).click();
  const panel = page.getByRole("region", { name: "Text", exact: true });
  await panel.getByRole("button", { name: "Continue from step 9" }).click();
  await console.steps.locator("[aria-current=step]").filter({ hasText: "OBJ-Tango" }).waitFor();
  await console.reaches("Running");
});

test("typing is undone by its name", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  const panel = await console.panel("Text");
  const text = panel.getByRole("textbox", { name: /^Text of / });
  await text.getByText("Demo C: four scouts").waitFor();
  await text.click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.insertText("NONSENSE ");
  await panel.getByRole("list", { name: "Problems" }).waitFor();
  await console.button("Undo typing in demo_c.mdl").click();
  await panel.getByRole("list", { name: "Problems" }).waitFor({ state: "detached" });
  await expect.poll(() => text.textContent()).not.toContain("NONSENSE");
});
