// No violation that axe knows, in every view, light and dark.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { expect, test } from "vitest";
import { begin } from "./begin.ts";
import type { Console } from "./console.ts";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const panels = [
  "Mission",
  "Robots",
  "Draw",
  "World",
  "Selection",
  "Teleoperation",
  "Failsafes",
  "View",
  "Log",
  "Text",
  "Plots",
];

const kRows = "FAILSAFE IN-CONTACT AFTER 100 CONTINUE\nFAILSAFE FOR ROBOT STUCK AFTER 500 HOLD\n";

interface Violation {
  id: string;
  help: string;
  nodes: { html: string }[];
}

async function violations(console: Console, view: string): Promise<string[]> {
  const { page } = console;
  // Not by a script element: the page's content security policy allows none.
  await page.evaluate(`if (!window.axe) { ${axe} }`);
  const found = await page.evaluate(() => {
    const { axe } = window as unknown as { axe: { run(): Promise<{ violations: Violation[] }> } };
    return axe.run().then((result) => result.violations);
  });
  return found.map(({ id, help, nodes }) => `${view}: ${id}: ${help}: ${nodes.map((node) => node.html).join(" ")}`);
}

async function theme(console: Console, name: "Light" | "Dark"): Promise<void> {
  const view = await console.panel("View");
  await view.getByRole("radio", { name, exact: true }).click();
  await console.page.locator(`[data-theme=${name.toLowerCase()}]`).first().waitFor();
}

for (const colours of ["Light", "Dark"] as const) {
  test(`every panel of a running mission is accessible, ${colours.toLowerCase()}`, async () => {
    const { console } = await begin({
      mission: "demo_c",
      prepare: (project) => project.write("demo_c.mdl", project.read("demo_c.mdl").replace(/^UNIT/m, `${kRows}UNIT`)),
    });
    await theme(console, colours);
    await console.panel("Mission");
    await console.main.click();
    await console.questions
      .getByRole("button", { name: /^PROCEED/ })
      .first()
      .waitFor({ timeout: 120_000 });
    await console.select("Robot 1");
    const found: string[] = [];
    for (const panel of panels) {
      await console.panel(panel);
      found.push(...(await violations(console, panel)));
    }
    for (const tab of ["Why?", "Parameters", "Ports"]) {
      const selection = await console.panel("Selection");
      await selection.getByRole("tab", { name: tab }).click();
      found.push(...(await violations(console, tab)));
    }
    const failsafes = await console.panel("Failsafes");
    await failsafes.getByText("What it means").first().click();
    await failsafes.getByRole("button", { name: "Try it" }).click();
    await failsafes.getByRole("list", { name: "What happens" }).waitFor();
    found.push(...(await violations(console, "what if")));
    await console.page.keyboard.press("Control+k");
    await console.page.getByRole("dialog", { name: "Search everything" }).waitFor();
    found.push(...(await violations(console, "palette")));
    await console.page.keyboard.press("Escape");
    await console.page.keyboard.press("Control+.");
    await console.reaches("Emergency stop");
    found.push(...(await violations(console, "stopped")));
    expect(found).toEqual([]);
  });
}

test("the start page, its dialogs and the page of a mission with errors are accessible", async () => {
  const { console } = await begin();
  const { page } = console;
  await page.getByRole("heading", { name: "Which mission?" }).waitFor();
  const found = await violations(console, "start");
  await console.button("New mission").click();
  await page.getByRole("dialog", { name: "New mission" }).waitFor();
  found.push(...(await violations(console, "new mission")));

  const { console: broken } = await begin({
    mission: "demo_c",
    prepare: (project) => project.write("demo_c.mdl", project.read("demo_c.mdl").replace("STOP", "STOPP")),
  });
  await broken.main.getByText("Show the errors").click();
  await broken.page.getByRole("list", { name: "Problems" }).waitFor();
  found.push(...(await violations(broken, "errors")));
  expect(found).toEqual([]);
});
