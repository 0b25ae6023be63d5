// What a node looks like before it is drawn: its size, its rows, where its wires end. The canvas, automatic layout and
// the exported pictures all go by this, so they agree, and nothing has to be measured in the page.
import { type Node, Node_Shape, type Port } from "../session/protocol.ts";
import { widthOf } from "./text_width.ts";
import { withUnit } from "./value_words.ts";

export type Outline = "box" | "sum" | "arrow" | "octagon" | "hexagon" | "pill" | "tag" | "sink";
export type Tone =
  | "motor"
  | "sense"
  | "skill"
  | "operator"
  | "sequence"
  | "logic"
  | "value"
  | "body"
  | "society"
  | "unknown";

export interface Row {
  readonly port: Port;
  /** `readings`, `members[1]`; the id of its handle. */
  readonly id: string;
  readonly label: string;
  /** What is shown at its right: a constant, the default, a parameter's name. */
  readonly value: string;
  readonly kind: "given" | "default" | "parameter" | "wired" | "open" | "more" | "needed";
  /** Of its middle, from the node's top [px]. */
  readonly y: number;
}

export interface Form {
  readonly width: number;
  readonly height: number;
  readonly title: string;
  readonly subtitle: string;
  readonly symbol: string;
  readonly outline: Outline;
  readonly tone: Tone;
  readonly rows: readonly Row[];
  /** Inputs that have a wire but no row: weights of members, the part that moves a sensor, what uses what. */
  readonly extras: readonly { id: string; y: number }[];
  /** Of the output's middle, from the top [px]; negative: it has none. */
  readonly outputY: number;
}

export const kRowHeight = 24;
export const kHeadHeight = 40;
const kSmallHeight = 32;
const kFoot = 6;
const kMinWidth = 148;
const kMaxWidth = 300;
const kSymbolWidth = 44;

interface Appearance {
  outline: Outline;
  tone: Tone;
  symbol: string;
  kind: string;
}

const kLooks: Record<Node_Shape, Appearance> = {
  [Node_Shape.BEHAVIOR]: { outline: "box", tone: "motor", symbol: "", kind: "motor schema" },
  [Node_Shape.PERCEPTION]: { outline: "box", tone: "sense", symbol: "", kind: "perception" },
  [Node_Shape.ASSEMBLAGE]: { outline: "box", tone: "skill", symbol: "", kind: "assemblage" },
  [Node_Shape.BINDING]: { outline: "box", tone: "body", symbol: "", kind: "binding point" },
  [Node_Shape.COOPERATION]: { outline: "sum", tone: "operator", symbol: "Σ", kind: "cooperation" },
  [Node_Shape.COMPETITION]: { outline: "arrow", tone: "operator", symbol: "1st", kind: "competition" },
  [Node_Shape.SEQUENCE]: { outline: "octagon", tone: "sequence", symbol: "⟳", kind: "sequence" },
  [Node_Shape.COORDINATION]: { outline: "hexagon", tone: "operator", symbol: "@", kind: "coordination" },
  [Node_Shape.FUSION]: { outline: "hexagon", tone: "sense", symbol: "#", kind: "fusion" },
  [Node_Shape.SELECTION]: { outline: "arrow", tone: "sequence", symbol: "?", kind: "selection" },
  [Node_Shape.LOGIC]: { outline: "pill", tone: "logic", symbol: "", kind: "logic" },
  [Node_Shape.DELAY]: { outline: "box", tone: "logic", symbol: "z⁻¹", kind: "delay" },
  [Node_Shape.PARAMETER]: { outline: "tag", tone: "value", symbol: "", kind: "parameter" },
  [Node_Shape.UNKNOWN]: { outline: "box", tone: "unknown", symbol: "", kind: "unknown" },
  [Node_Shape.ACTUATOR]: { outline: "sink", tone: "body", symbol: "", kind: "actuator" },
  [Node_Shape.DECLARATION]: { outline: "box", tone: "skill", symbol: "", kind: "declaration" },
  [Node_Shape.ROBOT]: { outline: "box", tone: "body", symbol: "", kind: "robot" },
  [Node_Shape.TEAM]: { outline: "box", tone: "society", symbol: "", kind: "team" },
  [Node_Shape.CASTE]: { outline: "octagon", tone: "society", symbol: "", kind: "caste" },
  [Node_Shape.SOCIETY]: { outline: "octagon", tone: "society", symbol: "", kind: "society" },
  [Node_Shape.FORMULA]: { outline: "box", tone: "value", symbol: "", kind: "formula" },
  [Node_Shape.BODY]: { outline: "box", tone: "value", symbol: "", kind: "part of the body" },
  [Node_Shape.SENSOR]: { outline: "box", tone: "sense", symbol: "", kind: "sensor" },
};

const kDeclarations: Record<string, Tone> = {
  robot: "body",
  class: "body",
  binding: "sense",
  society: "society",
  operator: "operator",
};

/** What kind of thing it is, in words. */
export function kindOf(shape: Node_Shape): string {
  return kLooks[shape]?.kind ?? "node";
}

export function toneOf(shape: Node_Shape): Tone {
  return kLooks[shape]?.tone ?? "unknown";
}

export function symbolOf(shape: Node_Shape): string {
  return kLooks[shape]?.symbol ?? "";
}

export function isOperator(shape: Node_Shape): boolean {
  return (
    shape === Node_Shape.COOPERATION ||
    shape === Node_Shape.COMPETITION ||
    shape === Node_Shape.COORDINATION ||
    shape === Node_Shape.FUSION ||
    shape === Node_Shape.SELECTION
  );
}

/** Which inputs have wires, by node: `readings`, as rowId. */
export type WiredInputs = ReadonlyMap<string, ReadonlySet<string>>;

/** `readings`, `members[1]`: what the input is called in handles and wires. */
export function rowId(port: string, index?: number): string {
  return index === undefined ? port : `${port}[${index}]`;
}

/** The port and index of a row's id. */
export function portOf(id: string): { port: string; index?: number } {
  const found = /^(.*)\[(\d+)\]$/.exec(id);
  return found ? { port: found[1]!, index: Number(found[2]) } : { port: id };
}

const kNothing: ReadonlySet<string> = new Set();
const known = new WeakMap<Node, { key: string; form: Form }>();

export function formOf(node: Node, wired: WiredInputs): Form {
  const own = wired.get(node.name) ?? kNothing;
  const key = [...own].join();
  const before = known.get(node);
  if (before?.key === key) return before.form;
  const form = shape(node, own);
  known.set(node, { key, form });
  return form;
}

function shape(node: Node, wired: ReadonlySet<string>): Form {
  const look = kLooks[node.shape] ?? kLooks[Node_Shape.UNKNOWN];
  const { title, subtitle } = namesOf(node, look.kind);
  const tone = node.shape === Node_Shape.DECLARATION ? (kDeclarations[node.component] ?? look.tone) : look.tone;
  const isSmall = node.inputs.length === 0 && (look.outline === "tag" || look.outline === "pill");
  const head = isSmall ? kSmallHeight : kHeadHeight;
  const rows = node.inputs.map((port, i) => rowOf(port, wired, head + i * kRowHeight + kRowHeight / 2));
  const symbol = look.symbol === "" ? 0 : kSymbolWidth;
  const icon = 34;
  const enter = node.inner ? 18 : 0; // the button that looks inside
  const wanted = Math.max(
    kMinWidth,
    icon + widthOf(title, 13, true) + 30 + enter,
    icon + widthOf(subtitle, 11) + 30 + enter,
    ...rows.map(
      (row) =>
        30 + widthOf(row.label, 12) + (row.value ? 20 + Math.min(110, widthOf(row.value, 12)) : 8) + weightWidth(row),
    ),
  );
  const width = even(Math.min(kMaxWidth, wanted + symbol + (look.outline === "box" ? 0 : 14)));
  const height = head + rows.length * kRowHeight + (rows.length > 0 ? kFoot : 0);
  const outputY = node.type === "" && !isUsed(node.shape) ? -1 : head / 2;
  return {
    width,
    height,
    title,
    subtitle,
    symbol: look.symbol,
    outline: look.outline,
    tone,
    rows,
    extras: extrasOf(rows, wired, head / 2),
    outputY,
  };
}

/** What has no value and is used all the same. */
function isUsed(shape: Node_Shape): boolean {
  return (shape >= Node_Shape.DECLARATION && shape <= Node_Shape.FORMULA) || shape === Node_Shape.UNKNOWN;
}

function extrasOf(rows: readonly Row[], wired: ReadonlySet<string>, headY: number): { id: string; y: number }[] {
  return [...wired]
    .filter((id) => !rows.some((row) => row.id === id))
    .map((id) => {
      const { port, index } = portOf(id);
      const member = port === "weight" ? rows.find((row) => row.port.isMember && row.port.index === index) : undefined;
      return { id, y: member ? member.y + 6 : headY };
    });
}

function weightWidth(row: Row): number {
  return row.port.isMember ? 46 : 0;
}

/** A name that only repeats the component's is not said twice. */
function namesOf(node: Node, kind: string): { title: string; subtitle: string } {
  const title = node.title || node.name;
  const component = node.component;
  if (component && component !== title)
    return { title, subtitle: node.count > 1 ? `${node.count} × ${component}` : component };
  return { title, subtitle: node.count > 1 ? `${node.count} robots` : kind };
}

function rowOf(port: Port, wired: ReadonlySet<string>, y: number): Row {
  const id = rowId(port.name, port.index);
  const base = { port, id, y };
  const label = rowLabel(port);
  if (port.isList && port.index === undefined && !port.value && !wired.has(id)) {
    return { ...base, label, value: "", kind: "more" };
  }
  if (port.isExposed) return { ...base, label, value: port.value || port.name, kind: "parameter" };
  if (wired.has(id)) return { ...base, label, value: "", kind: "wired" };
  if (port.value !== "") return { ...base, label, value: withUnit(port.value, port.unit), kind: "given" };
  if (port.initial !== "") return { ...base, label, value: withUnit(port.initial, port.unit), kind: "default" };
  return { ...base, label, value: "", kind: port.isRequired ? "needed" : "open" };
}

/** What an input is called, in the drawing and in words. */
export function rowLabel(port: Port): string {
  return port.label || (port.isMember ? `member ${(port.index ?? 0) + 1}` : rowName(port));
}

function rowName(port: Port): string {
  const name = port.name.replaceAll("_", " ");
  return port.index === undefined ? name : `${name} ${port.index + 1}`;
}

function even(value: number): number {
  return Math.ceil(value / 8) * 8;
}
