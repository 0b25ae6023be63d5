// The last moments of numbers, for the little plots beside wires.

const kMost = 80; // samples

export class Traces {
  private readonly samples = new Map<string, number[]>();
  private time = Number.NEGATIVE_INFINITY;
  private isNew = false;
  /** Of the last moments [s]. */
  private readonly times: number[] = [];

  /** Begins the samples of a moment [s]; going back in time forgets all. */
  at(time: number): void {
    if (time < this.time) this.clear();
    this.isNew = time !== this.time;
    this.time = time;
    if (!this.isNew) return;
    this.times.push(time);
    if (this.times.length > kMost) this.times.shift();
  }

  /** How long the longest plot can be that ends now [s]: of as many samples as are kept. */
  get span(): number {
    return this.times.length === 0 ? 0 : this.time - this.times[0]!;
  }

  /** The samples with this one, oldest first; the same array as before where no time has passed. */
  add(key: string, value: number): readonly number[] {
    const known = this.samples.get(key);
    if (known && !this.isNew) return known;
    const next = known ? [...known.slice(known.length >= kMost ? 1 : 0), value] : [value];
    this.samples.set(key, next);
    return next;
  }

  clear(): void {
    this.samples.clear();
    this.times.length = 0;
    this.time = Number.NEGATIVE_INFINITY;
  }

  /** Forgets what is not among these. */
  keep(keys: ReadonlySet<string>): void {
    for (const key of this.samples.keys()) if (!keys.has(key)) this.samples.delete(key);
  }
}

/** Between which values the samples are; nothing: too few, or nothing changes. */
export function traceRange(samples: readonly number[]): { low: number; high: number } | undefined {
  const finite = samples.filter(Number.isFinite);
  if (finite.length < 2) return undefined;
  const low = Math.min(...finite);
  const high = Math.max(...finite);
  return high - low > 1e-12 ? { low, high } : undefined;
}

/** A path through the samples, in a box of this size, level where nothing changes; empty where there are less than two. */
export function tracePath(samples: readonly number[], width: number, height: number): string {
  const finite = samples.filter(Number.isFinite);
  if (finite.length < 2) return "";
  const range = traceRange(finite);
  const share = (value: number) => (range ? (range.high - value) / (range.high - range.low) : 0.5);
  const y = (value: number) => share(value) * (height - 2) + 1;
  const step = width / (kMost - 1);
  const first = width - (finite.length - 1) * step;
  return finite
    .map((value, i) => `${i === 0 ? "M" : "L"}${(first + i * step).toFixed(1)} ${y(value).toFixed(1)}`)
    .join("");
}
