// What a robot's newest detail says of the page that is drawn.
import { toDoubles } from "../../core/packed.ts";
import { placeOfPort } from "../../core/port_values.ts";
import type { Port, RobotDetail } from "../../core/protocol.ts";
import type { Traces } from "../../designer/running/traces.ts";
import { type LiveValue, liveKey } from "../../designer/running/values.ts";
import { type Drawing, Drawing_Kind } from "../../designer/session/protocol.ts";
import { transitionId } from "../../designer/states/flow.ts";
import { joined } from "./places.ts";
import { shownText, shownVector } from "./shown_value.ts";

/** What of the page is where among the ports: made once for a page and a program, used with each detail. */
export interface Plan {
  readonly page: string;
  readonly place: string;
  readonly drawing: Drawing;
  readonly ports: readonly Port[];
  /** By the `live` of what is drawn. */
  readonly index: ReadonlyMap<string, number>;
}

export function planOf(drawing: Drawing, place: string, ports: readonly Port[]): Plan {
  const at = new Map(ports.map((port, i) => [port.path, i]));
  const index = new Map<string, number>();
  for (const live of livesOf(drawing)) {
    const found = at.get(joined(place, live));
    if (found !== undefined) index.set(live, found);
  }
  return { page: drawing.page?.path ?? "", place, drawing, ports, index };
}

/** What has to be watched for it: paths of ports. */
export function portsOf({ index, ports }: Plan): string[] {
  return [...index.values()].map((at) => ports[at]!.path);
}

/** Of all that has a value on the page. */
export function livesOf(drawing: Drawing): string[] {
  const lives = [...drawing.nodes, ...drawing.wires].map((one) => one.live).filter((live) => live !== "");
  return [...new Set(lives)];
}

/** `held`: paths of ports that somebody holds. */
export function valuesOf(
  plan: Plan,
  detail: RobotDetail,
  traces: Traces,
  held: ReadonlySet<string>,
): Map<string, LiveValue> {
  const values = new Map<string, LiveValue>();
  const read = portReader(plan.ports, detail);
  for (const [live, at] of plan.index) {
    const key = liveKey(plan.page, live);
    const value = read(at);
    const port = plan.ports[at]!;
    if (!value) continue;
    const shown = withTrace(value, port, key, traces);
    values.set(key, held.has(port.path) ? { ...shown, isHeld: true } : shown);
  }
  if (plan.drawing.kind === Drawing_Kind.STATES) addStates(plan, detail, values);
  return values;
}

export function withTrace(value: LiveValue, port: Port, key: string, traces: Traces): LiveValue {
  if (value.number === undefined || port.type === "bool") return value;
  return { ...value, trace: traces.add(key, value.number) };
}

/** The value of the port at an index; none before the first detail with ports. */
export function portReader(ports: readonly Port[], detail: RobotDetail): (at: number) => LiveValue | undefined {
  const numbers = toDoubles(detail.numbers);
  const vectors = vectorsOf(detail.vectors);
  return (at) => {
    const place = placeOfPort(detail, at);
    const text = detail.ports[place];
    const port = ports[at];
    if (text === undefined || !port) return undefined;
    const isActive = detail.active[place] === 1;
    const vector = vectors.get(at);
    const number = numbers[place];
    const known = number !== undefined && Number.isFinite(number) ? { number } : {};
    if (vector) return { text: shownVector(vector.x, vector.y, port.unit), vector, isActive, ...known };
    return { text: shownText(text, port.unit), isActive, ...known };
  };
}

function vectorsOf(bytes: Uint8Array): Map<number, { x: number; y: number }> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const vectors = new Map<number, { x: number; y: number }>();
  for (let at = 0; at + 12 <= bytes.byteLength; at += 12) {
    vectors.set(view.getUint32(at, true), { x: view.getFloat32(at + 4, true), y: view.getFloat32(at + 8, true) });
  }
  return vectors;
}

/** The active state, and of each transition when it was made last. */
function addStates({ page, place, drawing }: Plan, detail: RobotDetail, values: Map<string, LiveValue>): void {
  const active = new Set(detail.states);
  for (const state of drawing.states) {
    if (state.live === "") continue;
    values.set(liveKey(page, state.live), { text: "", isActive: active.has(joined(place, state.live)) });
  }
  const made = new Map(
    detail.transitions.filter(({ sequence }) => sequence === place).map((one) => [transitionId(one), one.cycle]),
  );
  for (const transition of drawing.transitions) {
    const id = transitionId(transition);
    values.set(liveKey(page, id), { text: "", times: Number(made.get(id) ?? 0n) });
  }
}
