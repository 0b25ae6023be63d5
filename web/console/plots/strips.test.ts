import { describe, expect, it } from "vitest";
import type { QuantityName, SeriesSpec } from "./series.ts";
import { panSpan, spanOf, spanRound, stripsOf, zoomSpan } from "./strips.ts";

const robot = (id: number, quantity: QuantityName, port = ""): SeriesSpec => ({ quantity, robot: id, unit: "", port });
const kUnits = () => "deg";

describe("strips", () => {
  it("hold one subject each, and give a robot one colour everywhere", () => {
    const strips = stripsOf([robot(1, "speed"), robot(2, "speed"), robot(2, "formation_error")], false, kUnits);
    expect(strips.map((s) => [s.title, s.unit, s.lines.map((l) => l.label)])).toEqual([
      ["Speed", "m/s", ["Robot 1", "Robot 2"]],
      ["Formation error", "m", ["Robot 2"]],
    ]);
    expect(strips[1]?.lines[0]?.color).toBe(strips[0]?.lines[1]?.color);
  });

  it("hold one unit of measure each when drawn together, subjects told apart by their dashes", () => {
    const strips = stripsOf(
      [robot(1, "distance_to_goal"), robot(1, "speed"), robot(1, "formation_error")],
      true,
      kUnits,
    );
    expect(strips.map((s) => s.lines.map((l) => l.label))).toEqual([
      ["Robot 1: Distance to goal", "Robot 1: Formation error"],
      ["Robot 1"],
    ]);
    const [a, b] = strips[0]?.lines ?? [];
    expect(a?.dash).not.toEqual(b?.dash);
  });

  it("tell more lines apart than there are colours", () => {
    const lines =
      stripsOf(
        Array.from({ length: 20 }, (_, i) => robot(i + 1, "speed")),
        false,
        kUnits,
      )[0]?.lines ?? [];
    expect(new Set(lines.map((l) => `${l.color} ${l.dash.join(",")}`)).size).toBe(20);
  });

  it("of ports have the port's unit", () => {
    expect(stripsOf([robot(1, "port", "a.angle")], false, kUnits)[0]?.unit).toBe("deg");
  });
});

describe("the span of time", () => {
  it("slides with the samples while live", () => {
    expect(spanOf({ live: true, window: 10 }, 0, 100)).toEqual({ from: 90, to: 100 });
    expect(spanOf({ live: true, window: 10 }, 0, 4)).toEqual({ from: 0, to: 4 });
    expect(spanOf({ live: true, window: 0 }, 3, 100)).toEqual({ from: 3, to: 100 });
  });
  it("holds still when zoomed, and is never empty", () => {
    expect(spanOf({ live: false, from: 3, to: 4 }, 0, 100)).toEqual({ from: 3, to: 4 });
    expect(spanOf({ live: true, window: 60 }, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY)).toEqual({
      from: 0,
      to: 60,
    });
    const { from, to } = spanOf({ live: true, window: 10 }, 5, 5);
    expect(to - from).toBeGreaterThanOrEqual(1);
  });
  it("has the moment that is looked at in it, and does not reach beyond the run", () => {
    const minute = { live: true, window: 60 } as const;
    expect(spanRound(minute, 100, 300)).toEqual({ from: 70, to: 130 });
    expect(spanRound(minute, 10, 300)).toEqual({ from: 0, to: 60 });
    expect(spanRound(minute, 290, 300)).toEqual({ from: 240, to: 300 });
    expect(spanRound(minute, 20, 30)).toEqual({ from: 0, to: 30 });
    expect(spanRound({ live: true, window: 0 }, 20, 300)).toEqual({ from: 0, to: 300 });
    expect(spanRound({ live: false, from: 3, to: 4 }, 20, 300)).toEqual({ from: 3, to: 4 });
  });
  it("zooms about its middle and moves by a share of its length", () => {
    expect(zoomSpan({ from: 0, to: 10 }, 0.5)).toEqual({ from: 2.5, to: 7.5 });
    expect(zoomSpan({ from: 0, to: 0.01 }, 0.5).to).toBeCloseTo(0.055);
    expect(panSpan({ from: 0, to: 10 }, -0.1)).toEqual({ from: -1, to: 9 });
  });
});
