// What has been recorded of one series. Never longer than its cap: when it is full, the older half keeps every second
// sample, so that the whole run stays visible and the end stays fine.

/** Samples whose time is not after the last one begin a new run: the older ones go. */
export class SampleBuffer {
  private times: Float64Array;
  private values: Float64Array;
  private count = 0;

  constructor(private readonly cap = 8192) {
    if (cap < 4) throw new RangeError("a buffer holds at least 4 samples");
    this.times = new Float64Array(Math.min(cap, 256));
    this.values = new Float64Array(this.times.length);
  }

  get size(): number {
    return this.count;
  }

  get lastTime(): number {
    return this.count > 0 ? (this.times[this.count - 1] as number) : Number.NEGATIVE_INFINITY;
  }

  clear(): void {
    this.count = 0;
  }

  append(time: number, value: number): void {
    if (!Number.isFinite(time)) return;
    if (this.count > 0 && time < this.lastTime) this.clear();
    if (this.count > 0 && time === this.lastTime) {
      this.values[this.count - 1] = value;
      return;
    }
    if (this.count === this.cap) this.thin();
    if (this.count === this.times.length) this.grow();
    this.times[this.count] = time;
    this.values[this.count] = value;
    this.count += 1;
  }

  /** Samples as they come over the wire: float64 time, float64 value, little endian. Trailing bytes are ignored. */
  appendBytes(bytes: Uint8Array, factor = 1): void {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    for (let at = 0; at + 16 <= bytes.byteLength; at += 16) {
      this.append(view.getFloat64(at, true), view.getFloat64(at + 8, true) * factor);
    }
  }

  /**
   * Puts recorded samples before those that came live meanwhile. Where the two overlap the live ones hold; a history
   * that reaches further than what is live belongs to an older run, and is used only up to there.
   */
  prepend(bytes: Uint8Array, factor = 1): void {
    const live = this.samples();
    this.clear();
    const first = live.times.length > 0 ? (live.times[0] as number) : Number.POSITIVE_INFINITY;
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    for (let at = 0; at + 16 <= bytes.byteLength; at += 16) {
      const time = view.getFloat64(at, true);
      if (time < first) this.append(time, view.getFloat64(at + 8, true) * factor);
    }
    for (let i = 0; i < live.times.length; ++i) this.append(live.times[i] as number, live.values[i] as number);
  }

  /** A copy, ordered by time, strictly. */
  samples(): { times: Float64Array; values: Float64Array } {
    return { times: this.times.slice(0, this.count), values: this.values.slice(0, this.count) };
  }

  private thin(): void {
    const half = this.count >> 1;
    let to = 0;
    for (let from = 0; from < this.count; ++from) {
      if (from < half && from % 2 === 1) continue;
      this.times[to] = this.times[from] as number;
      this.values[to] = this.values[from] as number;
      to += 1;
    }
    this.count = to;
  }

  private grow(): void {
    const size = Math.min(this.cap, this.times.length * 2);
    const times = new Float64Array(size);
    const values = new Float64Array(size);
    times.set(this.times);
    values.set(this.values);
    this.times = times;
    this.values = values;
  }
}

/** One column a series over common times. undefined: not sampled then; null: no number then, a gap in the line. */
export interface AlignedTable {
  readonly times: number[];
  readonly columns: (number | null | undefined)[][];
}

/** Brings series to common times, so that they can be drawn and written as one table. */
export function alignSamples(series: readonly { times: Float64Array; values: Float64Array }[]): AlignedTable {
  const at = series.map(() => 0);
  const times: number[] = [];
  const columns: (number | null | undefined)[][] = series.map(() => []);
  for (;;) {
    let next = Number.POSITIVE_INFINITY;
    for (let s = 0; s < series.length; ++s) {
      const t = (series[s] as { times: Float64Array }).times[at[s] as number];
      if (t !== undefined && t < next) next = t;
    }
    if (next === Number.POSITIVE_INFINITY) break;
    times.push(next);
    for (let s = 0; s < series.length; ++s) {
      const { times: ts, values } = series[s] as { times: Float64Array; values: Float64Array };
      const i = at[s] as number;
      if (ts[i] !== next) {
        (columns[s] as unknown[]).push(undefined);
        continue;
      }
      const value = values[i] as number;
      (columns[s] as (number | null)[]).push(Number.isFinite(value) ? value : null);
      at[s] = i + 1;
    }
  }
  return { times, columns };
}

/** The value at a moment: that of the last sample not after it, none where it is no number or too early. */
export function valueAt(samples: { times: Float64Array; values: Float64Array }, time: number): number | null {
  let low = 0;
  let high = samples.times.length;
  while (low < high) {
    const mid = (low + high) >> 1;
    if ((samples.times[mid] as number) <= time) low = mid + 1;
    else high = mid;
  }
  if (low === 0) return null;
  const value = samples.values[low - 1] as number;
  return Number.isFinite(value) ? value : null;
}
