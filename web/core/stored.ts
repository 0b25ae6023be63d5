// What a browser keeps over reloads: it may be of another version, or anything at all.

export function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** An empty one where what is kept is none, or nothing. */
export function readRecord(text: string | null): Record<string, unknown> {
  try {
    const stored: unknown = JSON.parse(text ?? "{}");
    return isRecord(stored) ? stored : {};
  } catch {
    return {};
  }
}
