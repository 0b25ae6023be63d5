// No violation that axe knows, in every view, light and dark.
import { expect, test } from "vitest";
import { begin } from "./begin.ts";
import type { Console } from "./console.ts";
import { violations } from "./violations.ts";

const panels = [
  "Mission",
  "Robots",
  "Draw",
  "World",
  "Selection",
  "Teleoperation",
  "Failsafes",
  "Breakpoints",
  "View",
  "Log",
  "Text",
  "Plots",
];

const kRows = "FAILSAFE IN-CONTACT AFTER 100 CONTINUE\nFAILSAFE FOR ROBOT STUCK AFTER 500 HOLD\n";

async function theme(console: Console, name: "light" | "dark"): Promise<void> {
  const view = await console.panel("View");
  await view.getByRole("radio", { name: name === "light" ? "Light" : "Dark", exact: true }).click();
  await console.page.locator(`[data-theme=${name}]`).first().waitFor();
}

for (const colours of ["light", "dark"] as const) {
  test(`every panel of a running mission is accessible, ${colours}`, async () => {
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
      found.push(...(await violations(console.page, panel, colours)));
    }
    for (const tab of ["Why?", "Parameters", "Ports"]) {
      const selection = await console.panel("Selection");
      await selection.getByRole("tab", { name: tab }).click();
      found.push(...(await violations(console.page, tab, colours)));
    }
    const failsafes = await console.panel("Failsafes");
    await failsafes.getByText("What it means").first().click();
    await failsafes.getByRole("button", { name: "Try it" }).click();
    await failsafes.getByRole("list", { name: "What happens" }).waitFor();
    found.push(...(await violations(console.page, "what if", colours)));
    await console.page.keyboard.press("Control+k");
    await console.page.getByRole("dialog", { name: "Search everything" }).waitFor();
    found.push(...(await violations(console.page, "palette", colours)));
    await console.page.keyboard.press("Escape");
    await console.page.keyboard.press("Control+.");
    await console.reaches("Emergency stop");
    found.push(...(await violations(console.page, "stopped", colours)));
    expect(found).toEqual([]);
  });
}

test("the start page, its dialogs and the page of a mission with errors are accessible", async () => {
  const { console } = await begin();
  const { page } = console;
  await page.getByRole("heading", { name: "Which mission?" }).waitFor();
  const found = await violations(page, "start");
  await console.button("New mission").click();
  await page.getByRole("dialog", { name: "New mission" }).waitFor();
  found.push(...(await violations(page, "new mission")));

  const { console: broken } = await begin({
    mission: "demo_c",
    prepare: (project) => project.write("demo_c.mdl", project.read("demo_c.mdl").replace("STOP", "STOPP")),
  });
  await broken.main.getByText("Show the errors").click();
  await broken.page.getByRole("list", { name: "Problems" }).waitFor();
  found.push(...(await violations(broken.page, "errors")));
  expect(found).toEqual([]);
});
