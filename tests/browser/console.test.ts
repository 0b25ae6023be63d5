// The console as a person uses it: by mouse and by keyboard, alone and in company.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, describe, expect, test } from "vitest";
import { openBrowser } from "../../web/tools/browser.mjs";
import { Mlab, missions } from "./mlab.ts";

const kDemo = join(missions, "demo_c", "demo_c.mdl");
const axe = readFileSync(
  createRequire(new URL("../../web/package.json", import.meta.url)).resolve("axe-core/axe.min.js"),
  "utf8",
);

let browser: Awaited<ReturnType<typeof openBrowser>>;
let mlab: Mlab | undefined;
let pages: Page[] = [];

beforeAll(async () => {
  browser = await openBrowser();
});
afterAll(async () => {
  await browser?.close();
});
afterEach(async () => {
  for (const page of pages) await page.close();
  pages = [];
  await mlab?.stop();
  mlab = undefined;
});

async function open(url: string, width = 1280, height = 800): Promise<Page> {
  const page = await browser.page({ width, height });
  pages.push(page);
  page.setDefaultTimeout(60_000);
  await page.goto(url);
  return page;
}

async function start(...options: string[]): Promise<Page> {
  mlab = await Mlab.start(...options);
  return open(mlab.url);
}

const main = (page: Page) => page.getByTestId("main-button");
const state = (page: Page) => page.getByTestId("run-state");

async function until(page: Page, word: string): Promise<void> {
  await state(page).filter({ hasText: word }).waitFor();
}

async function violations(page: Page): Promise<string[]> {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    // biome-ignore lint/suspicious/noExplicitAny: axe was put into the page as a script
    const found = await (window as any).axe.run(document, { resultTypes: ["violations"] });
    return found.violations.map(
      (one: { id: string; nodes: { target: string[] }[] }) =>
        `${one.id}: ${one.nodes.map((node) => node.target.join(" ")).join(", ")}`,
    );
  });
}

describe("a mission", () => {
  test("is carried out by mouse, from Execute through all questions to the end", async () => {
    const page = await start(kDemo, "--speed", "max");
    await main(page).filter({ hasText: "Execute" }).click();
    const proceed = page.getByRole("button", { name: /^PROCEED/ });
    let answers = 0;
    for (;;) {
      const next = await Promise.race([
        proceed
          .first()
          .waitFor()
          .then(() => "question"),
        main(page)
          .filter({ hasText: "Restart" })
          .waitFor()
          .then(() => "end"),
      ]);
      if (next === "end") break;
      const asked = await page.locator("[data-question]").first().getAttribute("data-question");
      await proceed.first().click();
      await page.locator(`[data-question="${asked}"]`).waitFor({ state: "detached" });
      answers++;
      expect(answers).toBeLessThan(20);
    }
    expect(answers).toBe(5);
    await until(page, "Done");
    await page.getByText("12 of 12 done").waitFor();
  });

  test("is paused, stepped and stopped by keys, even while a dialog is open", async () => {
    const page = await start(kDemo, "--speed", "5");
    await main(page).waitFor();
    await page.keyboard.press("x");
    await until(page, "Running");
    await page.keyboard.press("x");
    await until(page, "Paused");
    const before = await page.getByTestId("run-time").textContent();
    await page.keyboard.press("c");
    await page.waitForFunction(
      (text) => document.querySelector("[data-testid=run-time]")?.textContent !== text,
      before,
    );
    await until(page, "Paused");
    await page.keyboard.press("Control+k");
    await page.getByRole("combobox", { name: "Search all commands" }).waitFor();
    await page.keyboard.press("Control+.");
    await until(page, "Emergency stop");
    await page.keyboard.press("Escape");
    await main(page).filter({ hasText: "Release the stop" }).click();
    await until(page, "Paused");
    await page.keyboard.press("?");
    await page.getByRole("heading", { name: "Keyboard shortcuts" }).waitFor();
    await page.getByTestId("emergency-stop").click();
    await until(page, "Emergency stop");
  });

  test("takes a typed line, and says beforehand whom it means and what it ends", async () => {
    const page = await start(kDemo, "--speed", "5");
    await main(page).click();
    await page.locator("[data-question]").first().waitFor();
    await page.keyboard.press("/");
    await page.keyboard.type("UNIT scouts-1 MOVETO 300 300");
    await page.getByText("2 robots (1, 2)").waitFor();
    await page.getByText(/Ends what it does now/).waitFor();
    await page.keyboard.press("Enter");
    await page.getByRole("heading", { name: "Sent to" }).waitFor();
    await page.locator(".step.running").filter({ hasText: "typed" }).filter({ hasText: "MOVETO 300 300" }).waitFor();
    await page.keyboard.press("ArrowUp");
    expect(await page.locator("#command-line").inputValue()).toBe("UNIT scouts-1 MOVETO 300 300");
    await page.locator("#command-line").fill("UNIT scouts MOVETO ATK-AP9");
    await page.getByRole("heading", { name: "Can't be sent yet" }).waitFor();
    await page.locator(".marked-line mark").filter({ hasText: "ATK-AP9" }).waitFor();
  });
});

describe("what a robot does", () => {
  test("is explained, and its parameters can be changed and undone", async () => {
    const page = await start(kDemo, "--speed", "5");
    await main(page).click();
    await page.locator("[data-question]").first().waitFor();
    await page.keyboard.press("]");
    await page.getByRole("tab", { name: "Why?" }).click();
    await page
      .getByText(/operator's clearance/)
      .first()
      .waitFor();
    await page.getByRole("tab", { name: "Parameters" }).click();
    const field = page.getByRole("textbox", { name: /^base velocity/ });
    const before = await field.inputValue();
    await field.fill("3.5");
    await field.press("Enter");
    await page.getByRole("button", { name: /^Undo .*base_velocity/ }).click();
    await page.waitForFunction(
      (value) => [...document.querySelectorAll<HTMLInputElement>("input")].some((one) => one.value === value),
      before,
    );
    await page.getByRole("button", { name: /^Redo .*base_velocity/ }).waitFor();
  });
});

describe("the text", () => {
  test("is checked while it is typed, and undone by name", async () => {
    const page = await start(kDemo);
    await main(page).waitFor();
    await page.keyboard.press("9");
    await page.locator(".cm-content").click();
    await page.keyboard.press("Control+Home");
    await page.keyboard.type("NONSENSE ");
    await page.getByRole("list", { name: "Problems" }).waitFor();
    await page.getByText(/What runs is the last version without/).waitFor();
    await page.getByRole("button", { name: "Undo typing in demo_c.mdl" }).click();
    await page.getByRole("list", { name: "Problems" }).waitFor({ state: "detached" });
    expect(await page.locator(".cm-line").first().textContent()).not.toContain("NONSENSE");
  });
});

describe("the page", () => {
  test("comes back to the same view after a reload", async () => {
    const page = await start(kDemo, "--speed", "5");
    await main(page).click();
    await page.locator("[data-question]").first().waitFor();
    await page.keyboard.press("2");
    await page.getByRole("row", { name: /Robot 3/ }).click();
    await page.getByRole("heading", { name: "Robot 3" }).waitFor();
    await page.waitForTimeout(500);
    await page.reload();
    await page.getByRole("heading", { name: "Robot 3" }).waitFor();
    await page.getByRole("grid", { name: "Robots and units" }).waitFor();
    await page.locator("[data-question]").first().waitFor();
  });

  test("undoes changes of its layout by name", async () => {
    const page = await start(kDemo);
    await main(page).waitFor();
    await page.keyboard.press("1");
    await main(page).waitFor({ state: "detached" });
    await page.getByRole("button", { name: "Undo hide Mission" }).click();
    await main(page).waitFor();
  });

  test("is handed over between two people, and one of them only watches", async () => {
    const one = await start(kDemo);
    await main(one).filter({ hasText: "Execute" }).waitFor();
    const two = await open((mlab as Mlab).url);
    await two.getByText(/You are watching. Browser 1 is the operator/).waitFor();
    await two.getByRole("button", { name: "Ask for control" }).click();
    await one.bringToFront();
    await one.getByRole("button", { name: "Hand over", exact: true }).click();
    await one.getByText(/You are watching. Browser 2 is the operator/).waitFor();
    await two.bringToFront();
    await main(two).filter({ hasText: "Execute" }).waitFor();
  });

  test("says so when the server is gone", async () => {
    const page = await start(kDemo);
    await main(page).waitFor();
    await mlab?.stop();
    await page.getByText(/Connection lost/).waitFor();
    expect(await main(page).isDisabled()).toBe(true);
  });

  test("begins without a mission and opens an example", async () => {
    const page = await start();
    await page.getByRole("heading", { name: "Which mission?" }).waitFor();
    expect(await violations(page)).toEqual([]);
    await page.getByRole("region", { name: "Examples" }).getByRole("button").first().click();
    await main(page).filter({ hasText: "Execute" }).waitFor();
  });
});

test("no view has an accessibility violation", async () => {
  const page = await start(kDemo, "--speed", "5");
  await main(page).click();
  await page.locator("[data-question]").first().waitFor();
  await page.keyboard.press("x");
  await page.keyboard.press("]");
  const found: Record<string, string[]> = {};
  const look = async (name: string) => {
    await page.waitForTimeout(300);
    const bad = await violations(page);
    if (bad.length > 0) found[name] = bad;
  };
  for (const theme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme: theme });
    for (const tab of ["Overview", "Why?", "Parameters", "Ports"]) {
      await page.getByRole("tab", { name: tab }).click();
      await look(`${theme} ${tab}`);
    }
    for (const name of ["Robots", "Draw", "World", "Mission", "Steer", "View", "Log", "Text", "Plots", "Selection"]) {
      await page.locator(".rail, .strip").getByRole("button", { name, exact: true }).click();
      await look(`${theme} ${name}`);
    }
    await page.keyboard.press("Control+k");
    await look(`${theme} palette`);
    await page.keyboard.press("Escape");
  }
  expect(found).toEqual({});
});
