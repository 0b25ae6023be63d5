// The way to the page that is shown: through the pages from which one went inside, then where it stands in its file.

import { declarationOf } from "./pages.ts";
import type { Drawing } from "./protocol.ts";

export interface Crumb {
  readonly document: string;
  readonly page: string;
  readonly title: string;
}

/** From the file to the page that is shown, which is the last. What has gone from the file is left out. */
export function crumbsOf(
  trail: readonly Crumb[],
  drawing: Drawing | undefined,
  document: string,
  declared: ReadonlySet<string>,
): Crumb[] {
  const way = (drawing?.way ?? []).map(
    (page, i): Crumb => ({
      document: page.document || document,
      page: page.path,
      title: drawing?.wayTitles[i] || (page.path === "" ? "File" : page.path),
    }),
  );
  const kept = trail.filter(
    (one) => one.document !== document || one.page === "" || declared.has(declarationOf(one.page)),
  );
  if (kept.length === 0) return way;
  return [...kept, ...way.filter((one) => one.page !== "" && !kept.some((before) => isSame(before, one)))];
}

/** What is left of the way for a page that is gone to without going inside of anything: a step back shortens it. */
export function shortened(trail: readonly Crumb[], document: string, page: string): readonly Crumb[] {
  const at = trail.findIndex((one) => one.document === document && one.page === page);
  return at < 0 ? [] : trail.slice(0, at);
}

function isSame(a: Crumb, b: Crumb): boolean {
  return a.document === b.document && a.page === b.page;
}
