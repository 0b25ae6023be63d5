import { describe, expect, it } from "vitest";
import { kPresets, kSliderEnd, neighbour, sliderOf, speedOf } from "./speed.ts";

describe("the speed slider", () => {
  it("comes back to every preset", () => {
    for (const preset of kPresets) expect(speedOf(sliderOf(preset))).toBe(preset);
  });
  it("ends with max", () => {
    expect(sliderOf(0)).toBe(kSliderEnd);
    expect(speedOf(kSliderEnd)).toBe(0);
    expect(speedOf(kSliderEnd - 1)).toBe(1000);
  });
  it("steps from preset to preset and stops at the ends", () => {
    expect(neighbour(10, 1)).toBe(20);
    expect(neighbour(7, -1)).toBe(5);
    expect(neighbour(1000, 1)).toBe(0);
    expect(neighbour(0, 1)).toBe(0);
    expect(neighbour(0, -1)).toBe(1000);
    expect(neighbour(0.1, -1)).toBe(0.1);
  });
});
