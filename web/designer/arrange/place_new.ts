// A page of which some nodes have a place and some have none: what automatic layout says is moved so that it fits to what
// stands already, and nothing lies on anything.
import type { NodePlace } from "../drawing/flow.ts";
import { onPitch, type Spot } from "./elk.ts";

export interface SizedNode {
  id: string;
  width: number;
  height: number;
}

const kRoom = 16;

/** Places of all nodes: those of `own` as they are. */
export function placeNew(
  own: ReadonlyMap<string, NodePlace>,
  laidOut: readonly Spot[],
  sizes: readonly SizedNode[],
): Map<string, NodePlace> {
  const places = new Map<string, NodePlace>(own);
  const shift = shiftOf(own, laidOut);
  const size = new Map(sizes.map((one) => [one.id, one]));
  for (const spot of laidOut) {
    const box = size.get(spot.id);
    if (places.has(spot.id) || !box) continue;
    const x = onPitch(spot.x + shift.x);
    let y = onPitch(spot.y + shift.y);
    for (let moved = true; moved; ) {
      moved = false;
      for (const [id, at] of places) {
        const other = size.get(id);
        if (!other || !isOver({ ...box, x, y }, { ...other, ...at })) continue;
        y = Math.ceil((at.y + other.height + kRoom) / 8) * 8;
        moved = true;
      }
    }
    places.set(spot.id, { x, y });
  }
  return places;
}

/** How far the layout is from what stands: on the average of the nodes that both know. */
function shiftOf(own: ReadonlyMap<string, NodePlace>, laidOut: readonly Spot[]): NodePlace {
  let x = 0;
  let y = 0;
  let count = 0;
  for (const spot of laidOut) {
    const at = own.get(spot.id);
    if (!at) continue;
    x += at.x - spot.x;
    y += at.y - spot.y;
    ++count;
  }
  return count === 0 ? { x: 0, y: 0 } : { x: x / count, y: y / count };
}

function isOver(a: SizedNode & NodePlace, b: SizedNode & NodePlace): boolean {
  return (
    a.x < b.x + b.width + kRoom &&
    b.x < a.x + a.width + kRoom &&
    a.y < b.y + b.height + kRoom &&
    b.y < a.y + a.height + kRoom
  );
}
