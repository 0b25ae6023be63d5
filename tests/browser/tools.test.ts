// What a person does to the map by mouse: commands, obstacles, drawing; steering by hand; plots.
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, afterEach, beforeAll, expect, test } from "vitest";
import { openBrowser } from "../../web/tools/browser.mjs";
import { Mlab, missions } from "./mlab.ts";

type Browser = Awaited<ReturnType<typeof openBrowser>>;
type Page = Awaited<ReturnType<Browser["page"]>>;

let browser: Browser;
let mlab: Mlab | null = null;
let troubles: string[] = [];

beforeAll(async () => {
  browser = await openBrowser();
});
afterAll(() => browser?.close());
afterEach(async () => {
  await mlab?.stop();
  mlab = null;
  expect(troubles).toEqual([]);
});

async function console(...options: string[]): Promise<Page> {
  mlab = await Mlab.start(...options);
  troubles = [];
  const page = await browser.page({ width: 1280, height: 800 });
  page.setDefaultTimeout(60_000);
  page.on("pageerror", (error) => troubles.push(String(error)));
  await page.goto(mlab.url);
  await page.getByText("Operator: you").waitFor();
  return page;
}

const demoC = join(missions, "demo_c", "demo_c.mdl");

function button(page: Page, name: string | RegExp) {
  return page.getByRole("button", { name, exact: typeof name === "string" }).first();
}

/** From one place of the map to another, shares of its width and height. */
async function drag(page: Page, from: [number, number], to: [number, number]): Promise<void> {
  const box = await page.locator(".map").first().boundingBox();
  if (!box) throw new Error("there is no map");
  const at = ([x, y]: [number, number]): [number, number] => [box.x + x * box.width, box.y + y * box.height];
  await page.mouse.move(...at(from));
  await page.mouse.down();
  await page.mouse.move(...at([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]), { steps: 3 });
  await page.mouse.move(...at(to), { steps: 3 });
  await page.mouse.up();
}

async function fact(page: Page, name: string): Promise<string> {
  return (await page.locator(".teleoperation-facts dt", { hasText: name }).first().locator("+ dd").innerText()).trim();
}

test("a command given on the map shows the MDL that it means and whom, and goes out as that", async () => {
  const page = await console(demoC);
  await button(page, /Execute/).click();
  await page.getByText("Running").first().waitFor();
  await page.locator(".map").first().focus();
  await page.keyboard.press("o");
  await drag(page, [0.45, 0.5], [0.5, 0.42]);
  const text = page.locator(".order-text");
  await text.waitFor();
  expect(await text.innerText()).toMatch(/^UNIT scouts MOVETO \d+ \d+ HEADING \d+$/);
  await page.getByLabel("Formation").selectOption("Wedge");
  await page.getByText("4 robots (1–4)").waitFor();
  const line = await text.innerText();
  expect(line).toContain("FORMATION Wedge");
  await page.getByRole("dialog", { name: "Command" }).getByRole("button", { name: "Send" }).click();
  await text.waitFor({ state: "detached" });
  const place = /MOVETO (\d+ \d+)/.exec(line)?.[1] ?? "";
  await page.getByText(`MOVETO ${place}`).first().waitFor();
  await page.close();
});

test("the stick moves a unit while it is held, and letting go stops it", async () => {
  const page = await console(demoC);
  await button(page, /Execute/).click();
  await page.getByText("Running").first().waitFor();
  await button(page, "Steer").click();
  await button(page, "Steer scouts").click();
  const pad = page.locator(".stick-pad").first();
  await pad.waitFor();
  const box = await pad.boundingBox();
  if (!box) throw new Error("there is no stick");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 60, { steps: 4 });
  await expect.poll(() => fact(page, "Stick"), { timeout: 30_000 }).toBe("100 %, by pointer");
  await expect.poll(async () => Number.parseFloat(await fact(page, "Speed")), { timeout: 60_000 }).toBeGreaterThan(0.5);
  await page.mouse.up();
  await expect.poll(() => fact(page, "Speed"), { timeout: 30_000 }).toBe("0.0 m/s");
  await pad.focus();
  await page.keyboard.down("w");
  await expect.poll(async () => Number.parseFloat(await fact(page, "Speed")), { timeout: 60_000 }).toBeGreaterThan(0.5);
  // The window loses the focus with the key down: nobody sees the key go up.
  await page.evaluate(() => window.dispatchEvent(new Event("blur")));
  await expect.poll(() => fact(page, "Stick"), { timeout: 30_000 }).toBe("let go: stands");
  await page.keyboard.up("w");
  await button(page, "End teleoperation").click();
  await pad.waitFor({ state: "detached" });
  await page.close();
});

test("an obstacle is added and moved while the mission runs, and undone by name", async () => {
  const page = await console(demoC);
  await button(page, /Execute/).click();
  await page.getByText("Running").first().waitFor();
  await button(page, "World").click();
  await page.getByText("9 obstacles, 0 objects").waitFor();
  await button(page, "Add obstacle").click();
  await drag(page, [0.4, 0.75], [0.43, 0.75]);
  await page.getByText("10 obstacles, 0 objects").waitFor();
  await button(page, "Move and resize").click();
  const x = page.getByLabel("x [m]");
  const before = Number(await x.inputValue());
  await drag(page, [0.4, 0.75], [0.5, 0.75]);
  await expect.poll(async () => Number(await x.inputValue()), { timeout: 30_000 }).toBeGreaterThan(before + 20);
  await page.keyboard.press("Control+z");
  await expect.poll(async () => Number(await x.inputValue()), { timeout: 30_000 }).toBe(before);
  await page.keyboard.press("Control+z");
  await page.getByText("9 obstacles, 0 objects").waitFor();
  await page.close();
});

test("control measures are drawn, named and saved as text", async () => {
  const folder = mkdtempSync(join(tmpdir(), "mlab-draw-"));
  const page = await console("--project", folder);
  await button(page, /New mission/).click();
  await page.getByRole("dialog").getByRole("textbox").first().fill("mine.mdl");
  await page
    .getByRole("dialog")
    .getByRole("button", { name: /Create/ })
    .click();
  await button(page, "Draw").click();
  await button(page, "Assembly area").click();
  await drag(page, [0.3, 0.6], [0.34, 0.62]);
  const name = page.getByRole("textbox", { name: "Name" });
  await expect.poll(() => name.inputValue(), { timeout: 30_000 }).toBe("AA-1");
  await name.fill("Rally");
  await name.press("Enter");
  await button(page, "Axis of advance").click();
  for (const [x, y] of [
    [0.35, 0.5],
    [0.5, 0.45],
    [0.6, 0.55],
  ] as const) {
    await drag(page, [x, y], [x, y]);
    await page.waitForTimeout(600); // else the two clicks would be a double click
  }
  await page.locator(".map").first().press("Enter");
  await expect.poll(() => name.inputValue(), { timeout: 30_000 }).toBe("AXIS-1");
  await page.keyboard.press("Control+s");
  await page.getByText("Not saved").waitFor({ state: "detached" });
  const text = readFileSync(join(folder, "mine.odl"), "utf8");
  expect(text).toMatch(/^AA Rally -?[\d.]+ -?[\d.]+ [\d.]+$/m);
  expect(text).toMatch(/^AXIS AXIS-1( -?[\d.]+){6}$/m);
  await page.close();
  rmSync(folder, { recursive: true, force: true });
});

test("a unit's speed is plotted live, kept over a reload, and saved as a table", async () => {
  const page = await console(demoC);
  await button(page, /Execute/).click();
  await page.getByText("Running").first().waitFor();
  await button(page, "Plots").click();
  await page.locator(".plots").getByRole("button", { name: "Speed" }).click();
  const value = page.locator(".plot-value").first();
  await expect.poll(async () => Number.parseFloat(await value.innerText()), { timeout: 60_000 }).toBeGreaterThan(0);
  await page.reload();
  await expect.poll(async () => Number.parseFloat(await value.innerText()), { timeout: 60_000 }).toBeGreaterThan(0);
  await button(page, "Export").click();
  const coming = page.waitForEvent("download");
  await page.getByRole("menuitem", { name: "Table (CSV)" }).click();
  const table = readFileSync(await (await coming).path(), "utf8").split("\r\n");
  expect(table[0]).toBe("time [s],scouts: Speed [m/s]");
  expect(table.length).toBeGreaterThan(10);
  await button(page, "Clear").click();
  await page.close();
});
