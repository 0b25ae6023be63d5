import { expect, test } from "vitest";
import { outputsOf, withOneOutput } from "./one_output.ts";

const wires = [
  { from: "eyes", to: "Avoid" },
  { from: "Avoid", to: "sum" },
  { from: "Noise", to: "sum" },
  { from: "sum", to: "first" },
  { from: "Stand", to: "first" },
  { from: "first", to: "$result" },
];
const nodes = new Set(["eyes", "Avoid", "Noise", "sum", "Stand", "first", "alone"]);

test("outputs are what others read, or nobody", () => {
  expect(outputsOf(new Set(["Noise", "Avoid"]), wires)).toEqual(["Noise", "Avoid"]);
  expect(outputsOf(new Set(["Noise", "Avoid", "sum"]), wires)).toEqual(["sum"]);
  expect(outputsOf(new Set(["alone", "eyes"]), wires)).toEqual(["alone", "eyes"]);
});

test("where several are chosen, what they lead to is added until one value is left", () => {
  expect(withOneOutput(["Noise", "Avoid"], wires, nodes)).toEqual(["Noise", "Avoid", "sum"]);
  expect(withOneOutput(["Noise", "Stand"], wires, nodes)).toEqual(["Noise", "Stand", "sum", "first"]);
  expect(withOneOutput(["sum", "Noise"], wires, nodes)).toEqual(["sum", "Noise"]);
});

test("what never comes together can't be one assemblage", () => {
  expect(withOneOutput(["alone", "Noise"], wires, nodes)).toBeUndefined();
});
