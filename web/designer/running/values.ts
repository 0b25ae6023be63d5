// What runs now, as the drawing shows it: the value of every wire and node output, which states are active, which
// transitions have just been made. Empty while nothing runs. Who shows one value hears of its changes and of no others.

export interface LiveValue {
  /** As a person reads it, with its unit. */
  readonly text: string;
  /** Where it is a number (or a flag: 0 or 1). */
  readonly number?: number;
  /** Where it is a vector, robot frame, share of full strength. */
  readonly vector?: { readonly x: number; readonly y: number };
  /** The last moments of the number, oldest first. */
  readonly trace?: readonly number[];
  /** Of a state: it is the one. Of a node: it fired in this cycle. */
  readonly isActive?: boolean;
  /** Somebody holds it at this value, whatever its node computes. */
  readonly isHeld?: boolean;
  /** Number of times that it happened; a change flashes (transitions). */
  readonly times?: number;
}

/** By page (as in `Drawing.page.path`) and the `live` of what is drawn on it. */
export function liveKey(page: string, live: string): string {
  return `${page}|${live}`;
}

export class LiveValues {
  private values: ReadonlyMap<string, LiveValue> = new Map();
  /** What runs, while something else is shown in its place. */
  private ofRun: ReadonlyMap<string, LiveValue> = new Map();
  private isInstead = false;
  private readonly listeners = new Map<string, Set<() => void>>();

  get(key: string): LiveValue | undefined {
    return this.values.get(key);
  }

  /** Nothing is known of what runs. */
  get isEmpty(): boolean {
    return this.ofRun.size === 0;
  }

  /** All that is known now; what is not in it is known no more. */
  set(values: ReadonlyMap<string, LiveValue>): void {
    this.ofRun = values;
    if (!this.isInstead) this.show(values);
  }

  /** Values of something else, in place of those of what runs; null: of what runs again. */
  showInstead(values: ReadonlyMap<string, LiveValue> | null): void {
    this.isInstead = values !== null;
    this.show(values ?? this.ofRun);
  }

  private show(values: ReadonlyMap<string, LiveValue>): void {
    const before = this.values;
    this.values = values;
    for (const [key, listeners] of this.listeners) {
      if (!isSame(before.get(key), values.get(key))) for (const listener of [...listeners]) listener();
    }
  }

  subscribe(key: string, listener: () => void): () => void {
    let known = this.listeners.get(key);
    if (!known) {
      known = new Set();
      this.listeners.set(key, known);
    }
    known.add(listener);
    return () => {
      known.delete(listener);
      if (known.size === 0 && this.listeners.get(key) === known) this.listeners.delete(key);
    };
  }
}

function isSame(a: LiveValue | undefined, b: LiveValue | undefined): boolean {
  if (a === b) return true;
  if (!a || !b) return false;
  return (
    a.text === b.text &&
    a.number === b.number &&
    a.trace === b.trace &&
    a.vector?.x === b.vector?.x &&
    a.vector?.y === b.vector?.y &&
    a.isActive === b.isActive &&
    a.isHeld === b.isHeld &&
    a.times === b.times
  );
}

/** The page's. */
export const liveValues = new LiveValues();
