import { useEffect, useMemo } from "react";
import { layOut } from "../arrange/layout.ts";
import { placeNew, type SizedNode } from "../arrange/place_new.ts";
import { withoutGhost } from "../compare/compared.ts";
import { type NodePlace, ownPlaces, type Places, wiredInputsOf } from "../drawing/flow.ts";
import { formOf } from "../drawing/form.ts";
import { pageKey } from "../session/pages.ts";
import { type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { stateSize } from "../states/form.ts";
import { canvasStore, useCanvas } from "./canvas_store.ts";

/** Of nodes that the file says nothing of, by page: what automatic layout said. */
const laidOut = new Map<string, Map<string, NodePlace>>();

interface MovedPlaces {
  /** Of the document when they were moved: a later drawing knows better. */
  revision: bigint;
  places: Map<string, NodePlace>;
}
/** What was moved here and is on its way to the server. */
const moved = new Map<string, MovedPlaces>();

/** Where everything on the page stands; null while that is being worked out. */
export function usePlaces(drawing: Drawing): Places | null {
  const moves = useCanvas((state) => state.moves);
  // `moves` says that what placesOf reads has changed
  const places = useMemo(() => placesOf(drawing), [drawing, moves]);
  const isWhole = places !== null;
  useEffect(() => {
    if (!isWhole) void laidOutPlaces(drawing);
  }, [drawing, isWhole]);
  return places;
}

/** As placesOf, once everything has a place: a layout that is being worked out is waited for. */
export async function wholePlaces(drawing: Drawing): Promise<Places> {
  return placesOf(drawing) ?? laidOutPlaces(drawing);
}

const underWay = new WeakMap<Drawing, Promise<Places>>();

function laidOutPlaces(drawing: Drawing): Promise<Places> {
  const before = underWay.get(drawing);
  if (before) return before;
  const places = layOut(drawing).then((spots) => {
    const key = keyOf(drawing);
    const own = ownPlaces(drawing);
    const known = new Map([...(laidOut.get(key) ?? []), ...own].filter(([name]) => sizesOf(drawing).has(name)));
    const automatic = placeNew(known, spots, [...sizesOf(drawing).values()]);
    laidOut.set(key, automatic);
    underWay.delete(drawing);
    tellMoved();
    return placesOf(drawing) ?? automatic;
  });
  underWay.set(drawing, places);
  return places;
}

/** As drawn now, or null where something has no place yet. */
export function placesOf(drawing: Drawing): Places | null {
  const key = keyOf(drawing);
  const places = ownPlaces(drawing);
  const automatic = laidOut.get(key);
  const sizes = sizesOf(drawing);
  for (const name of sizes.keys()) {
    if (places.has(name)) continue;
    // What has just gone stays where it stood, unless something else is called so by now.
    const before = withoutGhost(name);
    const at = automatic?.get(name) ?? (sizes.has(before) ? undefined : automatic?.get(before));
    if (!at) return null;
    places.set(name, at);
  }
  const here = moved.get(key);
  if (here && here.revision >= drawing.revision) for (const [name, at] of here.places) places.set(name, at);
  return places;
}

/** Whether the file says where everything stands. */
export function isArranged(drawing: Drawing): boolean {
  return ownPlaces(drawing).size === sizesOf(drawing).size;
}

export function keepMoved(drawing: Drawing, places: ReadonlyMap<string, NodePlace>): void {
  const before = moved.get(keyOf(drawing));
  const same = before && before.revision >= drawing.revision ? before.places : [];
  moved.set(keyOf(drawing), { revision: drawing.revision, places: new Map([...same, ...places]) });
  tellMoved();
}

/** A page that the file does not arrange is laid out as a whole again: it holds other things than before. */
export function layOutAnew(drawing: Drawing): void {
  laidOut.delete(keyOf(drawing));
  tellMoved();
}

export function forgetMoved(drawing: Drawing): void {
  moved.delete(keyOf(drawing));
  tellMoved();
}

function tellMoved(): void {
  canvasStore.setState(({ moves }) => ({ moves: moves + 1 }));
}

export function sizesOf(drawing: Drawing): Map<string, SizedNode> {
  const sizes = new Map<string, SizedNode>();
  if (drawing.kind === Drawing_Kind.STATES) {
    for (const state of drawing.states) sizes.set(state.name, { id: state.name, ...stateSize(state) });
    return sizes;
  }
  const wired = wiredInputsOf(drawing);
  for (const node of drawing.nodes) {
    const { width, height } = formOf(node, wired);
    sizes.set(node.name, { id: node.name, width, height });
  }
  return sizes;
}

function keyOf(drawing: Drawing): string {
  return pageKey(drawing.page?.document ?? "", drawing.page?.path ?? "");
}
