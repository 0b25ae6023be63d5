// A Drawing as what the canvas shows: nodes with their sizes and handles, wires between them. Pure, and what did not
// change keeps its identity, so that only what changed is drawn anew.
import { type Edge, type Node as FlowNode, Position } from "@xyflow/react";
import { type Flow, flowOf } from "../../core/value_types.ts";
import {
  type Drawing,
  Drawing_Kind,
  kResult,
  type Node,
  type Note,
  type Port,
  type Wire,
} from "../session/protocol.ts";
import { type Form, formOf, rowId, type WiredInputs } from "./form.ts";

export interface NodePlace {
  readonly x: number;
  readonly y: number;
}
export type Places = ReadonlyMap<string, NodePlace>;

export interface NodeData extends Record<string, unknown> {
  node: Node;
  form: Form;
  page: string;
  isReadOnly: boolean;
}
export interface ResultData extends Record<string, unknown> {
  type: string;
  isFed: boolean;
}
export interface NoteData extends Record<string, unknown> {
  note: Note;
  isReadOnly: boolean;
}
export interface WireData extends Record<string, unknown> {
  wire: Wire;
  flow: Flow;
  page: string;
}
export type CanvasNode = FlowNode<NodeData, "node"> | FlowNode<ResultData, "result"> | FlowNode<NoteData, "note">;
export type CanvasWire = Edge<WireData, "wire">;

export const kResultWidth = 116;
export const kResultHeight = 44;
export const kHandle = 12;
export const kOutputHandle = "out";
const kGap = 72;

export function wiredInputsOf(drawing: Drawing): WiredInputs {
  const wired = new Map<string, Set<string>>();
  for (const wire of drawing.wires) {
    const rows = wired.get(wire.to) ?? new Set();
    wired.set(wire.to, rows.add(rowId(wire.port, wire.index)));
  }
  return wired;
}

export function wireId(wire: { to: string; port: string; index?: number | undefined }): string {
  return `${wire.to}/${rowId(wire.port, wire.index)}`;
}

/** Where the author put the nodes; those without a place are not in it. */
export function ownPlaces(drawing: Drawing): Map<string, NodePlace> {
  const places = new Map<string, NodePlace>();
  for (const node of drawing.nodes) {
    if (node.x !== undefined && node.y !== undefined) places.set(node.name, { x: node.x, y: node.y });
  }
  for (const state of drawing.states) {
    if (state.x !== undefined && state.y !== undefined) places.set(state.name, { x: state.x, y: state.y });
  }
  return places;
}

/** Whether the page has a place where its value goes. */
export function hasResult(drawing: Drawing): boolean {
  if (drawing.kind === Drawing_Kind.DATAFLOW) return true;
  return drawing.resultType !== "" || drawing.wires.some((wire) => wire.to === kResult);
}

/** Right of what gives the value, or of everything. */
export function resultPlace(drawing: Drawing, places: Places, wired: WiredInputs): NodePlace {
  let right = 0;
  let top = Number.POSITIVE_INFINITY;
  for (const node of drawing.nodes) {
    const at = places.get(node.name);
    if (!at) continue;
    right = Math.max(right, at.x + formOf(node, wired).width);
    top = Math.min(top, at.y);
  }
  if (drawing.nodes.length === 0) return { x: 520, y: 160 };
  const from = drawing.nodes.find((node) => node.name === drawing.resultNode);
  const at = from && places.get(from.name);
  if (from && at) {
    const form = formOf(from, wired);
    return { x: Math.max(right, at.x + form.width) + kGap, y: at.y + form.outputY - kResultHeight / 2 };
  }
  return { x: right + kGap, y: Number.isFinite(top) ? top : 0 };
}

/** The canvas's nodes; those of `before` that still hold are used again. `hidden`: not placed yet. */
export function nodesOf(drawing: Drawing, places: Places, before: readonly CanvasNode[]): CanvasNode[] {
  const known = new Map(before.map((one) => [one.id, one]));
  const wired = wiredInputsOf(drawing);
  const page = drawing.page?.path ?? "";
  const nodes: CanvasNode[] = drawing.notes.map((note) => noteOf(note, drawing.isReadOnly, known.get(note.id)));
  for (const node of drawing.nodes) {
    const at = places.get(node.name);
    if (at) nodes.push(nodeOf(node, formOf(node, wired), at, page, drawing.isReadOnly, known.get(node.name)));
  }
  if (hasResult(drawing)) {
    nodes.push(resultOf(drawing, resultPlace(drawing, places, wired), known.get(kResult)));
  }
  return nodes;
}

function nodeOf(
  node: Node,
  form: Form,
  at: NodePlace,
  page: string,
  isReadOnly: boolean,
  before: CanvasNode | undefined,
): CanvasNode {
  const old = before?.type === "node" ? before : undefined;
  const isSame =
    old !== undefined &&
    old.data.page === page &&
    old.data.isReadOnly === isReadOnly &&
    isSameForm(old.data.form, form) &&
    isSameNode(old.data.node, node);
  if (isSame && old.position.x === at.x && old.position.y === at.y) return old;
  const data: NodeData = isSame ? old.data : { node, form, page, isReadOnly };
  return {
    id: node.name,
    type: "node",
    position: { x: at.x, y: at.y },
    data,
    width: form.width,
    height: form.height,
    measured: { width: form.width, height: form.height },
    handles: handlesOf(form),
    draggable: !isReadOnly,
    selected: old?.selected ?? false,
  };
}

function handlesOf(form: Form): FlowNode["handles"] {
  const size = { width: kHandle, height: kHandle };
  const handles: NonNullable<FlowNode["handles"]> = form.rows.map((row) => ({
    id: row.id,
    type: "target" as const,
    position: Position.Left,
    x: -kHandle / 2,
    y: row.y - kHandle / 2,
    ...size,
  }));
  for (const extra of form.extras) {
    handles.push({
      id: extra.id,
      type: "target",
      position: Position.Left,
      x: -4,
      y: extra.y - 4,
      width: 8,
      height: 8,
    });
  }
  if (form.outputY >= 0) {
    handles.push({
      id: kOutputHandle,
      type: "source",
      position: Position.Right,
      x: form.width - kHandle / 2,
      y: form.outputY - kHandle / 2,
      ...size,
    });
  }
  return handles;
}

function resultOf(drawing: Drawing, at: NodePlace, before: CanvasNode | undefined): CanvasNode {
  const isFed = drawing.resultNode !== "" || drawing.wires.some((wire) => wire.to === kResult);
  const old = before?.type === "result" ? before : undefined;
  const isSame = old && old.data.type === drawing.resultType && old.data.isFed === isFed;
  if (isSame && old.position.x === at.x && old.position.y === at.y) return old;
  return {
    id: kResult,
    type: "result",
    position: { x: at.x, y: at.y },
    data: isSame ? old.data : { type: drawing.resultType, isFed },
    width: kResultWidth,
    height: kResultHeight,
    measured: { width: kResultWidth, height: kResultHeight },
    handles: [
      {
        id: "value",
        type: "target",
        position: Position.Left,
        x: -kHandle / 2,
        y: kResultHeight / 2 - kHandle / 2,
        width: kHandle,
        height: kHandle,
      },
    ],
    draggable: false,
    deletable: false,
    selectable: false,
    focusable: false,
  };
}

function noteOf(note: Note, isReadOnly: boolean, before: CanvasNode | undefined): CanvasNode {
  const old = before?.type === "note" ? before : undefined;
  const isSame = old && isSameNote(old.data.note, note) && old.data.isReadOnly === isReadOnly;
  if (isSame && old.position.x === note.x && old.position.y === note.y) return old;
  const width = note.width || 200;
  const height = note.height || 80;
  return {
    id: note.id,
    type: "note",
    position: { x: note.x, y: note.y },
    data: { note, isReadOnly },
    width,
    height,
    measured: { width, height },
    zIndex: note.isFrame ? -2 : -1,
    draggable: !isReadOnly,
    selected: old?.selected ?? false,
  };
}

/** The canvas's wires, the one to the page's value with them. */
export function wiresOf(drawing: Drawing, before: readonly CanvasWire[]): CanvasWire[] {
  const known = new Map(before.map((one) => [one.id, one]));
  const names = new Set(drawing.nodes.map((node) => node.name));
  const page = drawing.page?.path ?? "";
  const wires: CanvasWire[] = [];
  const taken = new Set<string>();
  let hasEnd = false;
  for (const wire of drawing.wires) {
    const isEnd = wire.to === kResult;
    hasEnd ||= isEnd;
    if (!names.has(wire.from) || !(isEnd || names.has(wire.to))) continue;
    // On the page of a file one input has many: all that a declaration uses.
    let id = isEnd ? kResult : wireId(wire);
    if (taken.has(id)) id = `${id}<${wire.from}`;
    if (taken.has(id)) continue;
    taken.add(id);
    wires.push(wireOf(wire, id, page, known.get(id)));
  }
  if (!hasEnd && names.has(drawing.resultNode)) {
    const from = drawing.nodes.find((node) => node.name === drawing.resultNode)!;
    const wire = {
      from: from.name,
      to: kResult,
      port: "value",
      type: from.type,
      unit: from.unit,
      live: from.live,
    } as Wire;
    wires.push(wireOf(wire, kResult, page, known.get(kResult)));
  }
  return wires;
}

function wireOf(wire: Wire, id: string, page: string, before: CanvasWire | undefined): CanvasWire {
  if (before && before.data?.page === page && isSameWire(before.data.wire, wire)) return before;
  const isEnd = wire.to === kResult;
  return {
    id,
    type: "wire",
    source: wire.from,
    sourceHandle: kOutputHandle,
    target: wire.to,
    targetHandle: isEnd ? "value" : rowId(wire.port, wire.index),
    data: { wire, flow: flowOf(wire.type), page },
    selected: before?.selected ?? false,
    reconnectable: "target",
  };
}

function isSameWire(a: Wire, b: Wire): boolean {
  return (
    a.from === b.from &&
    a.to === b.to &&
    a.port === b.port &&
    a.index === b.index &&
    a.type === b.type &&
    a.unit === b.unit &&
    a.live === b.live &&
    a.isActive === b.isActive
  );
}

function isSameNote(a: Note, b: Note): boolean {
  return (
    a.text === b.text &&
    a.x === b.x &&
    a.y === b.y &&
    a.width === b.width &&
    a.height === b.height &&
    a.isFrame === b.isFrame
  );
}

/** But for where they stand in the text and on the page. */
export function isSameNode(a: Node, b: Node): boolean {
  return (
    a.component === b.component &&
    a.shape === b.shape &&
    a.title === b.title &&
    a.help === b.help &&
    a.type === b.type &&
    a.unit === b.unit &&
    a.isLoose === b.isLoose &&
    a.count === b.count &&
    a.live === b.live &&
    a.icon === b.icon &&
    a.inner?.path === b.inner?.path &&
    a.inner?.document === b.inner?.document &&
    a.inputs.length === b.inputs.length &&
    a.inputs.every((port, i) => isSamePort(port, b.inputs[i]!))
  );
}

function isSamePort(a: Port, b: Port): boolean {
  return (
    a.name === b.name &&
    a.label === b.label &&
    a.type === b.type &&
    a.unit === b.unit &&
    a.value === b.value &&
    a.weight === b.weight &&
    a.weightWire === b.weightWire &&
    a.isExposed === b.isExposed &&
    a.isRequired === b.isRequired &&
    a.isMember === b.isMember &&
    a.isList === b.isList &&
    a.index === b.index &&
    a.initial === b.initial &&
    a.help === b.help &&
    a.min === b.min &&
    a.max === b.max &&
    a.choices.join() === b.choices.join()
  );
}

function isSameForm(a: Form, b: Form): boolean {
  return (
    a.width === b.width &&
    a.height === b.height &&
    a.rows.length === b.rows.length &&
    a.extras.length === b.extras.length &&
    a.extras.every((extra, i) => extra.id === b.extras[i]!.id) &&
    a.rows.every((row, i) => row.kind === b.rows[i]!.kind && row.value === b.rows[i]!.value)
  );
}
