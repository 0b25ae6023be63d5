import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { DrawingSchema, PageDifferenceSchema } from "../session/protocol.ts";
import { detailWords, ghostsOf, isGhost, withGhosts, withoutGhost } from "./compared.ts";

const page = { document: "a.cdl", path: "A" };
const drawing = create(DrawingSchema, {
  page,
  nodes: [
    {
      name: "cooperate",
      inputs: [
        { name: "members", index: 0 },
        { name: "members", index: 1, isList: true },
      ],
    },
    { name: "Noise" },
  ],
  wires: [{ from: "Noise", to: "cooperate", port: "members", index: 0 }],
});

describe("what has gone", () => {
  const difference = create(PageDifferenceSchema, {
    page,
    nodes: [{ name: "-Stand" }, { name: "-Probe" }],
    wires: [
      { from: "-Stand", to: "cooperate", port: "members", index: 4 },
      { from: "-Probe", to: "-Stand", port: "in" },
    ],
  });

  it("is laid out with the rest, and gives no input of what is there a wire", () => {
    const whole = withGhosts(drawing, difference);
    expect(whole.nodes.map((node) => node.name)).toEqual(["cooperate", "Noise", "-Stand", "-Probe"]);
    expect(whole.wires.map((wire) => wire.to)).toEqual(["cooperate", "-Stand"]);
  });

  it("led to an input that is there: where one more can be led, if the list is shorter by now", () => {
    const ghosts = ghostsOf(drawing, difference);
    expect(ghosts?.wires.map(({ to, index }) => [to, index])).toEqual([
      ["cooperate", 1],
      ["-Stand", undefined],
    ]);
  });

  it("is told by its name", () => {
    expect(["-Stand", "Look/1000", "Look/2", "Stand"].map(isGhost)).toEqual([true, true, false, false]);
    expect(withoutGhost("-Stand")).toBe("Stand");
  });

  it("is nothing on other pages, and where nothing has gone", () => {
    const elsewhere = create(PageDifferenceSchema, { nodes: [{ name: "-Stand" }], page: { ...page, path: "B" } });
    expect(withGhosts(drawing, elsewhere)).toBe(drawing);
    expect(withGhosts(drawing, undefined)).toBe(drawing);
    expect(ghostsOf(drawing, create(PageDifferenceSchema, { page }))).toBeUndefined();
  });
});

describe("a detail", () => {
  it("says what was before and what is now", () => {
    expect(detailWords({ what: "sphere", before: "2 m", after: "" })).toBe("sphere 2 m → nothing");
  });
});
