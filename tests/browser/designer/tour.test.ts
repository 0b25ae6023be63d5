// The tour of docs/designer.md, step by step. MLAB_TOUR=FOLDER also writes its pictures there (`npm run tour`).
import { expect, test } from "vitest";
import { atRest } from "../at_rest.ts";
import { picture } from "../picture.ts";
import { begin, type DesignerPage } from "./designer.ts";

const shot = (designer: DesignerPage, name: string, pointerStays = false) =>
  picture(designer.page, name, { of: "designer", pointerStays });

test("the start page offers a tour, a new configuration, and what there is", async () => {
  const { designer } = await begin({ mission: "forage" });
  await designer.button("Guided first tour").waitFor();
  await designer.page.getByRole("region", { name: "Examples" }).getByRole("button").first().waitFor();
  await shot(designer, "start");
});

test("the guided tour leads from an empty canvas to a skill that can run, by the names that it says", async () => {
  const { designer } = await begin();
  const { page } = designer;
  const card = page.getByRole("region", { name: "Guided tour" });
  await designer.button("Guided first tour").click();
  await card.getByRole("heading", { name: "A first skill" }).waitFor();
  await shot(designer, "tour");
  await designer.declare("Assemblage", "Wander");
  await card.getByRole("heading", { name: "Three motor schemas" }).waitFor();
  await designer.dragFromPalette("Noise", 330, 60);
  await designer.dragFromPalette("AvoidStaticObstacles", 330, 190);
  await designer.dragFromPalette("Probe", 330, 360);
  await card.getByRole("heading", { name: "An operator" }).waitFor();
  await designer.dragFromPalette("cooperate", 600, 120);
  await card.getByRole("heading", { name: "Wires" }).waitFor();
  const sum = designer.named("cooperate");
  await designer.hold(designer.output(designer.named("Noise")), designer.input(sum, "members"));
  await sum.locator(".row.fits").first().waitFor();
  await shot(designer, "wire", true);
  await page.mouse.up();
  await designer.hasWires(1);
  await designer.wire(designer.output(designer.named("AvoidStaticObstacles")), designer.input(sum, "members"));
  await designer.hasWires(2);
  await designer.wire(designer.output(designer.named("Probe")), designer.input(sum, "members"));
  await card.getByRole("heading", { name: "Eyes" }).waitFor();
  await designer.dragFromPalette("sense_obstacles", 110, 300);
  const sensor = () => designer.output(designer.named("sense_obstacles"));
  await designer.wire(sensor(), designer.input(designer.named("AvoidStaticObstacles"), "readings"));
  await designer.hasWires(4);
  await designer.wire(sensor(), designer.input(designer.named("Probe"), "readings"));
  await card.getByRole("heading", { name: "The result" }).waitFor();
  // It stood outside of the canvas: the step brings it into sight, and the card gets out of its way.
  await expect.poll(() => isFree(designer)).toBe(true);
  await atRest(() => designer.result.boundingBox());
  await designer.wire(designer.output(sum), designer.result);
  await card.getByRole("heading", { name: "Values" }).waitFor();
  await card.getByRole("button", { name: "Next" }).click();
  await card.getByRole("heading", { name: "Run" }).waitFor();
  await card.getByRole("button", { name: "Finish" }).click();
  await card.waitFor({ state: "detached" });
});

/** Whether Result is whole on the canvas, and the card of the tour lies on none of it. */
function isFree({ page }: DesignerPage): Promise<boolean> {
  return page.evaluate(() => {
    const box = (selector: string) => document.querySelector(selector)!.getBoundingClientRect();
    const [result, canvas] = [box('.react-flow__node[data-id="$result"]'), box(".canvas")];
    const card = box(".tour-card");
    const isApart =
      result.right < card.left || result.left > card.right || result.bottom < card.top || result.top > card.bottom;
    return isApart && result.left >= canvas.left && result.right <= canvas.right && result.bottom <= canvas.bottom;
  });
}

test("the tour begins on an empty page, also from the menu, and waits at steps that were done before", async () => {
  const { designer } = await begin({ mission: "forage", file: "forager.cdl" });
  const { page } = designer;
  await designer.toFile();
  await page.getByRole("button", { name: "Menu", exact: true }).click();
  await page.getByRole("menuitem", { name: "Guided first tour" }).click();
  const card = page.getByRole("region", { name: "Guided tour" });
  await card.getByRole("heading", { name: "A first skill" }).waitFor();
  await page.getByText("An empty configuration").waitFor();
  await designer.declare("Assemblage", "Wander");
  await card.getByRole("heading", { name: "Three motor schemas" }).waitFor();
  await card.getByRole("button", { name: "Back" }).click();
  await card.getByText("Done", { exact: true }).waitFor();
  await page.waitForTimeout(800);
  await card.getByRole("heading", { name: "A first skill" }).waitFor();
  await card.getByRole("button", { name: "Next" }).click();
  await card.getByRole("heading", { name: "Three motor schemas" }).waitFor();
});

test("the pages of the forage example", async () => {
  const { designer } = await begin({ mission: "forage", file: "forager.cdl" });
  const { page } = designer;
  await designer.toFile();
  await page.locator(".react-flow__node").first().waitFor();
  await shot(designer, "file");
  await designer.details.getByRole("button", { name: "Wander", exact: true }).click();
  await designer.on("Wander");
  await designer.select(designer.named("Probe"));
  await shot(designer, "dataflow");
  await page.locator(".row-value").first().click();
  await page.locator(".value-editor").waitFor();
  await shot(designer, "value", true);
  await page.keyboard.press("Escape");
  await page.locator("body").press("/");
  await page.getByRole("combobox", { name: "Place a component" }).fill("goal");
  await shot(designer, "search");
  await page.keyboard.press("Escape");
  await designer.toDeclaration("Forage");
  await designer.node("Searching").waitFor();
  await designer.select(designer.node("Searching"));
  await shot(designer, "states");
  await designer.toDeclaration("Forager");
  await shot(designer, "robot");
  await designer.toDeclaration("Collector");
  await designer.select(designer.node("base"));
  await shot(designer, "class");
  await designer.toDeclaration("Foragers");
  await shot(designer, "society");
  expect(designer.troubles).toEqual([]);
});

test("text beside the drawing, with what is wrong", async () => {
  const { designer } = await begin({
    mission: "forage",
    file: "forager.cdl",
    width: 1600,
    height: 900,
    prepare: (project) =>
      project.write(
        "forager.cdl",
        project.read("forager.cdl").replace("Noise(persistence = 12 s)", "Nosie(persistence = 12 s)"),
      ),
  });
  await designer.toDeclaration("Wander");
  if (!(await designer.text.isVisible())) await designer.button("Text").click();
  await designer.verdict.click();
  await designer.problems.getByRole("button", { name: /Nosie/ }).first().click();
  await designer.problems.getByRole("button", { name: "Write “Noise”" }).waitFor();
  await shot(designer, "text");
});

test("robots run what is drawn: the states of the one that is selected glow, wires show their values", async () => {
  const { designer } = await begin({ mission: "forage", file: "forager.cdl", width: 1600, height: 900 });
  const { page } = designer;
  await designer.toDeclaration("Forage");
  await designer.button("Hide Components").click();
  await page.locator("[data-tour=run]").click();
  await page.locator(".state.active").first().waitFor();
  // Until a robot has found something.
  await expect
    .poll(() => page.locator(".state.active .state-name").allTextContents(), { timeout: 60_000 })
    .not.toContain("Searching");
  await designer.button("Pause").click();
  await page.getByText("Paused", { exact: true }).first().waitFor();
  await page.locator(".state.active").first().waitFor();
  await shot(designer, "live_states");
  await designer.toDeclaration("Wander");
  await designer.button("Go on").click();
  await page.locator(".wire-label.live .live-arrow").first().waitFor();
  await designer.select(designer.named("cooperate"));
  await page.locator(".node.active").first().waitFor();
  await designer.button("Pause").click();
  await page.getByText("Paused", { exact: true }).first().waitFor();
  await shot(designer, "live");
});

test("dark colours, and the sheet of shortcuts", async () => {
  const { designer } = await begin({ mission: "forage", file: "forager.cdl", width: 1600, height: 900 });
  await designer.page.emulateMedia({ colorScheme: "dark" });
  await designer.toDeclaration("Forage");
  await designer.node("Searching").waitFor();
  await shot(designer, "dark");
  await designer.page.locator("body").press("?");
  await designer.page.getByRole("dialog", { name: "Keyboard shortcuts" }).waitFor();
  await shot(designer, "shortcuts");
});
