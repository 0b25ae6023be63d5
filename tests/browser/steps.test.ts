import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("robots stand where they will start before the mission does, and can be selected there", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  // The assembly area's middle, where START puts the first.
  const first = await console.onPage(140, 170);
  await page.mouse.click(first.x, first.y);
  await console.panel("Selection");
  await page.getByRole("heading", { name: "Robot 1" }).waitFor();
  await page.getByText("Not started yet").waitFor();
});

test("Step finishes the step that runs, Skip gives it up", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.setSpeed("Max");
  await console.startRobots();
  await console.main.getByText("Execute").waitFor();
  await console.button("Cycle").click(); // OCCUPY is begun
  await console.reaches("Paused");
  await console.button("Step").click();
  const question = console.questions.locator("[data-question]");
  await question.waitFor({ timeout: 60_000 });
  await question.getByRole("button", { name: /^PROCEED/ }).click();
  await console.steps.getByText("2 of 12 done").waitFor();
  await console.reaches("Paused");
  await expect.poll(() => console.main.textContent()).toContain("Execute");

  await console.button("Cycle").click(); // MOVETO is begun
  await console.reaches("Paused");
  await page.keyboard.press("Shift+N");
  await console.steps
    .getByRole("listitem")
    .filter({ hasText: "ATK-AP1" })
    .filter({ hasText: "Skipped" })
    .first()
    .waitFor();
});
