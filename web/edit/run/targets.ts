// What of the page an id of the selection is, for breakpoints and probes.
import { wireId } from "../../designer/drawing/flow.ts";
import { lastPart } from "../../designer/session/pages.ts";
import { type Drawing, Drawing_Kind, kResult } from "../../designer/session/protocol.ts";
import { transitionOf } from "../../designer/states/flow.ts";

export type Target =
  | { readonly kind: "transition"; readonly from: string; readonly to: string }
  | { readonly kind: "state"; readonly name: string }
  | { readonly kind: "value"; readonly live: string; readonly type: string; readonly title: string };

/** Nothing: it has no value and is no part of a sequence. */
export function targetOf(drawing: Drawing, id: string): Target | undefined {
  if (drawing.kind === Drawing_Kind.STATES) {
    const transition = transitionOf(drawing, id);
    if (transition) return { kind: "transition", from: transition.from, to: transition.to };
    const state = drawing.states.find((one) => one.name === id);
    if (state) return { kind: "state", name: state.name };
  }
  const node = drawing.nodes.find((one) => one.name === id);
  if (node) return node.live === "" ? undefined : { kind: "value", live: node.live, type: node.type, title: node.name };
  const wire = drawing.wires.find((one) => (one.to === kResult ? kResult : wireId(one)) === id || wireId(one) === id);
  if (!wire || wire.live === "") return undefined;
  return { kind: "value", live: wire.live, type: wire.type, title: `the wire from ${wire.from}` };
}

/** The port paths that are parameters of a node: directly below it. */
export function parametersBelow<P extends { readonly path: string }>(ports: readonly P[], node: string): P[] {
  if (node === "") return ports.filter(({ path }) => !path.includes("."));
  return ports.filter(({ path }) => path.startsWith(`${node}.`) && !path.slice(node.length + 1).includes("."));
}

/** As people call it: `safety margin`; of an operator's weights `weight 1`. */
export function parameterName(path: string): string {
  const name = lastPart(path);
  const weight = /^gains\[(\d+)\]$/.exec(name);
  return weight ? `weight ${Number(weight[1]) + 1}` : name.replaceAll("_", " ");
}

/** Whether the text has this number for a parameter already, in the port's unit or without any. */
export function isWritten(
  node: { readonly inputs: readonly { readonly name: string; readonly value: string }[] } | undefined,
  name: string,
  shown: string,
  unit: string,
): boolean {
  const input = node?.inputs.find((one) => one.name.replaceAll("_", " ") === name);
  const [, number, written] = /^(-?[\d.]+(?:e[-+]?\d+)?)\s*(.*)$/i.exec(input?.value ?? "") ?? [];
  return number !== undefined && (written === "" || written === unit) && Number(number) === Number.parseFloat(shown);
}
