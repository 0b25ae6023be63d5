// A window of 640 x 400 CSS pixels, as a page of 1280 x 800 at 200 %, and a server that falls silent.
import { expect, test } from "vitest";
import { expectWithin } from "../within.ts";
import { begin } from "./designer.ts";

test("at 640 x 400 all of the designer can be reached", async () => {
  const { designer } = await begin({ mission: "forage", file: "forager.cdl", width: 640, height: 400 });
  const { page } = designer;
  await designer.verdict.waitFor();
  const bar = page.locator(".topbar");
  for (const name of ["Menu", "Run", "What runs", "Open in the console", "Keyboard shortcuts"])
    await expectWithin(bar.getByRole("button", { name, exact: true }));
  await expectWithin(bar.getByRole("button", { name: /^Stop/ }));
  await expectWithin(designer.verdict);
  for (const [title, region] of [
    ["Components", designer.palette],
    ["Text", page.getByRole("region", { name: "Text", exact: true })],
    ["Simulator", designer.simulator],
    ["Details", designer.details],
    ["Problems", designer.problems],
  ] as const) {
    const toggle = page.locator(".strip-toggle", { hasText: title });
    await expectWithin(toggle);
    if ((await toggle.getAttribute("aria-pressed")) !== "true") await toggle.click();
    await region.waitFor();
    const close = region.getByRole("button", { name: `Hide ${title}` });
    await expectWithin(close);
    await close.click();
    await region.waitFor({ state: "detached" });
  }
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(640);
});

test("a designer whose server falls silent says so, and goes on when it answers", async () => {
  const { designer, mlab } = await begin({ mission: "forage", file: "forager.cdl" });
  await designer.verdict.waitFor();
  mlab.freeze();
  await designer.page.getByText(/No answer for \d+ s/).waitFor();
  mlab.thaw();
  await designer.page.getByTestId("silence").waitFor({ state: "detached" });
});
