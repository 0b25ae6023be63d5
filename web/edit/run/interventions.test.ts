import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { HeldValues_HeldSchema } from "../../core/protocol.ts";
import { heldAt, heldPorts, stateOf } from "./interventions.ts";

const held = [
  create(HeldValues_HeldSchema, { robot: 1, port: "movement.near", value: "true", also: ["movement.close"] }),
  create(HeldValues_HeldSchema, { robot: 2, port: "movement.far", value: "2" }),
];

test("a value is held for one robot, and for all nodes that compute the same", () => {
  expect(heldAt(held, 1, "movement.near")?.value).toBe("true");
  expect(heldAt(held, 1, "movement.close")?.value).toBe("true");
  expect(heldAt(held, 2, "movement.near")).toBeUndefined();
  expect([...heldPorts(held, 1)]).toEqual(["movement.near", "movement.close"]);
  expect(heldPorts(held, 3).size).toBe(0);
});

test("a state is told from those of the sequences inside of it", () => {
  const states = ["movement.job.A", "movement.job.A.inner.C", "movement.B"];
  expect(stateOf({ states }, "movement.job")).toBe("A");
  expect(stateOf({ states }, "movement.job.A.inner")).toBe("C");
  expect(stateOf({ states }, "movement")).toBe("B");
  expect(stateOf({ states }, "else")).toBe("");
  expect(stateOf(undefined, "movement")).toBe("");
});
