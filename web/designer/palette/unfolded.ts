// Which groups of the palette somebody has folded or unfolded: kept over reloads.
import { readRecord } from "../../core/stored.ts";

const kKey = "mlab.designer.groups";

/** By name; a group that is not there is as at first. */
export type UnfoldedGroups = Readonly<Record<string, boolean>>;

export function readUnfolded(storage: Storage): UnfoldedGroups {
  const stored = Object.entries(readRecord(storage.getItem(kKey)));
  return Object.fromEntries(stored.filter((entry): entry is [string, boolean] => typeof entry[1] === "boolean"));
}

export function keepUnfolded(storage: Storage, unfolded: UnfoldedGroups): void {
  try {
    storage.setItem(kKey, JSON.stringify(unfolded));
  } catch {
    // A full or forbidden storage: groups are as at first after a reload.
  }
}
