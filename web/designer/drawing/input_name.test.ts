import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { DrawingSchema, Node_Shape } from "../session/protocol.ts";
import { inputName } from "./input_name.ts";

const member = (index: number) => ({ name: "members", index, isMember: true, isList: true });
const drawing = create(DrawingSchema, {
  nodes: [
    {
      name: "cooperate",
      title: "cooperate",
      shape: Node_Shape.COOPERATION,
      inputs: [member(0), member(1), { name: "members", label: "add", isList: true }],
    },
    { name: "value.Noise", title: "Noise", inputs: [{ name: "persistence" }] },
    { name: "value.Probe", title: "Probe", inputs: [{ name: "safety_margin" }] },
    { name: "other.Probe", title: "Probe", inputs: [{ name: "safety_margin" }] },
  ],
});

test("inputs are called as they are written on the canvas", () => {
  expect(inputName(drawing, "cooperate", "members[1]")).toBe("cooperate · member 2");
  expect(inputName(drawing, "cooperate", "members")).toBe("cooperate · a new member");
  expect(inputName(drawing, "cooperate", "weight[1]")).toBe("cooperate · weight of member 2");
  expect(inputName(drawing, "value.Noise", "persistence")).toBe("Noise · persistence");
});

test("what is called the same is told apart by its path", () => {
  expect(inputName(drawing, "value.Probe", "safety_margin")).toBe("value.Probe · safety margin");
  expect(inputName(drawing, "gone", "readings")).toBe("gone · readings");
});
