import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { type Drawing, DrawingSchema, kResult, Node_Shape } from "../session/protocol.ts";
import { nodesOf, ownPlaces, wiresOf } from "./flow.ts";
import { wirePath } from "./wire_path.ts";

function drawing(begin = 0, persistence = "10 s"): Drawing {
  return create(DrawingSchema, {
    page: { document: "a.cdl", path: "A" },
    resultNode: "cooperate",
    resultType: "Vector",
    nodes: [
      {
        name: "cooperate.Noise",
        component: "Noise",
        type: "Vector",
        x: 8,
        y: 16,
        begin,
        inputs: [{ name: "persistence", type: "double", value: persistence, begin }],
      },
      {
        name: "cooperate",
        shape: Node_Shape.COOPERATION,
        type: "Vector",
        x: 240,
        y: 16,
        inputs: [{ name: "members", index: 0, isMember: true, type: "Vector" }],
      },
    ],
    wires: [
      { from: "cooperate.Noise", to: "cooperate", port: "members", index: 0, type: "Vector" },
      { from: "cooperate", to: kResult, type: "Vector" },
    ],
  });
}

test("a drawing becomes nodes with handles and wires between them", () => {
  const nodes = nodesOf(drawing(), ownPlaces(drawing()), []);
  expect(nodes.map((node) => node.id)).toEqual(["cooperate.Noise", "cooperate", kResult]);
  expect(nodes[1]!.handles?.map((handle) => handle.id)).toEqual(["members[0]", "out"]);
  expect(nodes[2]!.position.x).toBeGreaterThan(240);
  const wires = wiresOf(drawing(), []);
  expect(wires.map((wire) => [wire.id, wire.source, wire.targetHandle])).toEqual([
    ["cooperate/members[0]", "cooperate.Noise", "members[0]"],
    [kResult, "cooperate", "value"],
  ]);
});

test("what did not change is the same object, wherever it stands in the text now", () => {
  const before = nodesOf(drawing(), ownPlaces(drawing()), []);
  const moved = nodesOf(drawing(50), ownPlaces(drawing()), before);
  expect(moved[0]).toBe(before[0]);
  const changed = nodesOf(drawing(50, "4 s"), ownPlaces(drawing()), before);
  expect(changed[0]).not.toBe(before[0]);
  expect(changed[1]).toBe(before[1]);
  const wires = wiresOf(drawing(), []);
  expect(wiresOf(drawing(50), wires)[0]).toBe(wires[0]);
});

test("a wire leaves to the right and arrives from the left, also backwards", () => {
  expect(wirePath({ x: 0, y: 0 }, { x: 200, y: 0 }).middle).toEqual({ x: 100, y: 0 });
  expect(wirePath({ x: 200, y: 0 }, { x: 0, y: 50 }).path).toMatch(/^M200 0C3\d\d/);
});

test("wires that share an input, as on the page of a file, are all drawn", () => {
  const shared = create(DrawingSchema, {
    nodes: [{ name: "Wander" }, { name: "Acquire" }, { name: "Forage" }],
    wires: [
      { from: "Wander", to: "Forage", port: "uses" },
      { from: "Acquire", to: "Forage", port: "uses" },
    ],
  });
  const wires = wiresOf(shared, []);
  expect(new Set(wires.map((wire) => wire.id)).size).toBe(2);
  expect(wires.map((wire) => wire.source)).toEqual(["Wander", "Acquire"]);
  expect(wiresOf(shared, wires)).toEqual(wires);
});
