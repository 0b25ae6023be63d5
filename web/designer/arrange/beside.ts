// On which side of the selected node a new one comes, so that wires between the two lead on and not back.
import type { Rect } from "../states/curve.ts";

/** What of a node or of a component counts. */
export interface PortTypes {
  readonly type: string;
  readonly inputs: readonly { readonly type: string }[];
}

export type Side = "right" | "left" | "below";

/** Right of it what takes its value, left of it what it takes, and below it what has nothing to do with it. */
export function sideOf(selected: PortTypes, placed: PortTypes): Side {
  if (takes(placed, selected)) return "right";
  if (takes(selected, placed)) return "left";
  return "below";
}

function takes(reader: PortTypes, from: PortTypes): boolean {
  return from.type !== "" && reader.inputs.some(({ type }) => type === from.type || type === "" || type === "any");
}

const kRoom = { across: 64, down: 32 }; // px between the two

/** Its upper left corner. */
export function placeAtSide(side: Side, box: Rect, size: { width: number; height: number }): { x: number; y: number } {
  switch (side) {
    case "right":
      return { x: box.x + box.width + kRoom.across, y: box.y };
    case "left":
      return { x: box.x - size.width - kRoom.across, y: box.y };
    case "below":
      return { x: box.x, y: box.y + box.height + kRoom.down };
  }
}
