import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { ComponentSchema, Node_Shape } from "../protocol.ts";
import { firstSentence, found, groupsOf, isForPage } from "./groups.ts";

const all = [
  create(ComponentSchema, {
    name: "MoveToGoal",
    group: "Motor schemas",
    aliases: ["MOVE_TO_GOAL"],
    shape: Node_Shape.BEHAVIOR,
  }),
  create(ComponentSchema, {
    name: "Noise",
    group: "Motor schemas",
    help: "A random direction. Changes now and then.",
    shape: Node_Shape.BEHAVIOR,
  }),
  create(ComponentSchema, { name: "DetectGoal", group: "Perception", shape: Node_Shape.PERCEPTION }),
];

test("components stand in their groups", () => {
  expect(groupsOf(all).map((group) => [group.name, group.components.length])).toEqual([
    ["Motor schemas", 2],
    ["Perception", 1],
  ]);
});

test("a few letters find a component, by its historic name too, or by what it is said to do", () => {
  expect(found("nois", all)[0]!.name).toBe("Noise");
  expect(found("mtg", all)[0]!.name).toBe("MoveToGoal");
  expect(found("MOVE_TO", all)[0]!.name).toBe("MoveToGoal");
  expect(found("random", all)[0]!.name).toBe("Noise");
  expect(found("", all)).toHaveLength(3);
});

test("states do what moves", () => {
  expect(all.filter((one) => isForPage(one, true)).map((one) => one.name)).toEqual(["MoveToGoal", "Noise"]);
  expect(firstSentence("A random direction. Changes now and then.")).toBe("A random direction.");
});
