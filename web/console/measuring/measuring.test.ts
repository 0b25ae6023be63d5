import { describe, expect, test } from "vitest";
import { measuredText } from "./measure_tool.tsx";

describe("what was measured", () => {
  test("is nothing before there are two points", () => {
    expect(measuredText([])).toBe("");
    expect(measuredText([{ x: 1, y: 2 }])).toBe("");
  });

  test("is the last leg with its bearing, and the whole of several", () => {
    const points = [
      { x: 0, y: 0 },
      { x: 0, y: 200 },
      { x: 100, y: 200 },
    ];
    expect(measuredText(points.slice(0, 2))).toBe("200 m, bearing 000°");
    expect(measuredText(points)).toBe("Last 100 m, bearing 090° · whole 300 m");
  });
});
