// What each test begins with: a project folder, an mlab that serves it, a browser that shows it. All end with the test.
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, onTestFinished } from "vitest";
import { Console } from "./console.ts";
import { Mlab, missions } from "./mlab.ts";
import { kSmall, openPage } from "./open_page.ts";

/** Where a test that fails leaves what was to be seen. */
const failures =
  process.env.MLAB_FAILURES ?? join(dirname(fileURLToPath(import.meta.url)), "..", "..", "web", "pictures", "failed");

/** A folder with a copy of one of the missions that come with mlab, or an empty one. */
export class Project {
  readonly folder = mkdtempSync(join(tmpdir(), "mlab-project-"));

  constructor(mission: string) {
    if (mission !== "") cpSync(join(missions, mission), this.folder, { recursive: true });
  }

  path(name: string): string {
    return join(this.folder, name);
  }

  read(name: string): string {
    return readFileSync(this.path(name), "utf8");
  }

  write(name: string, text: string | Uint8Array): void {
    writeFileSync(this.path(name), text);
  }

  remove(): void {
    rmSync(this.folder, { recursive: true, force: true });
  }
}

interface Beginning {
  /** Name of one of the missions that come with mlab; none: the console starts without a mission. */
  mission?: string;
  options?: string[];
  /** Changes the project before mlab starts. */
  prepare?: (project: Project) => void;
  size?: { width: number; height: number };
  /** Run in the page before its own scripts. */
  before?: () => void;
}

export interface Begun {
  project: Project;
  mlab: Mlab;
  console: Console;
}

export async function begin(beginning: Beginning = {}): Promise<Begun> {
  const { mission = "", options = [], prepare, size, before } = beginning;
  const project = new Project(mission);
  onTestFinished(() => project.remove());
  prepare?.(project);
  const file = mission === "" ? [] : [project.path(`${basename(mission)}.mdl`)];
  const mlab = await Mlab.start(...file, "--project", project.folder, ...options);
  onTestFinished(async () => {
    await mlab.stop();
  });
  return { project, mlab, console: await look(mlab, size, before) };
}

/** One more browser that looks at this mlab; `before` is run before the page's own scripts. */
export async function look(mlab: Mlab, size = kSmall, before?: () => void): Promise<Console> {
  const page = await openPage(size);
  if (before) await page.addInitScript(before);
  const console = new Console(page);
  onTestFinished(async ({ task }) => {
    if (task.result?.state === "fail") {
      mkdirSync(failures, { recursive: true });
      const name = task.name.replace(/[^a-z0-9]+/gi, "_").slice(0, 80);
      await page.screenshot({ path: join(failures, `${name}.png`) }).catch(() => {});
    }
    await page.context().close();
    expect(console.troubles).toEqual([]);
  });
  await page.goto(mlab.url);
  return console;
}
