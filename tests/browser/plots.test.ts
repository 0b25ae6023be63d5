import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("a plot shows a curve while the mission runs, and is saved as CSV, SVG and PNG", async () => {
  const { console, project } = await begin({ mission: "demo_c" });
  const { page } = console;
  // Chosen while the robots wait: a slow page would come when they have arrived, and then the curve is flat.
  await console.startRobots();
  const plots = await console.panel("Plots");
  await plots.getByRole("button", { name: "Distance to goal" }).click();
  const strip = plots.getByRole("region", { name: /^Plot of Distance to goal/i });
  await strip.locator("canvas").waitFor();
  await plots.getByRole("button", { name: "Add…" }).click();
  const chooser = page.getByRole("dialog", { name: "Add to the plots" });
  await chooser
    .getByRole("listbox", { name: "What" })
    .getByRole("option", { name: /^Speed/ })
    .click();
  await chooser
    .getByRole("listbox", { name: "Of whom" })
    .getByRole("option", { name: /^robot 1/i })
    .first()
    .click();
  await chooser.getByRole("button", { name: "Add", exact: true }).click();
  await plots
    .getByRole("region", { name: /^Plot of Speed/i })
    .first()
    .waitFor();
  await console.main.click();
  await console.reaches("Running");
  await console.passes(20);

  // Something is drawn in the colour of a curve, not only axes and grid.
  await expect
    .poll(() =>
      strip.locator("canvas").evaluate((canvas: HTMLCanvasElement) => {
        const data = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height).data;
        let coloured = 0;
        for (let i = 0; i < data.length; i += 4) {
          const [r = 0, g = 0, b = 0, a = 0] = data.slice(i, i + 4);
          if (a > 200 && Math.max(r, g, b) - Math.min(r, g, b) > 90) ++coloured;
        }
        return coloured;
      }),
    )
    .toBeGreaterThan(20);

  const saved = async (what: string) => {
    await plots.getByRole("button", { name: "Export" }).click();
    const download = page.waitForEvent("download");
    await page.getByRole("menuitem", { name: what }).click();
    const path = project.path("saved");
    await (await download).saveAs(path);
    return readFileSync(path);
  };
  const [head = "", ...rows] = (await saved("Table (CSV)")).toString("utf8").trim().split("\n");
  expect(head).toMatch(/time/i);
  expect(rows.length).toBeGreaterThan(10);
  const numbers = rows.map((row) => row.split(",").map(Number));
  expect(numbers.every((row) => Number.isFinite(row[0]))).toBe(true);
  expect(new Set(numbers.map((row) => row[1])).size).toBeGreaterThan(5);
  expect((await saved("Drawing (SVG)")).toString("utf8")).toMatch(/<svg[\s\S]*<path/);
  expect((await saved("Picture (PNG)")).subarray(1, 4).toString()).toBe("PNG");
});

test("plots stand again after a reload, and go on", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  const plots = await console.panel("Plots");
  // One that is never nothing: a slow page comes back when the robots stand.
  await plots.getByRole("button", { name: "Distance to goal" }).click();
  const value = plots.locator(".plot-value").first();
  await expect.poll(async () => Number.parseFloat(await value.innerText())).toBeGreaterThan(0);
  await page.reload();
  await expect.poll(async () => Number.parseFloat(await value.innerText()), { timeout: 30_000 }).toBeGreaterThan(0);
});
