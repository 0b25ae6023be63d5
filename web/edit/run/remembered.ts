// What this tab has tried, over a reload of the page; of another run of the server it means nothing.
import type { LastTrial } from "./live_state.ts";

const kKey = "mlab.designer.tried";

export function remember(storage: Storage, server: string, tried: LastTrial): void {
  try {
    storage.setItem(kKey, JSON.stringify({ ...tried, revision: String(tried.revision), server }));
  } catch {
    // A full or forbidden storage: what runs looks like somebody else's after a reload.
  }
}

/** `setup`: what is set now, which is what was tried as far as anybody knows. */
export function remembered(storage: Storage, server: string, setup: string): LastTrial | null {
  try {
    const stored: unknown = JSON.parse(storage.getItem(kKey) ?? "null");
    if (typeof stored !== "object" || stored === null) return null;
    const { document, revision, mission, notes, server: of } = stored as Record<string, unknown>;
    if (of !== server || typeof document !== "string" || typeof mission !== "string") return null;
    if (typeof revision !== "string" || !/^\d+$/.test(revision) || !Array.isArray(notes)) return null;
    const texts = notes.filter((one) => typeof one === "string");
    return { document, revision: BigInt(revision), setup, mission, notes: texts };
  } catch {
    return null;
  }
}
