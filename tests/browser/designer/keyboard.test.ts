// The wander of Figure 4 by somebody who has no mouse: built, wired, run and saved with keys alone, and the focus is
// always on something that can be seen.
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { begin, type DesignerPage } from "./designer.ts";

const kWander = `assemblage Wander(curious: gain = 0.8, cautious: gain = 0.5) {
  let sense_obstacles = sense_obstacles(range = 2 m);
  cooperate {
    curious: Noise(persistence = 10 s);
    cautious: AvoidStaticObstacles(readings = sense_obstacles, sphere = 1 m);
    curious: Probe(readings = sense_obstacles);
  }
}
`;

/** What has the focus: its name, or what is written on it. */
function focused(page: Page): Promise<string> {
  return page.evaluate(() => {
    const at = document.activeElement;
    if (!at || at === document.body) return "";
    const label = at.id ? document.querySelector(`label[for="${at.id}"]`)?.textContent : "";
    return at.getAttribute("aria-label") ?? (label || (at.textContent ?? ""));
  });
}

async function reach(page: Page, key: string, wanted: RegExp, most = 60): Promise<void> {
  const seen: string[] = [];
  for (let i = 0; i < most; ++i) {
    await page.keyboard.press(key);
    const now = await focused(page);
    if (wanted.test(now)) return;
    seen.push(now.slice(0, 30));
  }
  throw new Error(`${key} does not reach ${wanted}: ${seen.join(" | ")}`);
}

/** Of the drawing's nodes, from the last that had the focus: those behind it, else those before it. */
async function reachNode(page: Page, wanted: RegExp): Promise<void> {
  const nodes = await page.locator(".react-flow__node").count();
  await reach(page, "Tab", wanted, nodes).catch(() => reach(page, "Shift+Tab", wanted, 2 * nodes));
}

async function isOnCanvas({ page }: DesignerPage): Promise<void> {
  await expect
    .poll(() => page.evaluate(() => document.activeElement?.matches(".canvas, .canvas .react-flow__node") ?? false))
    .toBe(true);
}

async function select(designer: DesignerPage, name: RegExp): Promise<void> {
  const { page } = designer;
  await reach(page, "F6", /^Drawing of|, /, 8);
  if (!name.test(await focused(page))) await reachNode(page, name);
  await expect.poll(() => page.getByTestId("selected").textContent()).toMatch(name);
}

async function setField(designer: DesignerPage, name: RegExp, value: string): Promise<void> {
  const { page } = designer;
  await reach(page, "F6", /^Details content$/, 8);
  await reach(page, "Tab", name);
  await page.keyboard.press("Control+a");
  await page.keyboard.type(value);
  await page.keyboard.press("Enter");
}

test("the wander of Figure 4 is built, run and saved without a mouse", async () => {
  const { designer, project } = await begin();
  const { page } = designer;
  await designer.button("New configuration").waitFor();
  await reach(page, "Tab", /^New configuration$/);
  await page.keyboard.press("Enter");
  await designer.on("");
  await isOnCanvas(designer);
  await reach(page, "Tab", /^New assemblage$/);
  await page.keyboard.press("Enter");
  await page.getByRole("dialog").getByRole("textbox", { name: "Name" }).waitFor();
  await page.keyboard.type("Wander");
  await page.keyboard.press("Enter");
  await designer.on("Wander");
  await isOnCanvas(designer);

  for (const [name, value] of [
    ["curious", "0.8"],
    ["cautious", "0.5"],
  ]) {
    await reach(page, "F6", /^Details content$/, 8);
    await reach(page, "Tab", /^Add a parameter$/);
    await page.keyboard.press("Enter");
    await reach(page, "Tab", /^Name$/);
    await page.keyboard.type(name!);
    await reach(page, "Tab", /^Default$/);
    await page.keyboard.type(value!);
    await page.keyboard.press("Enter"); // a field's Enter is the dialog's button
    await page.getByRole("dialog").waitFor({ state: "detached" });
    await expect.poll(() => focused(page)).toBe("Add a parameter");
  }

  for (const component of ["Noise", "AvoidStaticObstacles", "Probe", "sense_obstacles", "cooperate"]) {
    await designer.place(component);
  }
  await reach(page, "Shift+F6", /^Drawing of|, /, 8);

  const connect = async (from: RegExp, to: string) => {
    const before = await page.locator(".react-flow__edge").count();
    await select(designer, from);
    await page.keyboard.press("c");
    await page.getByRole("combobox").waitFor();
    await page.keyboard.type(to);
    await page.getByRole("option").first().waitFor();
    await page.keyboard.press("Enter");
    await designer.hasWires(before + 1);
  };
  await connect(/sense_obstacles/, "AvoidStaticObstacles readings");
  await connect(/sense_obstacles/, "Probe readings");
  await connect(/^Noise/, "cooperate new member");
  await connect(/AvoidStaticObstacles/, "cooperate new member");
  await connect(/^(?!.*cooperate).*Probe/, "cooperate new member");
  await connect(/cooperate, cooperation|^cooperate/, "Result");

  await select(designer, /sense_obstacles/);
  await setField(designer, /^range/, "2 m");
  await select(designer, /Noise/);
  await setField(designer, /^persistence/, "10 s");
  await select(designer, /AvoidStaticObstacles/);
  await setField(designer, /^sphere/, "1 m");
  await select(designer, /cooperate, cooperation|^cooperate/);
  for (const [member, weight] of [
    [1, "curious"],
    [2, "cautious"],
    [3, "curious"],
  ] as const) {
    await setField(designer, new RegExp(`^[Ww]eight of member ${member}`), weight);
  }
  await expect.poll(() => designer.verdict.textContent()).not.toMatch(/error/);

  await page.keyboard.press("Control+s");
  await page.getByRole("dialog").getByRole("textbox", { name: "Name" }).waitFor();
  await page.keyboard.press("Control+a");
  await page.keyboard.type("wander");
  await page.keyboard.press("Enter");
  await page.getByRole("dialog").waitFor({ state: "detached" });
  await expect.poll(() => project.read("wander.cdl").split("\nlayout ")[0]).toBe(kWander);

  await page.keyboard.press("F9");
  await page.getByText("Running", { exact: true }).waitFor();
  expect(await focused(page)).not.toBe("");
});

test("F6 leads to every pane and on from it, also out of the text", async () => {
  const { designer } = await begin({ mission: "forage", file: "forager.cdl", width: 1600 });
  const { page } = designer;
  await designer.on("");
  for (const key of ["t", "p"]) await page.keyboard.press(key);
  await designer.text.waitFor();
  await designer.problems.waitFor();
  await isOnCanvas(designer);
  const way: string[] = [];
  for (let i = 0; i < 7; ++i) {
    await page.keyboard.press("F6");
    way.push(await focused(page));
  }
  const panes = [
    /^Text of the configuration/,
    /^Details content/,
    /^Problems content/,
    /^Components/,
    /^Menu/,
    /^Components content/,
    /^Drawing of the file/,
  ];
  for (const [i, pane] of panes.entries()) expect(way[i]).toMatch(pane);
});
