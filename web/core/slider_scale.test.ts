import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { kSliderEnd, kSliderStep, placeOnSlider, type Range, sliderScale, valueOnSlider } from "./slider_scale.ts";

const range = (min: number, max: number, usual = Number.NaN): Range => ({ min, max, usual, isWhole: false });

const anyRange = fc
  .record({
    min: fc.constantFrom(-1e6, -100, -7, 0, 0.01, 1),
    span: fc.constantFrom(1, 5, 100, 1e4, 1e6, 1e9),
    share: fc.double({ min: 0, max: 1, noNaN: true }),
    isWhole: fc.boolean(),
  })
  .map(({ min, span, share, isWhole }) => ({ min, max: min + span, usual: min + span * share ** 8, isWhole }));

describe("a slider", () => {
  it("is even where the usual value stands well inside of the range", () => {
    const scale = sliderScale(range(0, 5, 2));
    expect(scale.kind).toBe("even");
    expect(valueOnSlider(scale, 500)).toBe(2.5);
  });
  it("goes by ratios where the range spans decades: the usual value and both sides of it can be met", () => {
    const scale = sliderScale(range(0, 1e6, 1));
    expect(scale.kind).toBe("ratios");
    expect(placeOnSlider(scale, 1)).toBe(400);
    expect(placeOnSlider(scale, 0.1)).toBe(200);
    expect(placeOnSlider(scale, 1000)).toBe(700);
    expect([valueOnSlider(scale, 0), valueOnSlider(scale, kSliderEnd)]).toEqual([0, 1e6]);
  });
  it("begins at the range's own smallest value where that is not nothing", () => {
    const scale = sliderScale(range(0.01, 1e3, 1));
    expect(valueOnSlider(scale, 0)).toBe(0.01);
    expect(placeOnSlider(scale, 0.1)).toBe(200);
  });
  it("has nothing in the middle of both signs", () => {
    const scale = sliderScale(range(-1e6, 1e6, 0));
    expect(scale.kind).toBe("signs");
    expect(placeOnSlider(scale, 0)).toBe(500);
    expect(valueOnSlider(scale, 500)).toBe(0);
    expect(placeOnSlider(scale, 50)).toBe(1000 - placeOnSlider(scale, -50));
  });
  it("moves by some per cent with an arrow key, by about a decade with a page", () => {
    const scale = sliderScale(range(0, 1e6, 1));
    const next = valueOnSlider(scale, placeOnSlider(scale, 2) + kSliderStep);
    expect(next / 2).toBeGreaterThan(1.02);
    expect(next / 2).toBeLessThan(1.2);
    const page = valueOnSlider(scale, placeOnSlider(scale, 2) + kSliderEnd / 10);
    expect(page / 2).toBeCloseTo(10, 0);
  });
  it("has a scale of its own where the usual value is next to nothing", () => {
    const scale = sliderScale({ min: 0, max: 100, usual: 5e-324, isWhole: false });
    expect(valueOnSlider(scale, 500)).toBeGreaterThan(0);
    expect(placeOnSlider(scale, valueOnSlider(scale, 500))).toBeCloseTo(500, -1);
  });
  it("never goes back, stays within the range, and finds its place again", () => {
    fc.assert(
      fc.property(anyRange, (one) => {
        const scale = sliderScale(one);
        let last = Number.NEGATIVE_INFINITY;
        for (let place = 0; place <= kSliderEnd; place += kSliderStep) {
          const value = valueOnSlider(scale, place);
          expect(value).toBeGreaterThanOrEqual(one.min);
          expect(value).toBeLessThanOrEqual(one.max);
          expect(value).toBeGreaterThanOrEqual(last);
          if (!one.isWhole && scale.kind === "ratios") {
            expect(Math.abs(placeOnSlider(scale, value) - place)).toBeLessThanOrEqual(kSliderStep);
          }
          last = value;
        }
      }),
      { numRuns: 60 },
    );
  });
});
