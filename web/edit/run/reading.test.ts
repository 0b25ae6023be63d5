import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { PortSchema, RobotDetailSchema } from "../../core/protocol.ts";
import { Traces } from "../../designer/running/traces.ts";
import { liveKey } from "../../designer/running/values.ts";
import { Drawing_Kind, DrawingSchema } from "../../designer/session/protocol.ts";
import { livesOf, planOf, portsOf, valuesOf } from "./reading.ts";

const ports = [
  create(PortSchema, { path: "movement.Noise", type: "Vector", isNumber: true }),
  create(PortSchema, { path: "movement.near", type: "bool", isNumber: true }),
  create(PortSchema, { path: "movement.range", type: "double", unit: "m", isNumber: true }),
  create(PortSchema, { path: "elsewhere.Noise", type: "Vector", isNumber: true }),
];

const drawing = create(DrawingSchema, {
  page: { document: "a.cdl", path: "Wander" },
  kind: Drawing_Kind.DATAFLOW,
  nodes: [{ name: "Noise", live: "Noise" }, { name: "near", live: "near" }, { name: "text" }],
  wires: [
    { from: "Noise", to: "$result", live: "Noise" },
    { from: "range", to: "near", live: "range" },
  ],
});

function bytesOf(values: readonly number[], put: (view: DataView, at: number, value: number) => void, size: number) {
  const bytes = new Uint8Array(values.length * size);
  const view = new DataView(bytes.buffer);
  values.forEach((value, i) => {
    put(view, i * size, value);
  });
  return bytes;
}

const kNothingHeld = new Set<string>();

const numbers = bytesOf([5, 1, 2.5, 0], (view, at, value) => view.setFloat64(at, value, true), 8);
const vectors = new Uint8Array(12);
new DataView(vectors.buffer).setFloat32(4, 3, true);
new DataView(vectors.buffer).setFloat32(8, 4, true);

test("what is drawn twice is read once", () => {
  expect(livesOf(drawing)).toEqual(["Noise", "near", "range"]);
});

test("values are those of the place that is shown, each as what it is", () => {
  const plan = planOf(drawing, "movement", ports);
  const traces = new Traces();
  traces.at(1);
  const detail = create(RobotDetailSchema, {
    ports: ["(3, 4)", "true", "2.5", "(0, 0)"],
    numbers,
    vectors,
    active: new Uint8Array([1, 0, 1, 0]),
  });
  const values = valuesOf(plan, detail, traces, kNothingHeld);
  expect(values.get(liveKey("Wander", "Noise"))).toEqual({
    text: "5",
    number: 5,
    vector: { x: 3, y: 4 },
    isActive: true,
    trace: [5],
  });
  expect(values.get(liveKey("Wander", "near"))).toEqual({ text: "true", number: 1, isActive: false });
  expect(values.get(liveKey("Wander", "range"))?.text).toBe("2.5 m");
});

test("a detail with the page's ports alone gives the same values", () => {
  const plan = planOf(drawing, "elsewhere", ports);
  expect(portsOf(plan)).toEqual(["elsewhere.Noise"]);
  const arrow = vectors.slice();
  new DataView(arrow.buffer).setUint32(0, 3, true);
  const detail = create(RobotDetailSchema, {
    hasSomePorts: true,
    portIndices: [3],
    ports: ["(3, 4)"],
    numbers: numbers.slice(0, 8),
    vectors: arrow,
    active: new Uint8Array([1]),
  });
  expect([...valuesOf(plan, detail, new Traces(), kNothingHeld)]).toEqual([
    [liveKey("Wander", "Noise"), { text: "5", number: 5, vector: { x: 3, y: 4 }, isActive: true, trace: [5] }],
  ]);
});

test("what is held is told from what was computed", () => {
  const detail = create(RobotDetailSchema, {
    ports: ["(3, 4)", "true", "2.5", "(0, 0)"],
    numbers,
    vectors,
    active: new Uint8Array([1, 1, 1, 1]),
  });
  const values = valuesOf(planOf(drawing, "movement", ports), detail, new Traces(), new Set(["movement.near"]));
  expect(values.get(liveKey("Wander", "near"))).toMatchObject({ text: "true", isHeld: true });
  expect(values.get(liveKey("Wander", "range"))?.isHeld).toBeUndefined();
});

test("a detail without ports gives no values", () => {
  const plan = planOf(drawing, "movement", ports);
  expect(valuesOf(plan, create(RobotDetailSchema), new Traces(), kNothingHeld).size).toBe(0);
});

test("of states the active one is known, and of transitions when they were made", () => {
  const states = create(DrawingSchema, {
    page: { document: "a.cdl", path: "Forage" },
    kind: Drawing_Kind.STATES,
    states: [
      { name: "Searching", live: "Searching" },
      { name: "Acquiring", live: "Acquiring" },
    ],
    transitions: [
      { from: "Searching", index: 0, to: "Acquiring" },
      { from: "Acquiring", index: 0, to: "Searching" },
    ],
  });
  const detail = create(RobotDetailSchema, {
    states: ["movement.Acquiring", "other.Searching"],
    transitions: [
      { sequence: "movement", from: "Searching", index: 0, to: "Acquiring", cycle: 12n },
      { sequence: "other", from: "Acquiring", index: 0, to: "Searching", cycle: 15n },
    ],
  });
  const values = valuesOf(planOf(states, "movement", ports), detail, new Traces(), kNothingHeld);
  expect(values.get(liveKey("Forage", "Searching"))?.isActive).toBe(false);
  expect(values.get(liveKey("Forage", "Acquiring"))?.isActive).toBe(true);
  expect(values.get(liveKey("Forage", "Searching/0"))?.times).toBe(12);
  expect(values.get(liveKey("Forage", "Acquiring/0"))?.times).toBe(0);
});
