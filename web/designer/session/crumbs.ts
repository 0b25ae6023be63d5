// The way to the page that is shown: through the pages from which one went inside, then where it stands in its file.

import { declarationOf } from "./pages.ts";
import type { Drawing } from "./protocol.ts";
import { drawingOf, type State } from "./state.ts";
import { titleOf } from "./titles.ts";

export interface Crumb {
  readonly document: string;
  readonly page: string;
  readonly title: string;
}

/** The way to the page that is shown. */
export function crumbsIn(state: State): Crumb[] {
  const declared = new Set(state.documents[state.document]?.declarations.map((one) => one.name) ?? []);
  const file = { document: state.document, page: "", title: "" };
  const crumbs = crumbsOf(state.trail, drawingOf(state), state.document, declared);
  // A page that has gone stands nowhere. What a document without a file declares is not said twice on the way.
  return (crumbs.length > 0 ? crumbs : [file]).map((one) => {
    const title = state.documents[one.document]?.title ?? "";
    return one.page === "" ? { ...one, title: title.endsWith(".cdl") ? title : titleOf(one.document) } : one;
  });
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
export function shortenedTrail(trail: readonly Crumb[], document: string, page: string): readonly Crumb[] {
  const at = trail.findIndex((one) => one.document === document && one.page === page);
  return at < 0 ? [] : trail.slice(0, at);
}

function isSame(a: Crumb, b: Crumb): boolean {
  return a.document === b.document && a.page === b.page;
}
