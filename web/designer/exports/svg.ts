// A drawing as SVG that stands alone: what the canvas shows, from the same forms, without the page.

import { flowOf } from "../../core/value_types.ts";
import {
  hasResult,
  kResultHeight,
  kResultWidth,
  type Places,
  resultPlace,
  wiredInputsOf,
  wireId,
} from "../drawing/flow.ts";
import { type Form, formOf } from "../drawing/form.ts";
import { outlinePath } from "../drawing/outline.ts";
import { kFont } from "../drawing/text_width.ts";
import { wirePath } from "../drawing/wire_path.ts";
import { type Drawing, Drawing_Kind, kResult } from "../session/protocol.ts";
import type { Rect } from "../states/curve.ts";
import { curveOf, labelMarks, transitionRoutes } from "../states/flow.ts";
import { stateSize } from "../states/form.ts";
import { labelLines, labelSize } from "../states/label.ts";

const kMargin = 32;
/** Where a way is asked how far out it leads: ways bow out of what the nodes take. */
const kAlong = Array.from({ length: 17 }, (_, i) => i / 16);
const kFlowColors = {
  movement: "#1d5fc4",
  flag: "#a85b00",
  number: "#5b6675",
  percept: "#14713f",
  thing: "#9a2f86",
  text: "#7a4d00",
};
const kToneColors: Record<string, string> = {
  motor: "#1d5fc4",
  sense: "#14713f",
  skill: "#6a3fb5",
  operator: "#a85b00",
  sequence: "#0f6f7c",
  logic: "#5b6675",
  value: "#5b6675",
  body: "#39495e",
  society: "#9a2f86",
  unknown: "#c01f1f",
};

export function drawingAsSvg(
  drawing: Drawing,
  places: Places,
  title: string,
): { svg: string; width: number; height: number } {
  const parts = drawing.kind === Drawing_Kind.STATES ? statesSvg(drawing, places) : dataflowSvg(drawing, places);
  for (const note of drawing.notes)
    parts.boxes.push({ x: note.x, y: note.y, width: note.width || 200, height: note.height || 80 });
  const notes = drawing.notes.map((note) => noteSvg(note));
  const bounds = boundsOf(parts.boxes);
  const width = Math.ceil(bounds.width + 2 * kMargin);
  const height = Math.ceil(bounds.height + 2 * kMargin);
  const origin = `translate(${kMargin - bounds.x} ${kMargin - bounds.y})`;
  const svg = [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" font-family="${escaped(kFont)}">`,
    `<title>${escaped(title)}</title>`,
    `<defs><marker id="arrow" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="9" markerHeight="9" markerUnits="userSpaceOnUse" orient="auto"><path d="M0 0L10 5L0 10z" fill="#4d5766"/></marker></defs>`,
    `<rect width="100%" height="100%" fill="#ffffff"/>`,
    `<g transform="${origin}">`,
    ...notes,
    ...parts.lines,
    "</g>",
    "</svg>",
    "",
  ].join("\n");
  return { svg, width, height };
}

interface Parts {
  lines: string[];
  boxes: Rect[];
}

function dataflowSvg(drawing: Drawing, places: Places): Parts {
  const wired = wiredInputsOf(drawing);
  const forms = new Map(drawing.nodes.map((node) => [node.name, formOf(node, wired)]));
  const lines: string[] = [];
  const boxes: Rect[] = [];
  const end = hasResult(drawing) ? resultPlace(drawing, places, wired) : undefined;
  const wires = drawing.wires.map((wire) => ({
    from: wire.from,
    to: wire.to,
    row: wireId(wire).slice(wire.to.length + 1),
    type: wire.type,
  }));
  if (end && drawing.resultNode && !wires.some((wire) => wire.to === kResult)) {
    wires.push({ from: drawing.resultNode, to: kResult, row: "value", type: drawing.resultType });
  }
  for (const wire of wires) {
    const from = places.get(wire.from);
    const out = forms.get(wire.from);
    const at = wire.to === kResult ? end : places.get(wire.to);
    const y = wire.to === kResult ? kResultHeight / 2 : inputY(forms.get(wire.to), wire.row);
    if (!from || !out || !at || y === undefined) continue;
    const { path, reach } = wirePath({ x: from.x + out.width, y: from.y + out.outputY }, { x: at.x, y: at.y + y });
    boxes.push({ ...reach, height: 0 });
    lines.push(`<path d="${path}" fill="none" stroke="${kFlowColors[flowOf(wire.type)]}" stroke-width="2"/>`);
  }
  for (const node of drawing.nodes) {
    const at = places.get(node.name);
    const form = forms.get(node.name)!;
    if (!at) continue;
    boxes.push({ ...at, width: form.width, height: form.height });
    lines.push(nodeSvg(form, at.x, at.y));
  }
  if (end) {
    boxes.push({ ...end, width: kResultWidth, height: kResultHeight });
    lines.push(
      `<g transform="translate(${end.x} ${end.y})"><path d="${outlinePath("sink", kResultWidth, kResultHeight)}" fill="#f5f6f8" stroke="#4d5766" stroke-width="1.5"/>`,
      text("Result", 22, 19, 13, "#1b212b", true),
      text(drawing.resultType, 22, 34, 11, "#4d5766"),
      "</g>",
    );
  }
  return { lines, boxes };
}

function inputY(form: Form | undefined, row: string): number | undefined {
  return [...(form?.rows ?? []), ...(form?.extras ?? [])].find((one) => one.id === row)?.y;
}

function nodeSvg(form: Form, x: number, y: number): string {
  const color = kToneColors[form.tone] ?? "#4d5766";
  const isSmall = form.outputY === 16;
  const lines = [
    `<g transform="translate(${x} ${y})">`,
    `<path d="${outlinePath(form.outline, form.width, form.height)}" fill="#ffffff" stroke="${color}" stroke-width="1.5"/>`,
    text(form.title, 14, isSmall ? 21 : 18, 13, "#1b212b", true),
    isSmall ? "" : text(form.subtitle, 14, 32, 11, "#4d5766"),
  ];
  if (form.symbol) lines.push(text(form.symbol, form.width - 22, isSmall ? 21 : 25, 16, color, true, "end"));
  for (const row of form.rows) {
    const port = kFlowColors[flowOf(row.port.type)];
    lines.push(
      `<circle cx="0" cy="${row.y}" r="4.5" fill="${row.kind === "wired" ? port : "#ffffff"}" stroke="${port}" stroke-width="1.5"/>`,
    );
    lines.push(text(row.label, 14, row.y + 4, 12, "#4d5766"));
    const value = row.port.isMember ? `× ${row.port.weightWire || row.port.weight || "1"}` : row.value;
    if (value && row.kind !== "more") lines.push(text(value, form.width - 14, row.y + 4, 12, "#1b212b", false, "end"));
  }
  if (form.outputY >= 0) lines.push(`<circle cx="${form.width}" cy="${form.outputY}" r="5" fill="${color}"/>`);
  lines.push("</g>");
  return lines.filter((line) => line !== "").join("\n");
}

function statesSvg(drawing: Drawing, places: Places): Parts {
  const lines: string[] = [];
  const boxes: Rect[] = [];
  const rects = new Map<string, Rect>();
  for (const state of drawing.states) {
    const at = places.get(state.name);
    if (at) rects.set(state.name, { ...at, ...stateSize(state) });
  }
  const { routes } = transitionRoutes(drawing, places);
  const labels: string[] = [];
  drawing.transitions.forEach((transition, i) => {
    const [from, to] = [rects.get(transition.from), rects.get(transition.to)];
    if (!from || !to) return;
    const route = routes[i]!;
    const curve = curveOf(transition, route, from, to);
    lines.push(`<path d="${curve.path}" fill="none" stroke="#4d5766" stroke-width="1.5" marker-end="url(#arrow)"/>`);
    const siblings = drawing.transitions.filter((one) => one.from === transition.from).length;
    const written = labelLines(transition.trigger, route.isShort);
    const size = labelSize(written, labelMarks(transition, siblings));
    boxes.push(...kAlong.map((share) => ({ ...curve.pointAt(share), width: 0, height: 0 })));
    const middle = curve.pointAt(route.at);
    const box = { x: middle.x - size.width / 2, y: middle.y - size.height / 2, ...size };
    labels.push(labelSvg(box, written, siblings > 1 ? `${transition.index + 1}` : "", transition.restarts));
    boxes.push(box);
  });
  for (const state of drawing.states) {
    const rect = rects.get(state.name);
    if (!rect) continue;
    boxes.push({ ...rect, x: rect.x - (state.isStart ? 34 : 0), width: rect.width + (state.isStart ? 34 : 0) });
    lines.push(
      `<g transform="translate(${rect.x} ${rect.y})"><rect width="${rect.width}" height="${rect.height}" rx="16" fill="#ffffff" stroke="#0f6f7c" stroke-width="${state.isStart ? 2.5 : 1.5}"/>`,
      state.isFinal
        ? `<rect x="4" y="4" width="${rect.width - 8}" height="${rect.height - 8}" rx="12" fill="none" stroke="#0f6f7c"/>`
        : "",
      state.isStart
        ? `<circle cx="-26" cy="${rect.height / 2}" r="5" fill="#0f6f7c"/><path d="M-21 ${rect.height / 2}H-2" stroke="#0f6f7c" stroke-width="1.5" marker-end="url(#arrow)"/>`
        : "",
      text(state.name, rect.width / 2, 29, 14, "#1b212b", true, "middle"),
      text(shortened(state.title || state.member, 40), rect.width / 2, 46, 11, "#4d5766", false, "middle"),
      "</g>",
    );
  }
  return { lines: [...lines, ...labels], boxes };
}

function labelSvg(box: Rect, written: readonly string[], order: string, isAnew: boolean): string {
  const left = box.x + 10 + (order ? 20 : 0);
  const top = box.y + box.height / 2 - written.length * 8;
  return [
    `<rect x="${box.x}" y="${box.y}" width="${box.width}" height="${box.height}" rx="12" fill="#ffffff" stroke="#aab3c0"/>`,
    order ? `<circle cx="${box.x + 17}" cy="${box.y + box.height / 2}" r="7.5" fill="#0f6f7c"/>` : "",
    text(order, box.x + 17, box.y + box.height / 2 + 3.5, 10, "#ffffff", true, "middle"),
    ...written.map((line, i) => mono(line, left, top + 12 + i * 16)),
    isAnew ? text("↻", box.x + box.width - 16, box.y + box.height / 2 + 4, 12, "#1b212b") : "",
  ]
    .filter((line) => line !== "")
    .join("\n");
}

function mono(line: string, x: number, y: number): string {
  return `<text x="${x}" y="${y}" font-size="12" font-family="monospace" fill="#1b212b" xml:space="preserve">${escaped(line)}</text>`;
}

function noteSvg(note: {
  text: string;
  x: number;
  y: number;
  width: number;
  height: number;
  isFrame: boolean;
}): string {
  const style = note.isFrame
    ? `fill="#f5f6f8" stroke="#8a94a3" stroke-dasharray="6 4"`
    : `fill="#fdf0d5" stroke="#e6cf9b"`;
  const lines = note.text
    .split("\n")
    .map((line, i) => text(line, note.x + 10, note.y + 20 + i * 16, 12, "#4d5766", note.isFrame));
  return `<rect x="${note.x}" y="${note.y}" width="${note.width || 200}" height="${note.height || 80}" rx="8" ${style}/>\n${lines.join("\n")}`;
}

function text(
  content: string,
  x: number,
  y: number,
  size: number,
  fill: string,
  isBold = false,
  anchor = "start",
): string {
  if (content === "") return "";
  return `<text x="${x}" y="${y}" font-size="${size}" fill="${fill}"${isBold ? ' font-weight="650"' : ""}${anchor === "start" ? "" : ` text-anchor="${anchor}"`}>${escaped(content)}</text>`;
}

function shortened(content: string, most: number): string {
  return content.length > most ? `${content.slice(0, most - 1)}…` : content;
}

function boundsOf(boxes: readonly Rect[]): Rect {
  if (boxes.length === 0) return { x: 0, y: 0, width: 200, height: 100 };
  const x = Math.min(...boxes.map((box) => box.x));
  const y = Math.min(...boxes.map((box) => box.y));
  const right = Math.max(...boxes.map((box) => box.x + box.width));
  const bottom = Math.max(...boxes.map((box) => box.y + box.height));
  return { x, y, width: right - x, height: bottom - y };
}

function escaped(content: string): string {
  return content.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
}
