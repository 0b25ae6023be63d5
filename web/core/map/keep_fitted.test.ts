import { describe, expect, it } from "vitest";
import { Camera } from "../camera.ts";
import { isFitted } from "./keep_fitted.ts";

const size = { width: 800, height: 600 };
const area = { width: 1000, height: 500 };

function fitted(): Camera {
  const camera = new Camera();
  camera.resize(size.width, size.height);
  camera.fit({ xMin: 0, yMin: 0, xMax: area.width, yMax: area.height });
  return camera;
}

describe("a map that shows the whole area", () => {
  it("is known as such", () => expect(isFitted(fitted(), size, area)).toBe(true));
  it("is another once it was moved or zoomed", () => {
    const moved = fitted();
    moved.pan(10, 0);
    expect(isFitted(moved, size, area)).toBe(false);
    const zoomed = fitted();
    zoomed.zoomAbout({ x: 400, y: 300 }, 1.1);
    expect(isFitted(zoomed, size, area)).toBe(false);
  });
  it("is known beside what lay over it", () => {
    const bar = { xMin: 12, yMin: 12, xMax: 52, yMax: 400 };
    const beside = fitted();
    beside.fit({ xMin: 0, yMin: 0, xMax: area.width, yMax: area.height }, undefined, [bar]);
    expect(isFitted(beside, size, area, [bar])).toBe(true);
    expect(isFitted(beside, size, area)).toBe(false);
  });
  it("is another in a window of another size", () =>
    expect(isFitted(fitted(), { width: 500, height: 600 }, area)).toBe(false));
});
