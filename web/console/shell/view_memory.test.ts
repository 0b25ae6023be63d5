import { describe, expect, it } from "vitest";
import { readView } from "./view_memory.ts";

describe("the stored view", () => {
  it("comes back as it was", () => {
    const view = { mission: "a.mdl", camera: { x: 1, y: 2, scale: 3 }, robots: [1, 2], unit: "scouts" };
    expect(readView(JSON.stringify(view))).toEqual(view);
  });
  it("is nothing where it is damaged", () => {
    for (const junk of [
      null,
      "",
      "{",
      "3",
      "{}",
      `{"mission":"a","camera":{"x":1,"y":null,"scale":1},"robots":[],"unit":""}`,
    ]) {
      expect(readView(junk)).toBeUndefined();
    }
  });
});
