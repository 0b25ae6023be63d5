// Places that a person or automatic layout gave, as changes of the document.
import type { NodePlace, Places } from "../drawing/flow.ts";
import type { ChangeInit, Drawing } from "../session/protocol.ts";
import { onPitch } from "./elk.ts";

interface MovedNode {
  id: string;
  position: NodePlace;
}

/**
 * The changes that keep what was moved; notes are kept by a change of their own. Where the file does not say yet where
 * everything stands, it says so from now on: else the rest would be laid out anew round what was moved.
 */
export function arrangeChange(
  drawing: Drawing,
  moved: readonly MovedNode[],
  places: Places,
  isArranged: boolean,
): { changes: ChangeInit[]; places: Map<string, NodePlace> } {
  const page = drawing.page?.path ?? "";
  const notes = new Map(drawing.notes.map((note) => [note.id, note]));
  const changes: ChangeInit[] = [];
  const now = new Map<string, NodePlace>(isArranged ? [] : places);
  for (const { id, position } of moved) {
    const at = { x: onPitch(position.x), y: onPitch(position.y) };
    const note = notes.get(id);
    if (note) {
      const { text, width, height, isFrame } = note;
      changes.push({ case: "setNote", value: { page, id, text, width, height, isFrame, ...at } });
    } else now.set(id, at);
  }
  if ([...moved].some(({ id }) => !notes.has(id))) {
    const nodes = [...now].map(([node, { x, y }]) => ({ node, x, y }));
    changes.unshift({ case: "arrange", value: { page, nodes } });
  }
  return { changes, places: now };
}

export type Edge = "left" | "right" | "top" | "bottom" | "middle" | "centre" | "across" | "down";

interface Box extends MovedNode {
  width: number;
  height: number;
}

/** Boxes with one edge in line, or (`across`, `down`) with the same room between them. */
export function alignedBoxes(boxes: readonly Box[], edge: Edge): MovedNode[] {
  if (boxes.length < 2) return [];
  const left = Math.min(...boxes.map((box) => box.position.x));
  const right = Math.max(...boxes.map((box) => box.position.x + box.width));
  const top = Math.min(...boxes.map((box) => box.position.y));
  const bottom = Math.max(...boxes.map((box) => box.position.y + box.height));
  if (edge === "across" || edge === "down") return spread(boxes, edge);
  return boxes.map((box) => {
    let { x, y } = box.position;
    if (edge === "left") x = left;
    if (edge === "right") x = right - box.width;
    if (edge === "top") y = top;
    if (edge === "bottom") y = bottom - box.height;
    if (edge === "centre") x = (left + right - box.width) / 2;
    if (edge === "middle") y = (top + bottom - box.height) / 2;
    return { id: box.id, position: { x: onPitch(x), y: onPitch(y) } };
  });
}

function spread(boxes: readonly Box[], edge: "across" | "down"): MovedNode[] {
  const along = edge === "across" ? "x" : "y";
  const size = edge === "across" ? "width" : "height";
  const sorted = [...boxes].sort((a, b) => a.position[along] - b.position[along]);
  const begin = sorted[0]!.position[along];
  const last = sorted.at(-1)!;
  const room = last.position[along] + last[size] - begin - sorted.reduce((sum, box) => sum + box[size], 0);
  const gap = Math.max(16, room / (sorted.length - 1));
  let at = begin;
  return sorted.map((box) => {
    const position = { ...box.position, [along]: onPitch(at) };
    at += box[size] + gap;
    return { id: box.id, position };
  });
}
