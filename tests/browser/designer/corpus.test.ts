// Configurations of the historic system, imported: every page of each is read without touching a node.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { begin, type DesignerPage } from "./designer.ts";
import { type Looked, looked } from "./looked.ts";

const corpus =
  process.env.MLAB_CORPUS ?? join(process.env.MLAB_ROOT ?? join(import.meta.dirname, "../../.."), "../shared/corpus");
const folder = join(corpus, "configurations");
const files = existsSync(folder) ? readdirSync(folder).filter((name) => name.endsWith(".cdl")) : [];

interface Seen extends Looked {
  path: string;
}

const kLookInside = ".react-flow__node .node-enter";

/** This page and all that it leads to, each once. Leads back to this page. */
async function visit(designer: DesignerPage, path: string, seen: Map<string, Seen>): Promise<void> {
  const { page } = designer;
  await designer.on(path);
  // A layout that is worked out, and what is measured of it, may come a moment later than the page.
  await expect
    .poll(async () => (await looked(designer)).over, { timeout: 5_000 })
    .toEqual([])
    .catch(() => {});
  seen.set(path, { path, ...(await looked(designer)) });
  const ways = await page.locator(kLookInside).count();
  for (let i = 0; i < ways; ++i) {
    await page.locator(kLookInside).nth(i).dispatchEvent("click");
    const away = page.locator(
      `[aria-label^="Drawing of "][aria-busy=false]:not([aria-label="Drawing of ${path || "the file"}"])`,
    );
    await away.waitFor();
    const inner = (await away.getAttribute("aria-label"))!.slice("Drawing of ".length);
    if (!seen.has(inner)) await visit(designer, inner, seen);
    await page.goBack();
    await designer.on(path);
  }
}

// Without the corpus the test is listed as skipped.
test.skipIf(files.length === 0).each(files.length === 0 ? ["no corpus"] : files)(
  "nothing lies on anything, and letters are of a size to be read: %s",
  async (file) => {
    const { designer } = await begin({
      file: "one.cdl",
      prepare: (project) => project.write("one.cdl", readFileSync(join(folder, file))),
    });
    await designer.verdict.waitFor(); // a file with one declaration opens on it
    await designer.toFile();
    const seen = new Map<string, Seen>();
    await visit(designer, "", seen);
    const pages = [...seen.values()];
    console.log(`${file}: ${pages.length} pages, ${pages.reduce((sum, one) => sum + one.nodes, 0)} nodes`);
    expect(pages.filter(({ over }) => over.length > 0).map(({ path, over }) => `${path}: ${over.join(", ")}`)).toEqual(
      [],
    );
    // At 1280 pixels, beside palette and details; but for one page they are of 8 pixels and more.
    expect(pages.filter(({ labels, font }) => labels > 0 && font < 7.5)).toEqual([]);
  },
);
