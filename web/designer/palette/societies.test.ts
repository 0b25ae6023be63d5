import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { DocumentSchema, DrawingSchema, Node_Shape, NodeSchema } from "../session/protocol.ts";
import { memberChoices, siblingsOf, whyNoGroup } from "./societies.ts";

const member = (name: string, ...path: number[]) => create(NodeSchema, { name, shape: Node_Shape.ROBOT, member: path });
const society = create(DrawingSchema, {
  page: { path: "All" },
  nodes: [member("All"), member("A", 0), member("caste1", 1), member("B", 1, 0), member("C", 1, 1)],
});

test("members of one caste can be grouped, and no others", () => {
  const [all, a, caste, b, c] = society.nodes;
  expect(whyNoGroup([a!, caste!])).toBe("");
  expect(whyNoGroup([b!, c!])).toBe("");
  expect(whyNoGroup([a!, b!])).toBe("Only members of one caste can be grouped");
  expect(whyNoGroup([all!])).toBe("The society itself can’t be grouped");
  expect(whyNoGroup([])).toBe("Nothing is selected");
});

test("siblings stand in the same caste", () => {
  expect(siblingsOf(society, [0])).toBe(2);
  expect(siblingsOf(society, [1, 1])).toBe(2);
});

test("robots and other societies of the file may be members", () => {
  const document = create(DocumentSchema, {
    declarations: [
      { kind: "robot", name: "R" },
      { kind: "society", name: "All" },
      { kind: "society", name: "Other" },
      { kind: "class", name: "Cart" },
    ],
  });
  expect(memberChoices(document, society).map(({ name }) => name)).toEqual(["R", "Other"]);
});
