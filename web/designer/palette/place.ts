// Puts a component on the page that is shown.

import { placeAtSide, sideOf } from "../arrange/beside.ts";
import { onPitch } from "../arrange/elk.ts";
import { rowId } from "../drawing/form.ts";
import type { Designer } from "../session/designer.ts";
import { onceDrawn } from "../session/once_drawn.ts";
import { type ChangeInit, Drawing_Kind } from "../session/protocol.ts";
import type { Placing } from "../session/state.ts";
import { canvasStore } from "../sight/canvas_store.ts";
import { placesOf, sizesOf } from "../sight/use_places.ts";
import { camera } from "../sight/view.ts";
import { connectChange } from "../sight/wiring.ts";
import { dropTrigger, isTriggerHere, selectedTransition } from "../states/drop_trigger.ts";
import { memberOf, stateName } from "../states/member.ts";

/** As large as most nodes; how large a new one is shows only when it is there. */
const kUsual = { width: 200, height: 60 };

/**
 * Where a new node comes that nobody said a place for: beside the one that is selected, else in the middle of what is in
 * sight; not on another one.
 */
export function freePlace(designer: Designer, component = "", { width, height } = kUsual): { x: number; y: number } {
  const { view } = canvasStore.getState();
  const drawing = designer.drawing;
  const wished = besideSelected(designer, component, { width, height });
  const x = onPitch(wished?.x ?? view.x + view.width / 2 - 90);
  let y = onPitch(wished?.y ?? view.y + view.height / 2 - 40);
  const places = drawing ? placesOf(drawing) : null;
  if (!drawing || !places) return { x, y };
  const sizes = sizesOf(drawing);
  for (let moved = true; moved; ) {
    moved = false;
    for (const [name, at] of places) {
      const size = sizes.get(name);
      if (!size || x + width < at.x || at.x + size.width < x || y + height < at.y || at.y + size.height + 16 < y)
        continue;
      y = onPitch(at.y + size.height + 32);
      moved = true;
    }
  }
  return { x, y };
}

function besideSelected(designer: Designer, component: string, size: { width: number; height: number }) {
  const { selection, palettes, document } = designer.state;
  const { drawing } = designer;
  const node = selection.length === 1 ? drawing?.nodes.find(({ name }) => name === selection[0]) : undefined;
  const known = palettes[document]?.components.find(({ name }) => name === component);
  // The language's own operators take anything.
  const placed = known?.group === "Operators" ? { type: known.type, inputs: [{ type: "" }] } : known;
  const at = node && drawing && placesOf(drawing)?.get(node.name);
  const box = node && drawing && sizesOf(drawing).get(node.name);
  return placed && at && box ? placeAtSide(sideOf(node, placed), { ...at, ...box }, size) : undefined;
}

export async function place(designer: Designer, component: string, placing: Placing | null): Promise<boolean> {
  const { page } = designer.state;
  const drawing = designer.drawing;
  if (!drawing) return false;
  if (placing?.page !== undefined && placing.page !== page) return placeBeside(designer, component, placing);
  const { x, y } = placing ?? freePlace(designer, component);
  if (isTriggerHere(designer, component)) return dropTrigger(designer, component, selectedTransition(designer));
  if (drawing.kind === Drawing_Kind.STATES) return placeState(designer, component, placing?.replace ?? "", { x, y });
  if (placing?.replace) {
    return (await designer.edit("", { case: "replace", value: { page, node: placing.replace, component } })).ok;
  }
  const to = placing?.to ? { toNode: placing.to.node, toPort: placing.to.port } : {};
  const before = new Set(drawing.nodes.map((node) => node.name));
  const change: ChangeInit = { case: "place", value: { page, component, x, y, ...to } };
  const answer = await designer.edit(`place ${component}`, change);
  if (!answer.ok) return false;
  // The drawing with it may come a moment after the answer.
  const made = await newNode(designer, before);
  if (made) {
    designer.select([made]);
    designer.say(`Placed ${made}`);
    showNode(designer, made);
    if (placing?.from) await connectFrom(designer, placing.from, made);
  }
  return true;
}

/** On a page that is not shown: what drives an input there. */
async function placeBeside(designer: Designer, component: string, { page = "", to }: Placing): Promise<boolean> {
  const end = to ? { toNode: to.node, toPort: to.port } : {};
  const answer = await designer.edit(`place ${component}`, { case: "place", value: { page, component, ...end } });
  if (answer.ok) designer.say(`Placed ${component}`);
  return answer.ok;
}

/** Moves the canvas to a node that is not wholly in sight. */
export function showNode(designer: Designer, name: string): void {
  const drawing = designer.drawing;
  const at = drawing && placesOf(drawing)?.get(name);
  const size = drawing && sizesOf(drawing).get(name);
  const { view } = canvasStore.getState();
  const flow = camera();
  if (!at || !size || !flow) return;
  const isInside =
    at.x >= view.x &&
    at.y >= view.y &&
    at.x + size.width <= view.x + view.width &&
    at.y + size.height <= view.y + view.height;
  if (isInside) return;
  void flow.setCenter(at.x + size.width / 2, at.y + size.height / 2, { zoom: flow.getZoom(), duration: 200 });
}

/** A new state that does this, or a state does it from now on. */
export async function placeState(
  designer: Designer,
  component: string,
  replaced: string,
  at: { x: number; y: number },
): Promise<boolean> {
  const { page } = designer.state;
  const member = memberOf(component);
  if (replaced) {
    const value = { page, state: replaced, member };
    return (await designer.edit(`change what ${replaced} does`, { case: "setState", value })).ok;
  }
  const taken = designer.drawing?.states.map((one) => one.name) ?? [];
  const name = stateName(component, taken);
  const add: ChangeInit = { case: "addState", value: { page, name, ...at } };
  const set: ChangeInit = { case: "setState", value: { page, state: name, member } };
  const answer = await designer.edit(`add state ${name}`, add, set);
  if (answer.ok) designer.select([name]);
  return answer.ok;
}

function newNode(designer: Designer, before: ReadonlySet<string>): Promise<string | undefined> {
  return onceDrawn(designer, () => designer.drawing?.nodes.find((node) => !before.has(node.name))?.name);
}

/** To the first input of the new node that the output fits. */
async function connectFrom(designer: Designer, from: string, made: string): Promise<void> {
  const { document, page } = designer.state;
  const answer = await designer.link.ask({ case: "fits", value: { document, page, fromNode: from } });
  if (answer.result.case !== "fits") return;
  const fit = answer.result.value.fits.find((one) => one.node === made && one.reason === "");
  if (!fit) {
    designer.tell(`Nothing of ${made} takes what ${from} gives.`, "hold");
    return;
  }
  await designer.edit("", connectChange(page, from, made, rowId(fit.port, fit.index)));
}
