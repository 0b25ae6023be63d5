// Names of a project: another name everywhere, where something is used, finding on the page and everywhere.
import { expect, test } from "vitest";
import { begin, type DesignerPage } from "./designer.ts";

const kSkills = `/// Goes about.
assemblage Roam(urge: gain = 1) {
  cooperate {
    urge: Noise(persistence = 6 s);
    1: AvoidStaticObstacles();
  } as both
}
assemblage Hunt() {
  sequence {
    start Looking: Roam();
      when Wait(delay = 20 s) goto Resting;
    Resting: Stand();
      when Wait(delay = 5 s) goto Looking;
  }
}
layout Roam {
  note 0 260 "Ask Tom about the noise";
}
`;
const kRobots = `use "skills.cdl";
robot Scout(urge: gain = 0.5) {
  movement = Roam(urge = urge);
}
`;
const kMission = `NEW-ROBOT scout "robots.cdl" (urge = 0.7)
UNIT <a> scout
COMMAND LIST:
  1. UNIT a START 20 20
`;

async function project(size = { width: 1280, height: 800 }, file = "skills.cdl") {
  return begin({
    file,
    prepare: (made) => {
      made.write("skills.cdl", kSkills);
      made.write("robots.cdl", kRobots);
      made.write("m.mdl", kMission);
    },
    ...size,
  });
}

async function everything({ page }: DesignerPage, query: string) {
  await page.keyboard.press("Control+k");
  const field = page.getByRole("combobox", { name: "Search everything" });
  await field.fill(query);
  return field;
}

test("a renaming shows what changes in all files before it is done, and is taken back as a whole", async () => {
  const begun = await project();
  const { designer } = begun;
  const { page } = designer;
  await designer.on("");
  await designer.node("Roam").click();
  await page.keyboard.press("F2");
  const dialog = page.getByRole("dialog", { name: "Rename Roam" });
  await dialog.getByRole("textbox", { name: "Name" }).fill("Drift");
  await dialog.getByText("4 places in 2 files").waitFor();
  await dialog.getByRole("region", { name: "robots.cdl" }).getByText("movement =").waitFor();
  await dialog.getByText(/runs with the same seed/).waitFor();
  await page.keyboard.press("Enter");
  await page.getByText(/Renamed Roam to Drift/).waitFor();
  await designer.node("Drift").waitFor();
  expect(begun.project.read("robots.cdl")).toContain("Drift(urge = urge)");
  expect(begun.project.read("skills.cdl")).toContain("assemblage Drift(");
  await designer.button("Take back").click();
  await designer.node("Roam").waitFor();
  await expect.poll(() => begun.project.read("robots.cdl")).toBe(kRobots);
  expect(begun.project.read("skills.cdl")).toBe(kSkills);
});

test("a name that is taken is refused with the place, which is shown", async () => {
  const { designer } = await project();
  const { page } = designer;
  await designer.on("");
  await designer.node("Hunt").click();
  await page.keyboard.press("F2");
  const dialog = page.getByRole("dialog", { name: "Rename Hunt" });
  await dialog.getByRole("textbox", { name: "Name" }).fill("Roam");
  await dialog.getByText(/skills.cdl, line/).waitFor();
  expect(await dialog.getByRole("button", { name: "Rename", exact: true }).isDisabled()).toBe(true);
  await dialog.getByRole("button", { name: "Show what is in the way" }).click();
  await dialog.waitFor({ state: "detached" });
});

test("uses are listed by file, and a click goes there", async () => {
  const { designer } = await project();
  const { page } = designer;
  await designer.on("");
  await designer.node("Roam").click();
  await page.keyboard.press("Shift+F12");
  const uses = page.getByRole("region", { name: "Uses of Roam" });
  await uses.getByText("assemblage, 4 places in 2 files").waitFor();
  await uses.getByRole("button", { name: /movement = Roam/ }).click();
  await designer.on("Scout");
  await uses.getByRole("button", { name: "Hide the uses" }).click();
  await uses.waitFor({ state: "detached" });
});

test("what the text names is renamed and looked for from the text as well", async () => {
  const { designer } = await project(undefined, "robots.cdl");
  const { page } = designer;
  await page.getByRole("button", { name: "Text", exact: true }).click();
  await designer.text.getByText("urge", { exact: false }).first().waitFor();
  await designer.text
    .locator(".cm-line")
    .nth(1)
    .click({ position: { x: 95, y: 8 } });
  await page.keyboard.press("F2");
  const dialog = page.getByRole("dialog", { name: /^Rename (urge|Scout)/ });
  await dialog.getByRole("textbox", { name: "Name" }).fill("Other_Name");
  await dialog.getByRole("region", { name: "m.mdl" }).waitFor();
  await page.keyboard.press("Escape");
});

test("finding on the page marks what has the words, and goes from one to the next", async () => {
  const { designer } = await project();
  const { page } = designer;
  await designer.on("");
  await designer.node("Roam").dblclick();
  await designer.on("Roam");
  await page.keyboard.press("Control+f");
  const box = page.getByRole("textbox", { name: "Find on this page" });
  await box.fill("noise");
  await expect.poll(() => page.locator(".react-flow__node.found").count()).toBe(2);
  await box.press("Enter");
  await page.getByText("1 of 2").waitFor();
  await box.press("Enter");
  await page.getByText("2 of 2").waitFor();
  await box.fill("6 s");
  await expect.poll(() => page.locator(".react-flow__node.found").count()).toBe(1);
  await box.press("Escape");
  await box.waitFor({ state: "detached" });
  expect(await page.locator(".react-flow__node.found").count()).toBe(0);
});

test("one box finds states, parameters, files, components and commands, by keys alone", async () => {
  const { designer } = await project();
  const { page } = designer;
  await designer.on("");
  const field = await everything(designer, "resting");
  await page.getByRole("option", { name: /Resting.*state in Hunt/ }).waitFor();
  await field.press("Enter");
  await designer.on("Hunt");
  await expect.poll(() => page.locator('.react-flow__node.selected[data-id="Resting"]').count()).toBe(1);
  const files = await everything(designer, "robots");
  await page.getByRole("option", { name: /robots\.cdl/ }).waitFor();
  await files.press("Escape");
  await everything(designer, "avoid static");
  await page
    .getByRole("option", { name: /Avoid static/i })
    .first()
    .waitFor();
  await page.keyboard.press("Escape");
  await everything(designer, "undo");
  await page.getByRole("option", { name: /^Undo/ }).waitFor();
  await page.keyboard.press("Escape");
});
