import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { toCsv, toSvg, valueSpan } from "./export.ts";
import { alignSamples } from "./samples.ts";
import { niceTicks, valueText } from "./ticks.ts";

const kStyle = { width: 800, stripHeight: 240, background: "#fff", text: "#111", grid: "#ddd" };
const kLine = { label: "Robot 1: Speed", unit: "m/s", color: "#06c", dash: [] };

function table(...series: [number, number][][]) {
  return alignSamples(
    series.map((pairs) => ({
      times: Float64Array.from(pairs, (p) => p[0]),
      values: Float64Array.from(pairs, (p) => p[1]),
    })),
  );
}

describe("toCsv", () => {
  it("has a column a series, with its unit, and leaves what is missing empty", () => {
    const text = toCsv(
      table(
        [
          [0, 1.5],
          [0.1, Number.NaN],
        ],
        [[0.1, 2]],
      ),
      [kLine, { ...kLine, label: 'say "hi", robot', unit: "" }],
    );
    expect(text).toBe('time [s],Robot 1: Speed [m/s],"say ""hi"", robot"\r\n0,1.5,\r\n0.1,,2\r\n');
  });

  it("has times without the noise of binary fractions", () => {
    expect(toCsv(table([[200.20000000000002, 1]]), [kLine])).toContain("\r\n200.2,1\r\n");
  });

  it("keeps every number exactly", () => {
    fc.assert(
      fc.property(
        fc.array(fc.double({ noNaN: true, noDefaultInfinity: true }), { minLength: 1, maxLength: 20 }),
        (vs) => {
          const rows = toCsv(table(vs.map((v, i) => [i, v])), [kLine])
            .trim()
            .split("\r\n")
            .slice(1);
          expect(rows.map((r) => Number(r.split(",")[1]))).toEqual(vs.map((v) => (v === 0 ? 0 : v)));
        },
      ),
    );
  });
});

describe("toSvg", () => {
  it("breaks a line where there is no number and keeps names harmless", () => {
    const strip = {
      title: "<Speed>",
      unit: "m/s",
      series: [{ ...kLine, label: "A & B" }],
      table: table([
        [0, 1],
        [1, Number.NaN],
        [2, 1],
        [3, 2],
      ]),
    };
    const svg = toSvg([strip], { from: 0, to: 3 }, kStyle);
    expect(svg).toContain("&lt;Speed&gt; [m/s]");
    expect(svg).toContain("A &amp; B");
    const d = /<path d="([^"]+)"/.exec(svg)?.[1] ?? "";
    expect(d.match(/M/g)).toHaveLength(2);
    expect(d.match(/L/g)).toHaveLength(1);
    expect(svg).not.toContain("NaN");
  });

  it("draws a series without samples as an empty strip", () => {
    const svg = toSvg([{ title: "x", unit: "", series: [kLine], table: table([]) }], { from: 0, to: 0 }, kStyle);
    expect(svg).not.toMatch(/NaN|Infinity/);
  });
});

describe("valueSpan", () => {
  it("leaves room around a constant", () => {
    expect(
      valueSpan(
        table([
          [0, 5],
          [1, 5],
        ]),
        { from: 0, to: 1 },
      ),
    ).toEqual({ from: 4.5, to: 5.5 });
  });
  it("looks only at what is shown", () => {
    const span = valueSpan(
      table([
        [0, 1000],
        [5, 1],
        [6, 2],
      ]),
      { from: 4, to: 7 },
    );
    expect(span.to).toBeLessThan(3);
  });
});

describe("niceTicks", () => {
  it("are round, inside and evenly spaced", () => {
    expect(niceTicks(0, 10, 5)).toEqual([0, 2, 4, 6, 8, 10]);
    expect(niceTicks(0, 0.3, 3)).toEqual([0, 0.1, 0.2, 0.3]);
    fc.assert(
      fc.property(
        fc.double({ min: -1e6, max: 1e6, noNaN: true }),
        fc.double({ min: 1e-3, max: 1e6, noNaN: true }),
        (from, span) => {
          const ticks = niceTicks(from, from + span, 5);
          expect(ticks.length).toBeLessThanOrEqual(12);
          expect(ticks.length).toBeGreaterThanOrEqual(2);
          expect(new Set(ticks.map(String)).size).toBe(ticks.length);
          for (const t of ticks) {
            expect(t).toBeGreaterThanOrEqual(from - span * 1e-6);
            expect(t).toBeLessThanOrEqual(from + span * 1.000001);
          }
        },
      ),
    );
  });
  it("of nothing are none", () => {
    expect(niceTicks(Number.NaN, 1, 5)).toEqual([]);
    expect(niceTicks(3, 3, 5)).toEqual([3]);
  });
  it("far from zero keep their digits, until numbers have none left", () => {
    expect(niceTicks(999999.9999, 1000000.0015, 5)).toEqual([
      999999.9999 + 0.0001,
      1000000.0005,
      1000000.001,
      1000000.0015,
    ]);
    expect(niceTicks(1e17, 1e17 + 16, 5)).toEqual([1e17]);
    expect(niceTicks(-1e-120, 1e-120, 2)).toEqual([-1e-120, 0, 1e-120]);
  });
});

describe("valueText", () => {
  it("has digits that say something", () => {
    expect(valueText(123.456)).toBe("123.5");
    expect(valueText(1.23456)).toBe("1.235");
    expect(valueText(0.0000123)).toBe("1.23e-5");
    expect(valueText(null)).toBe("–");
  });
});
