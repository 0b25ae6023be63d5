// Pictures of what other tests try: runs looked at afterwards, and robots that share out what is to be done.
import { spawnSync } from "node:child_process";
import { pathToFileURL } from "node:url";
import { describe, expect, onTestFinished, test } from "vitest";
import { begin, look, Project } from "./begin.ts";
import type { Console } from "./console.ts";
import { begin as beginDesigner } from "./designer/designer.ts";
import { Mlab } from "./mlab.ts";
import { openPage } from "./open_page.ts";
import { arePicturesWanted, picture } from "./picture.ts";

const size = { width: 1440, height: 900 };

/** Of a command of mlab. */
function mlab(...words: string[]): void {
  const { status, stderr } = spawnSync(process.env.MLAB_COMMAND ?? "mlab", words, { encoding: "utf8" });
  if (status !== 0) throw new Error(`mlab ended with ${status}:\n${stderr}`);
}

const record = (mission: string, file: string, ...options: string[]) =>
  mlab("run", mission, "--headless", "--proceed", "--quiet", "--record", file, ...options);

function projectOf(mission: string): Project {
  const project = new Project(mission);
  onTestFinished(() => project.remove());
  return project;
}

async function replayed(...options: string[]): Promise<Console> {
  const server = await Mlab.replay(...options);
  onTestFinished(async () => {
    await server.stop();
  });
  const console = await look(server, size);
  await console.page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  return console;
}

async function goTo({ page }: Console, time: string): Promise<void> {
  const field = page.getByRole("textbox", { name: "Time that is shown" });
  await field.fill(time);
  await field.press("Enter");
}

async function pageOf(file: string, name: string): Promise<void> {
  const page = await openPage(size);
  onTestFinished(() => page.context().close());
  await page.goto(pathToFileURL(file).href);
  await picture(page, name, { of: "page" });
}

describe.runIf(arePicturesWanted)("pictures", () => {
  test("a recording: any moment, and when something was so", async () => {
    const project = projectOf("demo_c");
    record(project.path("demo_c.mdl"), project.path("monday.mcap"));
    const console = await replayed(project.path("monday.mcap"));
    const { page } = console;
    await goTo(console, "3:20");
    await console.select("Robot 2");
    await page.getByRole("button", { name: "Find moments" }).click();
    const panel = page.getByRole("region", { name: "Find moments" });
    await panel.getByRole("combobox", { name: "When was it so that" }).fill("robot 2 nearer than 5 m to a robot");
    await page.keyboard.press("Enter");
    await panel.getByText(/moments? in the whole run/).waitFor();
    await picture(page, "time_line");
  });

  test("two recordings beside each other, on the map and as a page", async () => {
    const project = projectOf("demo_c");
    const files = ["a.mcap", "b.mcap"].map((name) => project.path(name));
    for (const file of files) record(project.path("demo_c.mdl"), file, "--seed", `${files.indexOf(file) + 3}`);
    const console = await replayed(files[0]!, "--against", files[1]!);
    await console.page.getByText(/They part at/).waitFor();
    await goTo(console, "3:20");
    await picture(console.page, "against");
    const words = ["compare", "a.mcap", "b.mcap", "--html", "page.html"];
    spawnSync(process.env.MLAB_COMMAND ?? "mlab", words, { cwd: project.folder }); // 1: they differ
    await pageOf(project.path("page.html"), "compare");
  });

  test("a recording on the drawing", async () => {
    const { designer } = await beginDesigner({
      mission: "forage",
      file: "forager.cdl",
      ...size,
      prepare: (project) => record(project.path("forage.mdl"), project.path("monday.mcap"), "--for", "90"),
      options: (project) => ["--recording", project.path("monday.mcap")],
    });
    const { page } = designer;
    await designer.goTo("Forage");
    await designer.button("Hide Components").click();
    const field = page.getByRole("textbox", { name: "Time that is shown" });
    await field.fill("60");
    await field.press("Enter");
    await page.locator(".state.active").filter({ hasText: "Delivering" }).waitFor();
    await picture(page, "time_line", { of: "designer" });
  });

  test("many runs as a page", async () => {
    const project = projectOf("demo_c");
    const html = project.path("page.html");
    mlab("batch", project.path("demo_c.mdl"), "--runs", "30", "--set", "base_velocity=1,2,5", "--html", html);
    await pageOf(html, "batch");
  });

  test("robots that share an area among themselves", async () => {
    const { console } = await begin({ mission: "search", size });
    const { page } = console;
    await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
    await console.main.click();
    await console.setSpeed("×20");
    await expect.poll(() => console.time(), { timeout: 60_000 }).toBeGreaterThan(100);
    await page.keyboard.press("x");
    await console.reaches("Paused");
    await picture(page, "shares");
  });
});
