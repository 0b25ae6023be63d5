import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("Demo C is carried out by mouse, from Execute through every question to the end", async () => {
  const { console, mlab } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  await console.setSpeed("Max");
  await console.main.getByText("Execute").click();

  const proceed = console.questions.getByRole("button", { name: /^PROCEED/ }).first();
  const done = console.state.filter({ hasText: "Done" });
  const asked: string[] = [];
  for (;;) {
    await proceed.or(done).first().waitFor({ timeout: 120_000 });
    if (await done.isVisible()) break;
    const question = console.questions.locator("[data-question]").first();
    const id = await question.getAttribute("data-question");
    asked.push((await question.getAttribute("aria-label")) ?? "");
    await question.getByRole("button", { name: /^PROCEED/ }).click();
    await console.questions.locator(`[data-question="${id}"]`).waitFor({ state: "detached" });
  }

  // The four steps with OCCUPY, one of them of two units.
  expect(asked.length).toBe(5);
  expect(asked.every((text) => /proceed/i.test(text))).toBe(true);
  await console.steps.getByText("12 of 12 done").waitFor();
  expect(await console.steps.getByRole("listitem").count()).toBe(12);
  expect(await console.steps.getByRole("listitem").filter({ hasText: "Done" }).count()).toBe(12);
  await console.main.getByText("Restart").waitFor();
  const report = await page.evaluate(() => fetch(`report${location.search}`).then((answer) => answer.json()));
  expect(report.outcome).toBe("done");
  await page.goto("about:blank"); // it would look for the server
  expect(await mlab.stop()).toBe(0);
});

test("a question answered with ABORT ends its command, and says so", async () => {
  const { console } = await begin({ mission: "demo_c" });
  await console.setSpeed("Max");
  await console.main.click();
  const question = console.questions.locator("[data-question]").first();
  await question.waitFor();
  expect(await question.textContent()).toContain("scouts");
  await question.getByRole("button", { name: /^ABORT/ }).click();
  await question.waitFor({ state: "detached" });
  await console.reaches("Aborted");
  await console.steps.getByRole("listitem").filter({ hasText: "Aborted" }).first().waitFor();
});

test("single step, single cycle, pause, resume, jump, rewind and restart do what they say", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.startRobots();
  const before = await console.time();
  await console.button("Cycle").click();
  await expect.poll(() => console.time()).toBeGreaterThan(before);
  await console.reaches("Paused");
  await console.main.getByText("Resume").click();
  await console.reaches("Running");
  await console.main.getByText("Pause").click();
  await console.reaches("Paused");

  await page.getByRole("button", { name: "Actions of step 4" }).click();
  await page.getByRole("menuitem", { name: "Jump to this step" }).click();
  await console.main.click();
  await console.steps.locator("[aria-current=step]").filter({ hasText: "PP-Charlie" }).waitFor();
  await console.button("Rewind").click();
  await console.steps.locator("[aria-current=step]").filter({ hasText: "START" }).waitFor();
  await console.button("Restart").click();
  await page
    .getByRole("dialog", { name: "Restart the run?" })
    .getByRole("button", { name: "Restart", exact: true })
    .click();
  await console.reaches("Ready");
  await expect.poll(() => console.time()).toBe(0);
});

test("the whole mission can be carried out by keyboard", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  // To the right end of the speeds: as fast as it goes.
  for (let i = 0; i < 20; ++i) await page.keyboard.press(">");
  await page.keyboard.press("x");
  const done = console.state.filter({ hasText: "Done" });
  for (;;) {
    const question = console.questions.locator("[data-question]").first();
    await question.or(done).first().waitFor({ timeout: 120_000 });
    if (await done.isVisible()) break;
    const id = await question.getAttribute("data-question");
    await page.keyboard.press("p");
    await console.questions.locator(`[data-question="${id}"]`).waitFor({ state: "detached" });
  }
  await console.steps.getByText("12 of 12 done").waitFor();
});
