// Configurations of the historic system, imported: every page is read without touching a node. A run of all tests looks at a third
// of the files, another one from commit to commit, for all of them take a browser eight minutes: MLAB_WHOLE_CORPUS=1.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { begin, type DesignerPage } from "./designer.ts";
import { type Looked, looked } from "./looked.ts";

const corpus =
  process.env.MLAB_CORPUS ?? join(process.env.MLAB_ROOT ?? join(import.meta.dirname, "../../.."), "../shared/corpus");
const folder = join(corpus, "configurations");
const files = existsSync(folder) ? readdirSync(folder).filter((name) => name.endsWith(".cdl")) : [];
const kShares = process.env.MLAB_WHOLE_CORPUS ? 1 : 3;
const seed = Number(/seed=(\d+)/.exec(process.env.RC_PARAMS ?? "")?.[1] ?? 0); // of this commit
const filesOfThisRun = files.filter((_, i) => i % kShares === seed % kShares);

interface Seen extends Looked {
  path: string;
}

const kLookInside = ".react-flow__node .node-enter";

/** By the address, as a link leads there. */
async function goTo(designer: DesignerPage, file: string, path: string): Promise<void> {
  const place = new URLSearchParams({ file, page: path });
  await designer.page.evaluate((fragment) => {
    window.location.hash = fragment;
  }, file && place.toString());
}

/** This page and all that it leads to, each once. */
async function visit(designer: DesignerPage, file: string, path: string, seen: Map<string, Seen>): Promise<void> {
  const { page } = designer;
  await designer.on(path);
  // A layout that is worked out, and what is measured of it, may come a moment later than the page.
  await expect
    .poll(async () => (await looked(designer)).over, { timeout: 5_000 })
    .toEqual([])
    .catch(() => {});
  seen.set(path, { path, ...(await looked(designer)) });
  const placesOf = (all: Element[]) => all.map((one) => ({ ...(one as HTMLElement).dataset }));
  for (const inner of await page.locator(kLookInside).evaluateAll(placesOf)) {
    if (seen.has(inner.page!)) continue;
    await goTo(designer, inner.file || file, inner.page!);
    await visit(designer, inner.file || file, inner.page!, seen);
  }
}

/** What is wrong with the pages of a file, in words. */
async function faults(designer: DesignerPage, file: string): Promise<string[]> {
  await goTo(designer, "", "");
  await designer.canvas.waitFor({ state: "detached" });
  await goTo(designer, file, "");
  await designer.verdict.waitFor(); // a file with one declaration opens on it
  await designer.toFile();
  const seen = new Map<string, Seen>();
  await visit(designer, file, "", seen);
  const pages = [...seen.values()];
  console.log(`${file}: ${pages.length} pages, ${pages.reduce((sum, one) => sum + one.nodes, 0)} nodes`);
  const where = (path: string) => `${file}, ${path || "the file"}`;
  return [
    ...pages.filter(({ over }) => over.length > 0).map(({ path, over }) => `${where(path)}: ${over.join(", ")}`),
    // At 1280 pixels, beside palette and details; but for one page they are of 8 pixels and more.
    ...pages
      .filter(({ labels, font }) => labels > 0 && font < 7.5)
      .map(({ path, font }) => `${where(path)}: letters of ${font} px`),
  ];
}

// In one page, one file after the other: to load a page costs as much as to draw ten. Without the corpus listed as skipped.
test.skipIf(files.length === 0)(
  "nothing lies on anything, and letters are of a size to be read",
  async () => {
    const { designer } = await begin({
      prepare: (project) => {
        for (const file of files) project.write(file, readFileSync(join(folder, file)));
      },
    });
    await designer.button("New configuration").waitFor();
    const found: string[] = [];
    for (const file of filesOfThisRun) found.push(...(await faults(designer, file)));
    expect(found).toEqual([]);
  },
  1_800_000,
);
