// The designer as a person uses it: by what is written on the page, by mouse and keys.
import { mkdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Locator, Page } from "playwright-core";
import { expect, onTestFinished } from "vitest";
import { Project } from "../begin.ts";
import { Mlab } from "../mlab.ts";
import { openPage } from "../open_page.ts";

const failures =
  process.env.MLAB_FAILURES ??
  join(dirname(fileURLToPath(import.meta.url)), "..", "..", "..", "web", "pictures", "failed");

export class DesignerPage {
  /** What the page threw or complained of. */
  readonly troubles: string[] = [];
  private hasLeft = false;
  readonly canvas: Locator;
  readonly details: Locator;
  readonly palette: Locator;
  readonly text: Locator;
  readonly problems: Locator;
  readonly verdict: Locator;
  readonly simulator: Locator;
  readonly breakpoints: Locator;
  readonly probes: Locator;

  constructor(readonly page: Page) {
    page.on("pageerror", (error) => this.complains(String(error)));
    page.on("console", (message) => message.type() === "error" && this.complains(message.text()));
    this.canvas = page.getByRole("region", { name: /^Drawing of / });
    this.details = page.getByRole("region", { name: "Details", exact: true });
    this.palette = page.getByRole("region", { name: "Components", exact: true });
    this.text = page.getByRole("textbox", { name: "Text of the configuration" });
    this.problems = page.getByRole("region", { name: "Problems", exact: true });
    this.verdict = page.getByTestId("verdict");
    this.simulator = page.getByRole("region", { name: "Simulator", exact: true });
    this.breakpoints = page.getByRole("region", { name: "Breakpoints" });
    this.probes = page.getByRole("region", { name: "Probes" });
  }

  private complains(words: string): void {
    if (!this.hasLeft) this.troubles.push(words);
  }

  /** Closes the page of a server that went away: what it complained of, and may still do, is meant so. */
  async leave(): Promise<void> {
    this.hasLeft = true;
    this.troubles.length = 0;
    await this.page.close();
  }

  button(name: string | RegExp): Locator {
    return this.page.getByRole("button", { name, ...(typeof name === "string" ? { exact: true } : {}) });
  }

  /** A node by its name: `Noise`, `cooperate.Noise`. */
  node(name: string): Locator {
    return this.page.locator(`.react-flow__node[data-id="${name}"]`);
  }

  /** By the end of its path, which changes with what it is connected to. */
  named(name: string): Locator {
    return this.page.locator(`.react-flow__node[data-id="${name}"], .react-flow__node[data-id$=".${name}"]`).first();
  }

  input(node: Locator, row: string): Locator {
    return node.locator(`[data-handleid="${row}"].target`);
  }

  output(node: Locator): Locator {
    return node.locator('[data-handleid="out"].source');
  }

  get result(): Locator {
    return this.page.locator('.react-flow__node[data-id="$result"] .target');
  }

  /** Waits until the page of this path is drawn and stands where it is seen. */
  async on(path: string): Promise<void> {
    await this.page.locator(`[aria-label="Drawing of ${path || "the file"}"][aria-busy=false]`).waitFor();
  }

  /** From the start page to an assemblage on an empty page. */
  async newAssemblage(name: string): Promise<void> {
    await this.button("New configuration").click();
    await this.declare("Assemblage", name);
  }

  /** On the page of the file. */
  async declare(kind: "Assemblage" | "Robot" | "Society", name: string): Promise<void> {
    await this.on("");
    await this.palette.getByRole("button", { name: new RegExp(`^${kind}`) }).click();
    const dialog = this.page.getByRole("dialog");
    await dialog.getByRole("textbox", { name: "Name" }).fill(name);
    await dialog.getByRole("button", { name: "Add" }).click();
    await this.on(name);
  }

  /** By `/` and its name. */
  async place(component: string): Promise<void> {
    const before = await this.page.locator(".react-flow__node").count();
    await this.page.keyboard.press("/");
    const field = this.page.getByRole("combobox", { name: "Place a component" });
    await field.fill(component);
    await this.page.getByRole("option").first().waitFor();
    await field.press("Enter");
    await expect.poll(() => this.page.locator(".react-flow__node").count()).toBeGreaterThan(before);
  }

  /** Out of the palette, to a place of the canvas [px from its corner]. */
  async dragFromPalette(component: string, x: number, y: number): Promise<void> {
    const before = await this.page.locator(".react-flow__node").count();
    await this.palette.getByRole("searchbox").fill(component);
    const entry = this.palette.getByRole("listitem").getByRole("button").first();
    await entry.dragTo(this.page.locator(".react-flow__pane"), { targetPosition: { x, y } });
    await this.palette.getByRole("searchbox").fill("");
    await expect.poll(() => this.page.locator(".react-flow__node").count()).toBeGreaterThan(before);
  }

  /** Draws a wire with the mouse. */
  async wire(from: Locator, to: Locator): Promise<void> {
    await this.hold(from, to);
    await this.page.mouse.up();
  }

  /** Draws a wire and does not let go. */
  async hold(from: Locator, to: Locator): Promise<void> {
    const begin = await middle(from);
    await this.page.mouse.move(begin.x, begin.y);
    await this.page.mouse.down();
    const end = await middle(to);
    await this.page.mouse.move((begin.x + end.x) / 2, (begin.y + end.y) / 2, { steps: 5 });
    await this.page.mouse.move(end.x, end.y, { steps: 5 });
  }

  /** Wires are counted by what leads to them. */
  async hasWires(count: number): Promise<void> {
    await expect.poll(() => this.page.locator(".react-flow__edge").count()).toBe(count);
  }

  /** Clicks on the value in a row and types another. */
  async setValue(node: Locator, label: string, value: string): Promise<void> {
    await node.locator(".row", { hasText: label }).locator(".row-value").first().click();
    await this.typeValue(value);
  }

  async setWeight(node: Locator, member: number, value: string): Promise<void> {
    await node.locator(".row-weight").nth(member).click();
    await this.typeValue(value);
  }

  private async typeValue(value: string): Promise<void> {
    const editor = this.page.locator(".value-editor");
    await editor.getByRole("textbox").fill(value);
    await editor.getByRole("textbox").press("Enter");
    await editor.waitFor({ state: "detached" });
  }

  /** Once more where the page was still moving to its place, and the click went beside. */
  async select(node: Locator): Promise<void> {
    const selected = node
      .locator("xpath=ancestor-or-self::*[contains(concat(' ', @class, ' '), ' selected ')]")
      .first();
    const isSelected = () =>
      selected.waitFor({ timeout: 3000 }).then(
        () => true,
        () => false,
      );
    for (let i = 0; i < 5; ++i) {
      // On its name, wherever that lies at this zoom: beside it lies the way in.
      const width = (await node.boundingBox())?.width ?? 0;
      await node.click({ position: { x: 0.4 * width, y: 8 } });
      if (await isSelected()) return;
    }
    throw new Error(`is not selected after five clicks: ${await node.innerText()}`);
  }

  /** By the menu of dialogs: under a name in the project. */
  async saveAs(name: string): Promise<void> {
    await this.page.keyboard.press("Control+s");
    const dialog = this.page.getByRole("dialog");
    await dialog.getByRole("textbox", { name: "Name" }).fill(name);
    await dialog.getByRole("button", { name: "Save", exact: true }).click();
    await dialog.waitFor({ state: "detached" });
  }

  /** By Enter on its declaration in the page of the file. */
  async goTo(path: string): Promise<void> {
    await this.on("");
    await this.select(this.node(path));
    await this.page.keyboard.press("Enter");
    await this.on(path);
  }

  async toFile(): Promise<void> {
    await this.page.locator("body").press("Home");
    await this.on("");
  }

  /** From any page, by its name in the list of the file's declarations. */
  async toDeclaration(name: string): Promise<void> {
    await this.toFile();
    await this.details.getByRole("button", { name, exact: true }).click();
    await this.on(name);
    await this.page.locator(".react-flow__node").first().waitFor();
  }

  async run(): Promise<void> {
    await this.page.locator("[data-tour=run]").click();
    await this.simulator.getByText("Running", { exact: true }).waitFor();
  }
}

/** Once it stands still. */
async function middle(of: Locator): Promise<{ x: number; y: number }> {
  await (await of.elementHandle())?.waitForElementState("stable");
  const box = await of.boundingBox();
  if (!box) throw new Error(`nothing to be seen of ${of}`);
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

export interface Begun {
  project: Project;
  mlab: Mlab;
  designer: DesignerPage;
}

interface Beginning {
  /** A folder of missions that come with mlab, copied; empty: an empty project. */
  mission?: string;
  /** File of the project that is opened. */
  file?: string;
  prepare?: (project: Project) => void;
  options?: (project: Project) => string[];
  width?: number;
  height?: number;
}

export async function begin(beginning: Beginning = {}): Promise<Begun> {
  const { mission = "", file = "", prepare, options, width = 1280, height = 800 } = beginning;
  const project = new Project(mission);
  onTestFinished(() => project.remove());
  prepare?.(project);
  const more = options?.(project) ?? [];
  const mlab = await Mlab.edit([...(file ? [project.path(file)] : []), "--project", project.folder, ...more]);
  onTestFinished(async () => {
    await mlab.stop();
  });
  return { project, mlab, designer: await look(mlab.url, { width, height }) };
}

/** One more browser that looks at this designer. */
export async function look(url: string, size = { width: 1280, height: 800 }): Promise<DesignerPage> {
  const page = await openPage(size);
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  const designer = new DesignerPage(page);
  onTestFinished(async ({ task }) => {
    if (task.result?.state === "fail") {
      mkdirSync(failures, { recursive: true });
      const name = task.name.replace(/[^a-z0-9]+/gi, "_").slice(0, 80);
      await page.screenshot({ path: join(failures, `${name}.png`) }).catch(() => {});
    }
    await page.context().close();
    expect(designer.troubles).toEqual([]);
  });
  await page.goto(url);
  return designer;
}
