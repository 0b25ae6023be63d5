import { alignedBoxes, arrangeChange, type Edge } from "../arrange/arrange.ts";
import { layOut } from "../arrange/layout.ts";
import type { Designer } from "../session/designer.ts";
import { kResult } from "../session/protocol.ts";
import { isArranged, keepMoved, placesOf, sizesOf } from "../sight/use_places.ts";
import { fit } from "../sight/view.ts";
import { selectionByKind } from "./editing.ts";

export function alignSelection(designer: Designer, edge: Edge): void {
  const { drawing } = designer;
  const places = drawing && placesOf(drawing);
  if (!drawing || !places) return;
  const sizes = sizesOf(drawing);
  const boxes = selectionByKind(designer).nodes.flatMap((id) => {
    const at = places.get(id);
    const size = sizes.get(id);
    return at && size ? [{ position: at, ...size }] : [];
  });
  const moved = alignedBoxes(boxes, edge);
  if (moved.length === 0) return;
  const { changes, places: now } = arrangeChange(drawing, moved, places, isArranged(drawing));
  keepMoved(drawing, now);
  void designer.edit(`align ${moved.length} nodes`, ...changes);
}

/** Lays out the whole page anew, as one step that can be undone. */
export async function arrangeAll(designer: Designer): Promise<void> {
  const { drawing } = designer;
  if (!drawing) return;
  const spots = (await layOut(drawing)).filter((spot) => spot.id !== kResult);
  if (spots.length === 0) return;
  const moved = spots.map(({ id, x, y }) => ({ id, position: { x, y } }));
  const { changes, places } = arrangeChange(drawing, moved, new Map(), true);
  keepMoved(drawing, places);
  const answer = await designer.edit("automatic layout", ...changes);
  if (answer.ok) setTimeout(() => fit(), 50);
}
