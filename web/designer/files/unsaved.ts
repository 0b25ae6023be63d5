// What was opened lately, on the start page: first what has no file yet, of this page and of earlier ones.
import { shownPath } from "../../ui/files/paths.ts";
import type { Document } from "../session/protocol.ts";
import { isNew } from "../session/titles.ts";

export interface Entry {
  path: string;
  title: string;
  about: string;
}

/** Where it is, and whether this page has changes of it that are not saved. */
export function shownPlace({ path }: Entry, documents: Readonly<Record<string, Document>>): string {
  const isChanged = !isNew(path) && documents[path]?.isDirty === true;
  return isChanged ? `${shownPath(path)}, with changes that are not saved` : shownPath(path);
}

export function recentEntries(recent: readonly Entry[], documents: Readonly<Record<string, Document>>): Entry[] {
  const unsaved = new Map(recent.filter(({ path }) => isNew(path)).map((entry) => [entry.path, entry]));
  for (const { path, title, isDirty } of Object.values(documents)) {
    if (!isNew(path)) continue;
    if (isDirty) unsaved.set(path, { path, title, about: unsaved.get(path)?.about ?? "" });
    else unsaved.delete(path);
  }
  return [...unsaved.values(), ...recent.filter(({ path }) => !isNew(path))];
}
