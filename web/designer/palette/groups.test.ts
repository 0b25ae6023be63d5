import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { ComponentSchema, Node_Shape } from "../session/protocol.ts";
import { firstSentence, groupsOf, isForPage, isInPalette, isOpenAtFirst, matchingComponents } from "./groups.ts";

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
const inGroups = (...groups: string[]) => groups.map((group) => create(ComponentSchema, { name: group, group }));

test("components stand in their groups", () => {
  expect(groupsOf(all).map((group) => [group.name, group.components.length])).toEqual([
    ["Motor schemas", 2],
    ["Perception", 1],
  ]);
});

test("what a beginner wants first stands first, whatever the order in which it came", () => {
  const came = inGroups("Logic", "Operators", "Assemblages", "Mine", "Motor schemas", "Sensors", "This file");
  const order = ["This file", "Motor schemas", "Sensors", "Operators", "Mine", "Assemblages", "Logic"];
  expect(groupsOf(came).map((group) => group.name)).toEqual(order);
});

test("what most robots need stands first in its group", () => {
  const came = ["Alert", "Halt", "Noise", "AvoidStaticObstacles"].map((name) =>
    create(ComponentSchema, { name, group: "Motor schemas" }),
  );
  expect(groupsOf(came)[0]!.components.map((one) => one.name)).toEqual([
    "Noise",
    "AvoidStaticObstacles",
    "Alert",
    "Halt",
  ]);
});

test("what a first skill is made of is unfolded, what comes later is not", () => {
  expect(["Motor schemas", "Sensors", "Operators", "Mine"].every((one) => isOpenAtFirst(one, false))).toBe(true);
  expect(["Assemblages", "Logic"].some((one) => isOpenAtFirst(one, false))).toBe(false);
  expect(isOpenAtFirst("Assemblages", true)).toBe(true);
});

test("the palette of states has triggers, which are no states", () => {
  const near = create(ComponentSchema, { name: "Near", type: "bool", shape: Node_Shape.ASSEMBLAGE });
  const and = create(ComponentSchema, { name: "and", type: "bool", shape: Node_Shape.LOGIC });
  expect([near, and].map((one) => [isForPage(one, true), isInPalette(one, true)])).toEqual([
    [false, true],
    [false, false],
  ]);
});

test("a few letters find a component, by its historic name too, or by what it is said to do", () => {
  expect(matchingComponents("nois", all)[0]!.name).toBe("Noise");
  expect(matchingComponents("mtg", all)[0]!.name).toBe("MoveToGoal");
  expect(matchingComponents("MOVE_TO", all)[0]!.name).toBe("MoveToGoal");
  expect(matchingComponents("random", all)[0]!.name).toBe("Noise");
  expect(matchingComponents("", all)).toHaveLength(3);
});

test("what is called exactly so comes before what only begins so", () => {
  expect(matchingComponents("stand", inGroups("Standby", "Stand")).map((one) => one.name)).toEqual([
    "Stand",
    "Standby",
  ]);
});

test("states do what moves", () => {
  expect(all.filter((one) => isForPage(one, true)).map((one) => one.name)).toEqual(["MoveToGoal", "Noise"]);
  expect(firstSentence("A random direction. Changes now and then.")).toBe("A random direction.");
});
