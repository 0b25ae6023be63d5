// What automatic layout is asked: boxes with ports, wires between them. For dataflow and for states alike.

import { hasResult, kResultHeight, kResultWidth, wiredInputsOf, wireId } from "../drawing/flow.ts";
import { formOf } from "../drawing/form.ts";
import { type Drawing, Drawing_Kind, kResult } from "../session/protocol.ts";
import { stateSize } from "../states/form.ts";
import { type LabelSize, labelLines, labelSize } from "../states/label.ts";

const kRoomy = 1.2; // of a label: it is larger where the page is looked at from farther away

export interface LayoutNode {
  id: string;
  width: number;
  height: number;
  /** From the top, of inputs at the left and the output at the right. */
  inputs: { id: string; y: number }[];
  outputY: number;
  /** Nothing stands left of it. */
  isFirst?: boolean;
}

export interface LayoutWire {
  from: string;
  to: string;
  port: string;
  /** Of what is written at it. */
  label?: LabelSize;
}

export interface LayoutGraph {
  kind: "dataflow" | "states" | "grid";
  nodes: LayoutNode[];
  wires: LayoutWire[];
}

export function graphOf(drawing: Drawing): LayoutGraph {
  if (drawing.kind === Drawing_Kind.STATES) return statesGraph(drawing);
  const wired = wiredInputsOf(drawing);
  const nodes = drawing.nodes.map((node): LayoutNode => {
    const form = formOf(node, wired);
    return {
      id: node.name,
      width: form.width,
      height: form.height,
      inputs: [...form.rows, ...form.extras].map(({ id, y }) => ({ id, y })),
      outputY: form.outputY,
    };
  });
  const names = new Set(nodes.map((node) => node.id));
  const wires: LayoutWire[] = drawing.wires
    .filter((wire) => names.has(wire.from) && names.has(wire.to))
    .map((wire) => ({ from: wire.from, to: wire.to, port: wireId(wire).slice(wire.to.length + 1) }));
  if (hasResult(drawing) && names.has(drawing.resultNode)) {
    nodes.push({
      id: kResult,
      width: kResultWidth,
      height: kResultHeight,
      inputs: [{ id: "value", y: kResultHeight / 2 }],
      outputY: -1,
    });
    wires.push({ from: drawing.resultNode, to: kResult, port: "value" });
  }
  return { kind: wires.length === 0 ? "grid" : "dataflow", nodes, wires };
}

function statesGraph(drawing: Drawing): LayoutGraph {
  const start = drawing.states.filter((state) => state.isStart);
  const others = drawing.states.filter((state) => !state.isStart);
  return {
    kind: "states",
    nodes: [...start, ...others].map((state) => ({
      id: state.name,
      ...stateSize(state),
      inputs: [],
      outputY: -1,
      isFirst: state.isStart,
    })),
    wires: drawing.transitions.map(({ from, to, trigger }) => ({
      from,
      to,
      port: "",
      label: labelSize(labelLines(trigger), 1, kRoomy),
    })),
  };
}
