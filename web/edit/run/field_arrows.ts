// The movement field of an assemblage: what it would make a robot do at each place of a grid.
import type { Box, Point } from "../../core/geometry.ts";

export interface FieldArrow {
  readonly at: Point;
  /** World frame, share of full strength. */
  readonly way: Point;
}

/** As Field.arrows: float32 x, y, dx, dy. */
export function readArrows(bytes: Uint8Array): FieldArrow[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const arrows: FieldArrow[] = [];
  for (let at = 0; at + 16 <= bytes.byteLength; at += 16) {
    const of = (word: number) => view.getFloat32(at + 4 * word, true);
    arrows.push({ at: { x: of(0), y: of(1) }, way: { x: of(2), y: of(3) } });
  }
  return arrows;
}

const kPitch = 26; // px between arrows
const kMost = 100; // columns, and rows

/** The grid for what is in sight: an arrow every so many pixels, within the mission area. */
export function gridFor(visible: Box, area: { width: number; height: number }, scale: number) {
  const box = {
    xMin: Math.max(0, visible.xMin),
    yMin: Math.max(0, visible.yMin),
    xMax: Math.min(area.width, visible.xMax),
    yMax: Math.min(area.height, visible.yMax),
  };
  const count = (metres: number) => Math.max(0, Math.min(kMost, Math.round((metres * scale) / kPitch)));
  return { area: box, columns: count(box.xMax - box.xMin), rows: count(box.yMax - box.yMin) };
}

/** Length of an arrow on the screen [px]: no more than the grid has room for; strengths above full stay in it. */
export function arrowLength(strength: number, pitch: number): number {
  if (!(strength > 0)) return 0;
  return pitch * 0.9 * Math.min(1, strength);
}
