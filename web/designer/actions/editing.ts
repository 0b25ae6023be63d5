// What is done to the selection: removed, copied, grouped, framed, moved.
import { arrangeChange } from "../arrange/arrange.ts";
import { onPitch } from "../arrange/elk.ts";
import { ownPlaces } from "../drawing/flow.ts";
import { freePlace, showNode } from "../palette/place.ts";
import type { Designer } from "../session/designer.ts";
import { onceDrawn } from "../session/once_drawn.ts";
import { type ChangeInit, type ChangeOf, type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { canvasStore } from "../sight/canvas_store.ts";
import { isArranged, keepMoved, layOutAnew, placesOf, sizesOf, wholePlaces } from "../sight/use_places.ts";
import { fit } from "../sight/view.ts";
import { disconnectChange, endOf } from "../sight/wiring.ts";
import { transitionOf } from "../states/flow.ts";

/** The selection by what it is. */
export function selectionByKind(designer: Designer): {
  nodes: string[];
  notes: string[];
  wires: string[];
  transitions: string[];
} {
  const { drawing } = designer;
  const parts = { nodes: [] as string[], notes: [] as string[], wires: [] as string[], transitions: [] as string[] };
  if (!drawing) return parts;
  const names = new Set([...drawing.nodes, ...drawing.states].map((one) => one.name));
  const notes = new Set(drawing.notes.map((note) => note.id));
  for (const id of designer.state.selection) {
    if (names.has(id)) parts.nodes.push(id);
    else if (notes.has(id)) parts.notes.push(id);
    else if (drawing.kind === Drawing_Kind.STATES && transitionOf(drawing, id)) parts.transitions.push(id);
    else parts.wires.push(id);
  }
  return parts;
}

export async function removeSelection(designer: Designer): Promise<void> {
  const { page, selection } = designer.state;
  const { drawing } = designer;
  const { nodes, notes, wires, transitions } = selectionByKind(designer);
  const changes: ChangeInit[] = [];
  if (drawing?.kind === Drawing_Kind.SOCIETY) changes.push(...membersRemoved(drawing, nodes));
  for (const id of drawing?.kind === Drawing_Kind.SOCIETY ? [] : wires) {
    const { node, row } = endOf(id);
    if (!nodes.includes(node)) changes.push(disconnectChange(page, node, row));
  }
  // Later ones first: indices of those before them stay.
  const ordered = transitions.map((id) => ({
    from: id.slice(0, id.lastIndexOf("/")),
    index: Number(id.slice(id.lastIndexOf("/") + 1)),
  }));
  for (const one of ordered.sort((a, b) => b.index - a.index)) {
    if (!nodes.includes(one.from)) changes.push({ case: "removeTransition", value: { page, ...one } });
  }
  for (const id of notes) changes.push({ case: "setNote", value: { page, id, text: "" } });
  if (nodes.length > 0 && drawing?.kind !== Drawing_Kind.SOCIETY)
    changes.push({ case: "remove", value: { page, nodes } });
  if (changes.length === 0) return;
  const name =
    selection.length === 1 && nodes.length === 1
      ? `remove ${nodes[0]}`
      : nodes.length > 0
        ? `remove ${nodes.length} nodes`
        : "";
  const answer = await designer.edit(name, ...changes);
  if (!answer.ok) return;
  designer.select([]);
  designer.say(`Removed ${selection.length === 1 ? selection[0] : `${selection.length} things`}`);
}

/** Of a society; the last first, so that the places of those before them stay. */
function membersRemoved(drawing: Drawing, names: readonly string[]): ChangeInit[] {
  const society = drawing.page?.path ?? "";
  const paths = drawing.nodes.filter(({ name }) => names.includes(name)).map(({ member }) => member);
  const isInside = (path: readonly number[]) =>
    paths.some((outer) => outer.length < path.length && outer.every((at, i) => path[i] === at));
  return paths
    .filter((path) => !isInside(path))
    .sort(laterFirst)
    .map((path) => ({ case: "removeMember", value: { society, path } }));
}

function laterFirst(a: readonly number[], b: readonly number[]): number {
  const at = a.findIndex((one, i) => one !== b[i]);
  return at < 0 ? b.length - a.length : (b[at] ?? -1) - a[at]!;
}

/** Where the selected nodes stand, also those that the file says nothing of. */
export function placesOfSelection(designer: Designer): { node: string; x: number; y: number }[] {
  const places = designer.drawing && placesOf(designer.drawing);
  return selectionByKind(designer).nodes.flatMap((node) => {
    const at = places?.get(node);
    return at ? [{ node, x: at.x, y: at.y }] : [];
  });
}

/** CDL of the selected nodes. */
async function textOf(designer: Designer): Promise<string> {
  const { document, page } = designer.state;
  const { nodes } = selectionByKind(designer);
  if (nodes.length === 0) return "";
  const answer = await designer.ask({
    case: "copy",
    value: { document, page, nodes, places: placesOfSelection(designer) },
  });
  return answer.result.case === "text" ? answer.result.value : "";
}

export async function copySelection(designer: Designer): Promise<boolean> {
  const text = await textOf(designer);
  if (text === "") return false;
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    designer.tell("The browser does not let the page write to the clipboard.");
    return false;
  }
  designer.say("Copied");
  return true;
}

export async function cutSelection(designer: Designer): Promise<void> {
  if (await copySelection(designer)) await removeSelection(designer);
}

export async function paste(designer: Designer): Promise<void> {
  let text = "";
  try {
    text = await navigator.clipboard.readText();
  } catch {
    designer.tell("The browser does not let the page read the clipboard. Ctrl V on the text does it.");
    return;
  }
  await pasteText(designer, text);
}

export async function pasteText(designer: Designer, text: string): Promise<void> {
  if (text.trim() === "") return;
  const { pointer, view } = canvasStore.getState();
  const isInside =
    pointer.x > view.x && pointer.x < view.x + view.width && pointer.y > view.y && pointer.y < view.y + view.height;
  const at = isInside ? pointer : { x: view.x + view.width / 2, y: view.y + view.height / 2 };
  await pasteAt(designer, "paste", text, { x: onPitch(at.x), y: onPitch(at.y) });
}

/** Until what has a place is drawn [ms]. */
const kDrawn = 100;

/**
 * Takes an assemblage apart; what it was made of is selected. Where the author arranged nothing the page is laid out
 * anew: there is no room for its parts where it stood.
 */
export async function ungroup(designer: Designer, node: string): Promise<void> {
  const { drawing } = designer;
  if (!drawing) return;
  if (drawing.kind === Drawing_Kind.SOCIETY) {
    const path = drawing.nodes.find((one) => one.name === node)?.member ?? [];
    await designer.edit(`take ${node} apart`, {
      case: "ungroupMembers",
      value: { society: designer.state.page, path },
    });
    return;
  }
  const wasArranged = ownPlaces(drawing).size > 0;
  const before = new Map(drawing.nodes.map((one) => [one.name, one.component]));
  const answer = await designer.edit(`ungroup ${node}`, {
    case: "ungroup",
    value: { page: designer.state.page, node },
  });
  if (!answer.ok) return;
  const now = await onceDrawn(designer, () => {
    const next = designer.drawing;
    return next && next !== drawing && next.page?.path === drawing.page?.path ? next : undefined;
  });
  if (!now) return;
  const parts = now.nodes.filter(({ name, component }) => before.get(name) !== component).map(({ name }) => name);
  if (wasArranged) return designer.select(parts);
  layOutAnew(now);
  await wholePlaces(now);
  // The canvas lets go of nodes that have no place yet.
  await new Promise((resolve) => setTimeout(resolve, kDrawn));
  designer.select(parts);
  fit();
}

/** Where something stands on the page: what is pasted goes aside, a duplicate stays by its original. */
function takenBoxes({ drawing }: Designer): { x: number; y: number; width: number; height: number }[] {
  const places = drawing && placesOf(drawing);
  if (!drawing || !places) return [];
  return [...sizesOf(drawing)].flatMap(([name, { width, height }]) => {
    const at = places.get(name);
    return at ? [{ ...at, width, height }] : [];
  });
}

/** What has come is selected. */
async function pasteAt(designer: Designer, name: string, text: string, at: { x: number; y: number }): Promise<void> {
  const all = () => [...(designer.drawing?.nodes ?? []), ...(designer.drawing?.states ?? [])].map((one) => one.name);
  const before = new Set(all());
  const value = { page: designer.state.page, text, ...at, taken: name === "paste" ? takenBoxes(designer) : [] };
  const answer = await designer.edit(name, { case: "paste", value });
  if (!answer.ok) return;
  const made = await onceDrawn(designer, () => {
    const fresh = all().filter((one) => !before.has(one));
    return fresh.length > 0 ? fresh : undefined;
  });
  if (made) designer.select(made);
}

export async function duplicate(designer: Designer): Promise<void> {
  const text = await textOf(designer);
  const places = placesOfSelection(designer);
  if (text === "" || places.length === 0) return;
  const at = { x: Math.min(...places.map(({ x }) => x)) + 40, y: Math.min(...places.map(({ y }) => y)) + 40 };
  await pasteAt(designer, "duplicate", text, at);
}

/** By arrow keys; several strokes become one step of undo. */
let pending: { dx: number; dy: number; timer: ReturnType<typeof setTimeout> } | null = null;

export function nudge(designer: Designer, dx: number, dy: number): void {
  const { drawing } = designer;
  if (!drawing || drawing.isReadOnly) return;
  clearTimeout(pending?.timer);
  const sum = { dx: (pending?.dx ?? 0) + dx, dy: (pending?.dy ?? 0) + dy };
  pending = { ...sum, timer: setTimeout(() => finish(designer, sum.dx, sum.dy), 350) };
}

function finish(designer: Designer, dx: number, dy: number): void {
  pending = null;
  const { drawing } = designer;
  const places = drawing && placesOf(drawing);
  if (!drawing || !places) return;
  const { nodes, notes } = selectionByKind(designer);
  const moved = [
    ...nodes.flatMap((id) => {
      const at = places.get(id);
      return at ? [{ id, position: { x: at.x + dx, y: at.y + dy } }] : [];
    }),
    ...drawing.notes
      .filter((note) => notes.includes(note.id))
      .map((note) => ({ id: note.id, position: { x: note.x + dx, y: note.y + dy } })),
  ];
  if (moved.length === 0) return;
  const { changes, places: now } = arrangeChange(drawing, moved, places, isArranged(drawing));
  keepMoved(drawing, now);
  void designer.edit(moved.length === 1 ? `move ${moved[0]!.id}` : `move ${moved.length} nodes`, ...changes);
}

/** Makes a comment or a frame, whose words are typed at once. */
async function makeNote(designer: Designer, name: string, note: ChangeOf<"setNote">): Promise<void> {
  const before = new Set(designer.drawing?.notes.map((one) => one.id));
  const value = { page: designer.state.page, id: "", ...note };
  const answer = await designer.edit(name, { case: "setNote", value });
  if (!answer.ok) return;
  const made = await onceDrawn(designer, () => designer.drawing?.notes.find((one) => !before.has(one.id))?.id);
  if (!made) return;
  designer.select([made]);
  canvasStore.setState({ writing: made });
}

export function addNote(designer: Designer): Promise<void> {
  const size = { width: 200, height: 80 };
  return makeNote(designer, "add a comment", { text: "Comment", ...size, ...freePlace(designer, "", size) });
}

const kFrameRoom = 24;

export function frameSelection(designer: Designer): void {
  const { drawing } = designer;
  const places = drawing && placesOf(drawing);
  if (!drawing || !places) return;
  const sizes = sizesOf(drawing);
  const boxes = selectionByKind(designer).nodes.flatMap((id) => {
    const at = places.get(id);
    const size = sizes.get(id);
    return at && size ? [{ ...at, right: at.x + size.width, bottom: at.y + size.height }] : [];
  });
  if (boxes.length === 0) {
    addFrameInView(designer);
    return;
  }
  const x = Math.min(...boxes.map((box) => box.x)) - kFrameRoom;
  const y = Math.min(...boxes.map((box) => box.y)) - kFrameRoom - 20;
  const width = Math.max(...boxes.map((box) => box.right)) + kFrameRoom - x;
  const height = Math.max(...boxes.map((box) => box.bottom)) + kFrameRoom - y;
  void makeNote(designer, "add a frame", { text: "Frame", x, y, width, height, isFrame: true });
}

function addFrameInView(designer: Designer): void {
  const { view } = canvasStore.getState();
  void makeNote(designer, "add a frame", {
    text: "Frame",
    x: onPitch(view.x + view.width / 4),
    y: onPitch(view.y + view.height / 4),
    width: onPitch(view.width / 2),
    height: onPitch(view.height / 2),
    isFrame: true,
  });
}

/** The nearest node in a direction becomes the selected one. */
export function walk(designer: Designer, dx: number, dy: number): void {
  const { drawing } = designer;
  const places = drawing && placesOf(drawing);
  if (!drawing || !places || places.size === 0) return;
  const from = selectionByKind(designer).nodes[0];
  const at = from ? places.get(from) : undefined;
  if (!at) {
    designer.select([[...places.keys()][0]!]);
    return;
  }
  let best = "";
  let least = Number.POSITIVE_INFINITY;
  for (const [name, to] of places) {
    const along = (to.x - at.x) * dx + (to.y - at.y) * dy;
    const across = Math.abs((to.x - at.x) * dy + (to.y - at.y) * dx);
    if (name === from || along <= 0) continue;
    const cost = along + 2 * across;
    if (cost < least) [best, least] = [name, cost];
  }
  if (best) {
    designer.select([best]);
    designer.say(best);
    showNode(designer, best);
  }
}
