import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("an overlay is drawn on an empty map, the mission written beside it, and both run and saved", async () => {
  const { console, project } = await begin();
  const { page } = console;
  await page.getByRole("heading", { name: "Which mission?" }).waitFor();
  await console.button("New mission").click();
  const dialog = page.getByRole("dialog", { name: "New mission" });
  await dialog.getByLabel("Name").fill("first");
  await dialog.getByRole("button", { name: "Create" }).click();
  await dialog.waitFor({ state: "detached" });

  const draw = await console.panel("Draw");
  await draw.getByLabel("Width, west to east [m]").fill("400");
  await draw.getByLabel("Width, west to east [m]").press("Enter");
  await draw.getByLabel("Height, south to north [m]").fill("300");
  await draw.getByLabel("Height, south to north [m]").press("Enter");
  await console.button(/^Undo set the mission area/).waitFor();
  await console.button("Fit the whole map").click();

  const name = async (label: RegExp, text: string) => {
    const form = draw.getByRole("region", { name: label });
    await form.getByLabel("Name").fill(text);
    await form.getByLabel("Name").press("Enter");
    await draw.getByRole("option", { name: text }).waitFor();
  };
  await draw.getByRole("button", { name: "Assembly area" }).click();
  await console.dragMap([80, 100], [120, 100]);
  await name(/^Assembly area/, "AA-Start");
  await draw.getByRole("button", { name: "Objective" }).click();
  await console.dragMap([300, 200], [330, 200]);
  await name(/^Objective/, "OBJ-Goal");
  await draw.getByRole("button", { name: "Phase line" }).click();
  await console.clickMap(200, 40);
  await console.clickMap(200, 260);
  await page.keyboard.press("Enter");
  await draw.getByRole("region", { name: /^Phase line/ }).waitFor();
  await page.keyboard.press("Escape");

  const text = await console.panel("Text");
  const editor = text.getByRole("textbox", { name: /^Text of first\.mdl/ });
  await editor.waitFor();
  await editor.click();
  await page.keyboard.press("Control+a");
  const mission = [
    'MISSION NAME "First"',
    'SCENARIO "First"',
    "OVERLAY first.odl",
    "UNIT <team> (ROBOT ROBOT)",
    "COMMAND LIST:",
    "0. UNIT team START AA-Start",
    "1. UNIT team MOVETO OBJ-Goal",
    "2. UNIT team STOP",
  ].join("\n");
  await page.keyboard.insertText(mission);
  await console.panel("Mission");
  await console.steps.getByText("0 of 3 done").waitFor();
  await console.setSpeed("Max");
  await console.main.click();
  await console.reaches("Done");
  await page.keyboard.press("Control+s");
  await console.button("Not saved").waitFor({ state: "detached" });
  expect(project.read("first.mdl")).toContain("UNIT team MOVETO OBJ-Goal");
  expect(project.read("first.odl")).toMatch(/^AA AA-Start 80 100 80$/m);
  expect(project.read("first.odl")).toMatch(/^OBJ OBJ-Goal 300 200 60$/m);
  expect(project.read("first.odl")).toMatch(/PL \S+ 200 40 200 260/);
});

test("an example opens from the start page, and is saved as a copy", async () => {
  const { console, project } = await begin();
  const { page } = console;
  await page
    .getByRole("region", { name: "Examples" })
    .getByRole("button")
    .filter({ hasText: "demo_c" })
    .first()
    .click();
  await console.reaches("Ready");
  const world = await console.panel("World");
  await world.getByRole("option").first().click();
  await world.getByRole("button", { name: "Remove" }).click();
  await console.button(/^Undo remove/).waitFor();
  await page.keyboard.press("Control+s");
  const dialog = page.getByRole("dialog", { name: /^Save .* as$/ });
  await dialog.getByLabel("Name").fill("mine");
  await dialog.getByRole("button", { name: "Save", exact: true }).click();
  await dialog.waitFor({ state: "detached" });
  expect(project.read("mine.odl")).toContain("OBSTACLE");
});
