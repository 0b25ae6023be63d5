// The canvas's camera, for actions that move it.
import { getViewportForBounds, type ReactFlowInstance, type Viewport } from "@xyflow/react";
import { curveOf, labelMarks, type TransitionEdge } from "../states/flow.ts";
import { pathOf } from "../states/geometry.ts";
import { labelSize } from "../states/label.ts";

/** Everything is seen, and nothing of it stands below the tools at the left. */
export const kFit = {
  padding: { left: "64px", right: "40px", top: "28px", bottom: "28px" },
  maxZoom: 1,
} as const;

/** No page is looked at from farther away [zoom]. */
export const kFarthest = 0.02;

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

export function boundsOf(
  nodes: readonly { position: { x: number; y: number }; width?: number; height?: number }[],
): Box | null {
  if (nodes.length === 0) return null;
  const x = Math.min(...nodes.map((node) => node.position.x));
  const y = Math.min(...nodes.map((node) => node.position.y));
  const right = Math.max(...nodes.map((node) => node.position.x + (node.width ?? 0)));
  const bottom = Math.max(...nodes.map((node) => node.position.y + (node.height ?? 0)));
  return { x, y, width: right - x, height: bottom - y };
}

/** Of the nodes, and of the ways between states with what is written at them. */
function seenBounds(flow: ReactFlowInstance): Box | null {
  const nodes = flow.getNodes();
  const boxes = new Map(nodes.map((node) => [node.id, boxOf(node)]));
  const seen = [...boxes.values()];
  for (const edge of flow.getEdges()) {
    const [from, to] = [boxes.get(edge.source), boxes.get(edge.target)];
    if (edge.type !== "transition" || !edge.data || !from || !to) continue;
    const { transition, route, lines, scale, siblings } = edge.data as NonNullable<TransitionEdge["data"]>;
    const curve = curveOf(transition, route, from, to);
    const size = labelSize(lines, labelMarks(transition, siblings), scale);
    const { x, y } = curve.pointAt(route.at);
    seen.push(...pathOf(curve).map((at) => ({ ...at, width: 0, height: 0 })));
    seen.push({ x: x - size.width / 2, y: y - size.height / 2, ...size });
  }
  return boundsOf(seen.map(({ x, y, width, height }) => ({ position: { x, y }, width, height })));
}

function boxOf({
  position,
  width = 0,
  height = 0,
}: {
  position: Box | { x: number; y: number };
  width?: number;
  height?: number;
}): Box {
  return { x: position.x, y: position.y, width, height };
}

/** Everything is brought into sight; done once it is there, `duration` [ms] later. */
export async function fitAll(flow: ReactFlowInstance, duration = 0): Promise<void> {
  const bounds = seenBounds(flow);
  const canvas = canvasSize();
  if (bounds && canvas) await flow.setViewport(whole(bounds, canvas), { duration });
}

/** As fitAll, but where that could not be read because of the panes around the canvas, a part of it that can. */
export async function fitReadably(flow: ReactFlowInstance): Promise<void> {
  const bounds = seenBounds(flow);
  const canvas = canvasSize();
  if (!bounds || !canvas) return;
  const chosen = boundsOf(flow.getNodes().filter((node) => node.selected));
  const legible = flow.getNodes().some(({ type }) => type === "state") ? kLegibleStates : kTolerable;
  await flow.setViewport(readableView(bounds, canvas, { width: innerWidth, height: innerHeight }, chosen, legible));
}

function canvasSize(): Size | null {
  const { width = 0, height = 0 } = document.querySelector(".canvas")?.getBoundingClientRect() ?? {};
  return width > 0 && height > 0 ? { width, height } : null;
}

interface Size {
  width: number;
  height: number;
}

const kTolerable = 0.5; // values of nodes are still to be made out
const kLegibleStates = 0.25; // what is written there is larger from afar
const kReadable = 0.7;

/** The canvas's viewport in which `bounds` is seen as a whole. */
function whole(bounds: Box, canvas: Size): Viewport {
  return getViewportForBounds(bounds, canvas.width, canvas.height, kFarthest, kFit.maxZoom, kFit.padding);
}

/**
 * Everything, if that can be read, or from `legible` on [zoom] could not be read in the whole window either. Else the page is
 * large, or the panes take the room: what is chosen, or where the page begins (at the left, where values come from), as
 * large as it takes to read it.
 */
export function readableView(
  bounds: Box,
  canvas: Size,
  page: Size,
  chosen: Box | null,
  legible = kTolerable,
): Viewport {
  const all = whole(bounds, canvas);
  if (all.zoom >= kTolerable || (all.zoom >= legible && whole(bounds, page).zoom < kTolerable)) return all;
  const [left, top] = [Number.parseFloat(kFit.padding.left), Number.parseFloat(kFit.padding.top)];
  const middle = (begin: number, length: number, room: number) => room / 2 - (begin + length / 2) * kReadable;
  if (chosen) {
    return {
      x: middle(chosen.x, chosen.width, canvas.width),
      y: middle(chosen.y, chosen.height, canvas.height),
      zoom: kReadable,
    };
  }
  const fits = (length: number, room: number, padding: number) => length * kReadable <= room - 2 * padding;
  return {
    x: left - bounds.x * kReadable,
    y: fits(bounds.height, canvas.height, top)
      ? middle(bounds.y, bounds.height, canvas.height)
      : top - bounds.y * kReadable,
    zoom: kReadable,
  };
}

/** Whether nothing of `what` is outside. */
export function holdsAll(view: Box, what: Box | null): boolean {
  if (!what) return true;
  return (
    what.x >= view.x &&
    what.y >= view.y &&
    what.x + what.width <= view.x + view.width &&
    what.y + what.height <= view.y + view.height
  );
}

/** As it is drawn on the page that is shown; null: it is not. */
export function nodeElement(id: string): HTMLElement | null {
  return document.querySelector<HTMLElement>(`.canvas .react-flow__node[data-id="${CSS.escape(id)}"]`);
}

let current: ReactFlowInstance | null = null;

export function setView(flow: ReactFlowInstance): () => void {
  current = flow;
  return () => {
    if (current === flow) current = null;
  };
}

export function camera(): ReactFlowInstance | null {
  return current;
}

/** Everything, or what is named. */
export function fit(ids?: readonly string[]): void {
  if (!ids && current) {
    void fitAll(current, 200);
    return;
  }
  void current?.fitView({
    ...kFit,
    duration: 200,
    ...(ids ? { nodes: ids.map((id) => ({ id })) } : {}),
  });
}
