import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { alignSamples, SampleBuffer, valueAt } from "./samples.ts";

function bytesOf(pairs: readonly (readonly [number, number])[]): Uint8Array {
  const view = new DataView(new ArrayBuffer(pairs.length * 16));
  pairs.forEach(([t, v], i) => {
    view.setFloat64(i * 16, t, true);
    view.setFloat64(i * 16 + 8, v, true);
  });
  return new Uint8Array(view.buffer);
}

describe("SampleBuffer", () => {
  it("fills in what was computed again, behind its end as well, and keeps what came live at equal times", () => {
    const b = new SampleBuffer();
    b.append(5, 50);
    b.append(6, 60);
    b.fill(
      bytesOf([
        [0, 0],
        [5, 1],
        [5.5, 55],
        [9, 90],
      ]),
    );
    expect([...b.samples().times]).toEqual([0, 5, 5.5, 6, 9]);
    expect([...b.samples().values]).toEqual([0, 50, 55, 60, 90]);
  });

  it("keeps what it is given until it is full", () => {
    const b = new SampleBuffer(8);
    b.appendBytes(
      bytesOf([
        [0, 1],
        [1, 2],
        [2, 3],
      ]),
    );
    expect([...b.samples().times]).toEqual([0, 1, 2]);
    expect([...b.samples().values]).toEqual([1, 2, 3]);
  });

  it("never exceeds its cap, and keeps the first and the last sample", () => {
    fc.assert(
      fc.property(fc.integer({ min: 4, max: 40 }), fc.integer({ min: 1, max: 500 }), (cap, n) => {
        const b = new SampleBuffer(cap);
        for (let i = 0; i < n; ++i) b.append(i, -i);
        const { times, values } = b.samples();
        expect(times.length).toBeLessThanOrEqual(cap);
        expect(times[0]).toBe(0);
        expect(times[times.length - 1]).toBe(n - 1);
        for (let i = 0; i < times.length; ++i) expect(values[i]).toBe(-(times[i] as number));
        for (let i = 1; i < times.length; ++i) expect(times[i]).toBeGreaterThan(times[i - 1] as number);
      }),
    );
  });

  it("begins anew when time goes back", () => {
    const b = new SampleBuffer();
    b.append(5, 1);
    b.append(0.1, 2);
    expect([...b.samples().times]).toEqual([0.1]);
  });

  it("takes the later value of one moment", () => {
    const b = new SampleBuffer();
    b.append(1, 1);
    b.append(1, 2);
    expect([...b.samples().values]).toEqual([2]);
  });

  it("ignores moments that are no numbers and a broken last record", () => {
    const b = new SampleBuffer();
    b.append(Number.NaN, 1);
    b.appendBytes(
      bytesOf([
        [0, 1],
        [1, 2],
      ]).slice(0, 24),
    );
    expect(b.size).toBe(1);
  });

  it("fills history in around live samples without doubling any", () => {
    const b = new SampleBuffer();
    b.append(2, 20);
    b.append(3, 30);
    b.merge(
      bytesOf([
        [0, 0],
        [1, 10],
        [2, 99],
        [4, 40],
      ]),
    );
    expect([...b.samples().times]).toEqual([0, 1, 2, 3]);
    expect([...b.samples().values]).toEqual([0, 10, 20, 30]);
  });

  it("gives what is inside a span, and its neighbours", () => {
    const b = new SampleBuffer();
    for (let i = 0; i < 10; ++i) b.append(i, i);
    expect([...b.within(3, 5).times]).toEqual([2, 3, 4, 5, 6]);
    expect([...b.within(2.5, 2.6).times]).toEqual([2, 3]);
    expect([...b.within(-5, -4).times]).toEqual([0]);
    expect([...b.within(20, 30).times]).toEqual([9]);
    expect([b.firstTime, b.lastTime]).toEqual([0, 9]);
  });

  it("converts to the unit that is shown", () => {
    const b = new SampleBuffer();
    b.appendBytes(bytesOf([[0, Math.PI]]), 180 / Math.PI);
    expect(b.samples().values[0]).toBeCloseTo(180);
  });
});

describe("alignSamples", () => {
  const series = (pairs: [number, number][]) => ({
    times: Float64Array.from(pairs, (p) => p[0]),
    values: Float64Array.from(pairs, (p) => p[1]),
  });

  it("has each moment once and tells a gap from a missing sample", () => {
    const table = alignSamples([
      series([
        [0, 1],
        [1, Number.NaN],
      ]),
      series([
        [1, 5],
        [2, 6],
      ]),
    ]);
    expect(table.times).toEqual([0, 1, 2]);
    expect(table.columns).toEqual([
      [1, null, undefined],
      [undefined, 5, 6],
    ]);
  });

  it("loses no sample", () => {
    const arbitrary = fc.uniqueArray(fc.integer({ min: 0, max: 50 }), { maxLength: 30 });
    fc.assert(
      fc.property(fc.array(arbitrary, { maxLength: 4 }), (all) => {
        const sorted = all.map((ts) => [...ts].sort((a, b) => a - b));
        const table = alignSamples(sorted.map((ts) => series(ts.map((t) => [t, t]))));
        table.columns.forEach((column, s) => {
          expect(column.filter((v) => v !== undefined)).toEqual(sorted[s]);
        });
        expect(table.times).toEqual([...new Set(sorted.flat())].sort((a, b) => a - b));
      }),
    );
  });
});

describe("valueAt", () => {
  const s = { times: Float64Array.of(1, 2, 3), values: Float64Array.of(10, Number.NaN, 30) };
  it("is that of the last sample not after the moment", () => {
    expect(valueAt(s, 0.5)).toBeNull();
    expect(valueAt(s, 1)).toBe(10);
    expect(valueAt(s, 1.9)).toBe(10);
    expect(valueAt(s, 2.5)).toBeNull();
    expect(valueAt(s, 99)).toBe(30);
  });
});
