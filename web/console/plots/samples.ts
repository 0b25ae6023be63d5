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

  get firstTime(): number {
    return this.count > 0 ? (this.times[0] as number) : Number.POSITIVE_INFINITY;
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
   * Fills in recorded samples where there are none. At equal times those that came live hold; a history that reaches
   * beyond them is of an older run, and is used only up to there.
   */
  merge(bytes: Uint8Array, factor = 1): void {
    this.join(bytes, factor, this.count > 0 ? this.lastTime : Number.POSITIVE_INFINITY);
  }

  /** Takes what was computed again of the run as it goes on; at equal times what came live holds, and so does what is finer. */
  fill(bytes: Uint8Array, factor = 1): void {
    this.join(bytes, factor, Number.POSITIVE_INFINITY);
  }

  private join(bytes: Uint8Array, factor: number, end: number): void {
    const live = this.samples();
    this.clear();
    let next = 0;
    const appendLiveBefore = (time: number) => {
      for (; next < live.times.length && (live.times[next] as number) < time; ++next) this.appendFrom(live, next);
    };
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    for (let at = 0; at + 16 <= bytes.byteLength; at += 16) {
      const time = view.getFloat64(at, true);
      appendLiveBefore(time);
      if (time <= end && live.times[next] !== time) this.append(time, view.getFloat64(at + 8, true) * factor);
    }
    appendLiveBefore(Number.POSITIVE_INFINITY);
  }

  /** A copy, ordered by time, strictly. */
  samples(): { times: Float64Array; values: Float64Array } {
    return { times: this.times.slice(0, this.count), values: this.values.slice(0, this.count) };
  }

  /** Those inside the span and one more at either side, so that lines reach the edges. */
  within(from: number, to: number): { times: Float64Array; values: Float64Array } {
    const begin = Math.max(0, firstAfter(this.times, this.count, from, true) - 1);
    const end = Math.min(this.count, firstAfter(this.times, this.count, to, false) + 1);
    return { times: this.times.subarray(begin, end), values: this.values.subarray(begin, end) };
  }

  private appendFrom(samples: { times: Float64Array; values: Float64Array }, index: number): void {
    this.append(samples.times[index] as number, samples.values[index] as number);
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

/** The first of `count` ordered times that is after `time`, or (`orAt`) at it. */
function firstAfter(times: Float64Array, count: number, time: number, orAt: boolean): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const mid = (low + high) >> 1;
    const at = times[mid] as number;
    if (at > time || (orAt && at === time)) high = mid;
    else low = mid + 1;
  }
  return low;
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
  const after = firstAfter(samples.times, samples.times.length, time, false);
  if (after === 0) return null;
  const value = samples.values[after - 1] as number;
  return Number.isFinite(value) ? value : null;
}
