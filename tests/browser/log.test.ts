import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("the log tells what happened, is filtered by text and kind, and leads to the place", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.setSpeed("Max");
  await console.main.click();
  await console.questions
    .getByRole("button", { name: /^PROCEED/ })
    .first()
    .waitFor({ timeout: 120_000 });
  const log = await console.panel("Log");
  const rows = log.locator(".log-row");
  await rows.first().waitFor();
  const all = await rows.count();

  await log.getByRole("searchbox", { name: "Filter the log" }).fill("OCCUPY");
  await log.getByText(/^\d+ of \d+ entries$/).waitFor();
  const found = await rows.allTextContents();
  expect(found.length).toBeGreaterThan(0);
  expect(found.length).toBeLessThan(all);
  expect(found.every((text) => /OCCUPY/i.test(text))).toBe(true);
  await log.getByRole("searchbox", { name: "Filter the log" }).fill("");

  const camera = await console.camera();
  await console.button("Zoom in").click();
  await console.button("Zoom in").click();
  await expect.poll(async () => (await console.camera()).scale).toBeGreaterThan(camera.scale);
  const zoomed = await console.camera();
  await log
    .getByRole("button", { name: /: show on the map$/ })
    .first()
    .click();
  await expect
    .poll(async () => {
      const now = await console.camera();
      return Math.hypot(now.x - zoomed.x, now.y - zoomed.y);
    })
    .toBeGreaterThan(20);

  await log.getByRole("button", { name: /kinds$/i }).click();
  const kinds = page.getByRole("dialog", { name: "Kinds of entries" });
  await kinds.getByRole("button", { name: "Hide all" }).click();
  await log.getByText("Nothing to show.").waitFor();
});
