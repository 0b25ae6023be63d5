import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { Node_Shape, NodeSchema } from "../protocol.ts";
import { formOf, kHeadHeight, kRowHeight, portOf, rowId, withUnit } from "./form.ts";
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
  const form = formOf(noise, new Set());
  expect(form.rows.map(({ kind, value }) => [kind, value])).toEqual([
    ["given", "10 s"],
    ["default", "1 m"],
    ["needed", ""],
  ]);
  expect(form.rows[2]!.y).toBe(kHeadHeight + 2.5 * kRowHeight);
  expect(formOf(noise, new Set(["drift/readings"])).rows[2]!.kind).toBe("wired");
});

test("the component stands below a name of its own", () => {
  expect(formOf(noise, new Set())).toMatchObject({ title: "drift", subtitle: "Noise" });
  const plain = create(NodeSchema, { name: "Noise", component: "Noise", shape: Node_Shape.BEHAVIOR });
  expect(formOf(plain, new Set())).toMatchObject({ title: "Noise", subtitle: "motor schema" });
});

test("inputs of lists are told apart by their place", () => {
  expect(rowId("members", 2)).toBe("members[2]");
  expect(portOf("members[2]")).toEqual({ port: "members", index: 2 });
  expect(portOf("readings")).toEqual({ port: "readings" });
});

test("only bare numbers get a unit", () => {
  expect(withUnit("10", "s")).toBe("10 s");
  expect(withUnit("-.5", "m")).toBe("-.5 m");
  expect(withUnit("50 cm", "m")).toBe("50 cm");
  expect(withUnit("Orange", "m")).toBe("Orange");
});

test("outlines are closed", () => {
  for (const outline of ["box", "sum", "arrow", "octagon", "hexagon", "pill", "tag", "sink"] as const) {
    expect(outlinePath(outline, 200, 80)).toMatch(/^M.*Z$/);
    expect(outlinePath(outline, 40, 10)).not.toMatch(/NaN|-/);
  }
});
