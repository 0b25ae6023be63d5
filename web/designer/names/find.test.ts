import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { DrawingSchema } from "../session/protocol.ts";
import { findOnPage } from "./find.ts";

const drawing = create(DrawingSchema, {
  nodes: [
    { name: "both", component: "cooperate", title: "both" },
    {
      name: "Noise",
      component: "Noise",
      inputs: [{ name: "persistence", label: "persistence", value: "6 s" }],
      help: "Random movement.",
    },
  ],
  states: [{ name: "Looking", member: "Wander()", title: "Wander" }],
  transitions: [{ from: "Looking", index: 0, to: "Resting", trigger: "Wait(delay = 2 s)" }],
  notes: [{ id: "note:1", text: "Ask Tom about the noise" }],
});

describe("findOnPage", () => {
  it("finds nodes, states, values, triggers and comments", () => {
    expect(findOnPage(drawing, "both")).toEqual(["both"]);
    expect(findOnPage(drawing, "6 s")).toEqual(["Noise"]);
    expect(findOnPage(drawing, "persistence = 6")).toEqual(["Noise"]);
    expect(findOnPage(drawing, "wander")).toEqual(["Looking"]);
    expect(findOnPage(drawing, "delay")).toEqual(["Looking/0"]);
    expect(findOnPage(drawing, "random")).toEqual(["Noise"]);
  });
  it("puts what is called so first", () => expect(findOnPage(drawing, "noise")).toEqual(["Noise", "note:1"]));
  it("finds nothing by nothing", () => expect(findOnPage(drawing, "  ")).toEqual([]));
});
