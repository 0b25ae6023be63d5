import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { Node_Shape, NodeSchema } from "../session/protocol.ts";
import { formOf, kHeadHeight, kRowHeight, portOf, rowId } from "./form.ts";
import { outlinePath } from "./outline.ts";

const noise = create(NodeSchema, {
  name: "drift",
  component: "Noise",
  shape: Node_Shape.BEHAVIOR,
  type: "Vector",
  inputs: [
    { name: "persistence", type: "double", unit: "s", value: "10 s" },
    { name: "spread", type: "double", initial: "1", unit: "m" },
    { name: "readings", type: "Obstacles", isRequired: true },
  ],
});

test("each input has a row, and says where its value comes from", () => {
  const form = formOf(noise, new Map());
  expect(form.rows.map(({ kind, value }) => [kind, value])).toEqual([
    ["given", "10 s"],
    ["default", "1 m"],
    ["needed", ""],
  ]);
  expect(form.rows[2]!.y).toBe(kHeadHeight + 2.5 * kRowHeight);
  expect(formOf(noise, new Map([["drift", new Set(["readings"])]])).rows[2]!.kind).toBe("wired");
});

test("the component stands below a name of its own", () => {
  expect(formOf(noise, new Map())).toMatchObject({ title: "drift", subtitle: "Noise" });
  const plain = create(NodeSchema, { name: "Noise", component: "Noise", shape: Node_Shape.BEHAVIOR });
  expect(formOf(plain, new Map())).toMatchObject({ title: "Noise", subtitle: "motor schema" });
});

test("inputs of lists are told apart by their place", () => {
  expect(rowId("members", 2)).toBe("members[2]");
  expect(portOf("members[2]")).toEqual({ port: "members", index: 2 });
  expect(portOf("readings")).toEqual({ port: "readings" });
});

test("outlines are closed", () => {
  for (const outline of ["box", "sum", "arrow", "octagon", "hexagon", "pill", "tag", "sink"] as const) {
    expect(outlinePath(outline, 200, 80)).toMatch(/^M.*Z$/);
    expect(outlinePath(outline, 40, 10)).not.toMatch(/NaN|-/);
  }
});

test("wires that lead to no row still arrive", () => {
  const sum = create(NodeSchema, {
    name: "cooperate",
    shape: Node_Shape.COOPERATION,
    type: "Vector",
    inputs: [{ name: "members", index: 0, isMember: true, type: "Vector" }],
  });
  const form = formOf(sum, new Map([["cooperate", new Set(["members[0]", "weight[0]", "active"])]]));
  expect(form.rows[0]!.kind).toBe("wired");
  expect(form.extras).toEqual([
    { id: "weight[0]", y: form.rows[0]!.y + 6 },
    { id: "active", y: form.outputY },
  ]);
});
