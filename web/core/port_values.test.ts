import { create } from "@bufbuild/protobuf";
import fc from "fast-check";
import { expect, test } from "vitest";
import { placeOfPort, portText } from "./port_values.ts";
import { RobotDetailSchema } from "./protocol.ts";

test("of all ports each has its own place", () => {
  const detail = create(RobotDetailSchema, { ports: ["a", "b"] });
  expect([0, 1, 2, -1].map((index) => portText(detail, index))).toEqual(["a", "b", "", ""]);
  expect(portText(undefined, 0)).toBe("");
});

test("of some ports those are found that are there, and no others", () => {
  fc.assert(
    fc.property(fc.uniqueArray(fc.nat(200)), fc.nat(200), (wished, index) => {
      const portIndices = [...wished].sort((a, b) => a - b);
      const detail = create(RobotDetailSchema, { hasSomePorts: true, portIndices, ports: portIndices.map(String) });
      expect(portText(detail, index)).toBe(portIndices.includes(index) ? String(index) : "");
      expect(placeOfPort(detail, index)).toBe(portIndices.indexOf(index));
    }),
  );
});
