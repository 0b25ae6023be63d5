// The console as a person uses it: everything is found by what it is called on the page.
import type { Locator, Page } from "playwright-core";
import { expect } from "vitest";

const kRails: Record<string, string> = { Teleoperation: "Steer", Breakpoints: "Breaks" };

export class Console {
  /** What the page threw or complained of. */
  readonly troubles: string[] = [];
  /** In the top bar, always there. */
  readonly main: Locator;
  /** The large one of the Mission panel, until the mission starts. */
  readonly start: Locator;
  readonly state: Locator;
  readonly runTime: Locator;
  readonly stop: Locator;
  readonly questions: Locator;
  readonly steps: Locator;
  readonly map: Locator;
  readonly commandLine: Locator;

  constructor(readonly page: Page) {
    page.on("pageerror", (error) => this.troubles.push(String(error)));
    page.on("console", (message) => message.type() === "error" && this.troubles.push(message.text()));
    this.main = page.getByTestId("main-button");
    this.start = page.getByTestId("start-button");
    this.state = page.getByTestId("run-state");
    this.runTime = page.getByTestId("run-time");
    this.stop = page.getByTestId("emergency-stop");
    this.questions = page.getByRole("region", { name: "Questions" });
    this.steps = page.getByRole("region", { name: "Steps" });
    this.map = page.getByRole("application", { name: /^Map/ });
    this.commandLine = page.getByRole("combobox", { name: "Command line" });
  }

  button(name: string | RegExp): Locator {
    return this.page.getByRole("button", { name, ...(typeof name === "string" ? { exact: true } : {}) });
  }

  /** How many pixels the map's uppermost canvas shows. */
  drawnOnTop(): Promise<number> {
    return this.map.evaluate((host) => {
      const canvases = [...host.querySelectorAll("canvas")];
      const canvas = canvases.find((one) => one.style.zIndex === "2")!;
      if (canvas.style.display === "none") return 0;
      const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
      let drawn = 0;
      for (let i = 3; i < data.length; i += 4) if (data[i]! > 0) ++drawn;
      return drawn;
    });
  }

  /** Opens a panel where it is not open, by its button. */
  async panel(title: string): Promise<Locator> {
    const panel = this.page.getByRole("region", { name: title, exact: true });
    const button = this.page
      .getByRole("navigation", { name: /^Panels/ })
      .getByRole("button", { name: new RegExp(`^${kRails[title] ?? title}( \\d+)?$`) });
    // A page whose width has just changed may close it once more.
    await expect
      .poll(
        async () => {
          if (!(await panel.isVisible()) && (await button.getAttribute("aria-pressed")) !== "true")
            await button.click();
          return panel.isVisible();
        },
        { timeout: 60_000 },
      )
      .toBe(true);
    return panel;
  }

  /** Waits for the state of the run: `Ready`, `Running`, `Waits for you`, `Done` ... */
  async reaches(state: string, timeout = 120_000): Promise<void> {
    await this.state.filter({ hasText: state }).waitFor({ timeout });
  }

  /** By its menu: `Max`, `×1` ... */
  async setSpeed(preset: string): Promise<void> {
    await this.button(/^Speed /).click();
    const dialog = this.page.getByRole("dialog", { name: "Speed" });
    await dialog.getByRole("button", { name: preset, exact: true }).click();
    await this.page.keyboard.press("Escape");
    await dialog.waitFor({ state: "detached" });
    const shown = preset === "Max" ? /max/i : new RegExp(preset);
    await this.button(/^Speed /)
      .filter({ hasText: shown })
      .waitFor();
  }

  /** [s] */
  async time(): Promise<number> {
    const text = (await this.runTime.textContent()) ?? "";
    return text
      .replace("Run time", "")
      .split(":")
      .map(Number)
      .reduce((sum, part) => sum * 60 + part, 0);
  }

  /** Waits until so much of the mission's time has passed [s]. */
  async passes(seconds: number): Promise<void> {
    const begin = await this.time();
    await expect.poll(() => this.time(), { timeout: 60_000 }).toBeGreaterThan(begin + seconds);
  }

  /** Puts the robots on the map: the first step, and nothing after it. */
  async startRobots(): Promise<void> {
    await this.button("Step").click();
    await this.steps.getByText(/^1 of /).waitFor();
  }

  /** By the list of robots: `Robot 1`, `scouts`. */
  async select(name: string): Promise<void> {
    const panel = await this.panel("Robots");
    await this.rowOf(panel, name).click();
  }

  /** Where the list says that a robot is [m]. */
  async place(robot: string): Promise<{ x: number; y: number }> {
    const row = this.rowOf(this.page.getByRole("region", { name: "Robots", exact: true }), robot);
    const text = (await row.locator(".robot-place").textContent()) ?? "";
    const [x = Number.NaN, y = Number.NaN] = text.split(",").map(Number);
    return { x, y };
  }

  /** Of the list of robots and units. */
  rowOf(panel: Locator, name: string): Locator {
    return panel.getByRole("row").filter({ has: this.page.getByText(name, { exact: true }) });
  }

  /** The line that says that somebody else is the operator. */
  get watching(): Locator {
    return this.page.getByRole("status").filter({ hasText: "You are watching." });
  }

  /** Where the map looks, as the page keeps it over a reload; waits until it has come to rest. */
  async camera(): Promise<{ x: number; y: number; scale: number }> {
    let before = "";
    let same = 0;
    await expect
      .poll(
        async () => {
          const now = await this.page.evaluate(() => sessionStorage.getItem("mlab.view") ?? "");
          same = now === before && now !== "" ? same + 1 : 0;
          before = now;
          return same;
        },
        { interval: 100, timeout: 30_000 },
      )
      .toBeGreaterThan(3);
    return (JSON.parse(before) as { camera: { x: number; y: number; scale: number } }).camera;
  }

  /** Where a place of the world [m] is on the page. */
  async onPage(x: number, y: number): Promise<{ x: number; y: number }> {
    const camera = await this.camera();
    const box = await this.map.boundingBox();
    if (!box) throw new Error("the map is not shown");
    return {
      x: box.x + box.width / 2 + (x - camera.x) * camera.scale,
      y: box.y + box.height / 2 - (y - camera.y) * camera.scale,
    };
  }

  async clickMap(x: number, y: number): Promise<void> {
    const at = await this.onPage(x, y);
    await this.page.mouse.click(at.x, at.y);
  }

  async dragMap(from: [number, number], to: [number, number]): Promise<void> {
    const begin = await this.onPage(...from);
    const end = await this.onPage(...to);
    await this.page.mouse.move(begin.x, begin.y);
    await this.page.mouse.down();
    await this.page.mouse.move((begin.x + end.x) / 2, (begin.y + end.y) / 2, { steps: 4 });
    await this.page.mouse.move(end.x, end.y, { steps: 4 });
    await this.page.mouse.up();
  }

  /** Types a command of MDL and sends it. */
  async type(line: string): Promise<void> {
    await this.commandLine.fill(line);
    await this.page.getByText("Enter sends this to").waitFor();
    await this.commandLine.press("Enter");
    await this.page.getByText("Sent to", { exact: true }).waitFor();
  }
}
