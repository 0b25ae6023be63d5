// Typed lines, newest last, kept over reloads.

const kKey = "mlab.typed";
const kMost = 200;

export function readHistory(storage: Storage): string[] {
  try {
    const stored: unknown = JSON.parse(storage.getItem(kKey) ?? "[]");
    return Array.isArray(stored) ? stored.filter((line): line is string => typeof line === "string").slice(-kMost) : [];
  } catch {
    return [];
  }
}

/** The same line is kept once, where it was used last. */
export function withLine(history: readonly string[], line: string): string[] {
  const trimmed = line.trim();
  return trimmed === "" ? [...history] : [...history.filter((one) => one !== trimmed), trimmed].slice(-kMost);
}

export function keepHistory(storage: Storage, history: readonly string[]): void {
  try {
    storage.setItem(kKey, JSON.stringify(history));
  } catch {
    // A full or forbidden storage: the lines are there until the page is left.
  }
}

/** Going back and forth, among lines that begin with what was typed before. */
export class Recall {
  private at: number;
  constructor(
    private readonly history: readonly string[],
    readonly typed: string,
  ) {
    this.at = history.length;
  }

  /** The line before or after; nothing: there is none. */
  step(direction: -1 | 1): string | undefined {
    for (let i = this.at + direction; i >= 0 && i < this.history.length; i += direction) {
      const line = this.history[i] as string;
      if (!line.toLowerCase().startsWith(this.typed.toLowerCase())) continue;
      this.at = i;
      return line;
    }
    if (direction < 0 || this.at === this.history.length) return undefined;
    this.at = this.history.length;
    return this.typed;
  }
}
