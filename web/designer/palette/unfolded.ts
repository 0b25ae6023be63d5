// Which groups of the palette somebody has folded or unfolded: kept over reloads.

const kKey = "mlab.designer.groups";

/** By name; a group that is not there is as at first. */
export type Unfolded = Readonly<Record<string, boolean>>;

export function readUnfolded(storage: Storage): Unfolded {
  try {
    const stored: unknown = JSON.parse(storage.getItem(kKey) ?? "{}");
    if (typeof stored !== "object" || stored === null) return {};
    return Object.fromEntries(Object.entries(stored).filter(([, isOpen]) => typeof isOpen === "boolean"));
  } catch {
    return {};
  }
}

export function keepUnfolded(storage: Storage, unfolded: Unfolded): void {
  try {
    storage.setItem(kKey, JSON.stringify(unfolded));
  } catch {
    // A full or forbidden storage: groups are as at first after a reload.
  }
}
