import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { placeText, writtenPlace } from "./place_notation.ts";
import { mgrsOf, Projection, type ProjectionNumbers, utmOf } from "./projection.ts";

interface Row {
  latitude: number;
  longitude: number;
  projection: ProjectionNumbers;
  x: number;
  y: number;
  degrees: string;
  seconds: string;
  utm: string;
  mgrs: string;
}

// Written by the server's own conversions (src/mlab/geography/page_places_test.cc).
const rows: Row[] = readFileSync(new URL("projection_places.jsonl", import.meta.url), "utf8")
  .trim()
  .split("\n")
  .map((line) => JSON.parse(line) as Row);

describe("places on the Earth", () => {
  it("has the server's table", () => {
    expect(rows.length).toBeGreaterThan(20);
  });

  it("projects as the server does, to a tenth of a millimetre", () => {
    for (const row of rows) {
      const at = new Projection(row.projection).toWorld(row);
      expect(Math.hypot(at.x - row.x, at.y - row.y)).toBeLessThan(1e-4);
    }
  });

  it("finds the place of a world point again", () => {
    for (const row of rows) {
      const place = new Projection(row.projection).toEarth(row);
      expect(Math.abs(place.latitude - row.latitude)).toBeLessThan(1e-9);
      expect(Math.abs(place.longitude - row.longitude)).toBeLessThan(1e-8);
    }
  });

  it("writes places as the server does", () => {
    for (const row of rows) {
      for (const notation of ["degrees", "seconds", "utm", "mgrs"] as const)
        expect(writtenPlace(row, notation)).toBe(row[notation]);
    }
  });

  it("has no grid beyond its ends", () => {
    expect(utmOf({ latitude: 84.001, longitude: 10 })).toBeNull();
    expect(mgrsOf({ latitude: -80.001, longitude: 10 })).toBeNull();
    expect(writtenPlace({ latitude: -81, longitude: -1 }, "mgrs")).toBe("81.0000000 S 1.0000000 W");
  });

  it("writes metres where that is chosen, or where the map lies nowhere", () => {
    const scene = { projection: rows[0]!.projection };
    expect(placeText(scene, { x: 12.3456, y: 7 }, "metres", 80)).toBe("12.35, 7.00 m");
    expect(placeText({}, { x: 12.3456, y: 7 }, "utm", 80)).toBe("12.35, 7.00 m");
    expect(placeText(null, { x: 1, y: 7 }, "mgrs", 0.5)).toBe("1, 7 m");
    expect(placeText(scene, rows[0]!, "mgrs", 80)).toBe(rows[0]!.mgrs);
  });
});
