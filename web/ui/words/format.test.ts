import { describe, expect, it } from "vitest";
import { idRanges } from "../../core/format.ts";
import { count, distance, duration, headingDegrees, list, quantity, readableMessage, speedFactor } from "./format.ts";

describe("duration", () => {
  it("shows minutes and seconds, and hours once there are any", () => {
    expect(duration(7)).toBe("0:07");
    expect(duration(754.9)).toBe("12:34");
    expect(duration(3723)).toBe("1:02:03");
  });
  it("shows tenths when asked and carries them into the seconds", () => {
    expect(duration(7.25, true)).toBe("0:07.3");
    expect(duration(59.97, true)).toBe("1:00.0");
  });
  it("has no text for what is unknown", () => {
    expect(duration(-1)).toBe("–");
    expect(duration(Number.NaN)).toBe("–");
  });
});

describe("distance", () => {
  it("has as many digits as a person uses", () => {
    expect([3.12, 350.4, 1240, 12400].map(distance)).toEqual(["3.1 m", "350 m", "1.24 km", "12.4 km"]);
  });
  it("is a dash where it is unknown", () => expect(distance(-1)).toBe("–"));
});

describe("quantity", () => {
  it("drops zeros that say nothing", () => {
    expect([0, 0.25, -1.5, 12300, 100, 0.1 + 0.2].map((v) => quantity(v))).toEqual([
      "0",
      "0.25",
      "-1.5",
      "12300",
      "100",
      "0.3",
    ]);
  });
  it("uses powers of ten only where digits would run out", () => {
    expect(quantity(1.2e-7)).toBe("1.2e-7");
    expect(quantity(5e8)).toBe("5e+8");
  });
  it("survives what is no number", () => {
    expect(quantity(Number.NaN)).toBe("–");
    expect(quantity(-Infinity)).toBe("-∞");
  });
});

describe("words", () => {
  it("puts headings into 0 to 359 degrees", () => {
    expect([0, Math.PI / 2, -Math.PI / 2, 2 * Math.PI - 1e-4].map(headingDegrees)).toEqual(["0°", "90°", "270°", "0°"]);
  });
  it("calls speed 0 the greatest", () => expect([0, 10, 0.5].map(speedFactor)).toEqual(["max", "×10", "×0.5"]));
  it("counts", () => expect([count(1, "robot"), count(4, "robot")]).toEqual(["1 robot", "4 robots"]));
  it("lists", () => expect([list(["a"]), list(["a", "b", "c"])]).toEqual(["a", "a, b and c"]));
  it("calls robots by their names", () =>
    expect(readableMessage("robot 1 touched robot 12; robots 3 and 4 wait, the robot stands")).toBe(
      "Robot 1 touched Robot 12; Robots 3 and 4 wait, the robot stands",
    ));
  it("quotes names", () => expect(readableMessage("no `a` in `b`")).toBe("no “a” in “b”"));
  it("joins runs of numbers", () => expect(idRanges([4, 1, 2, 3, 7, 8])).toBe("1–4, 7, 8"));
});
