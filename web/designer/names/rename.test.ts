import { describe, expect, it } from "vitest";
import { pageAfter } from "./rename.ts";

describe("pageAfter", () => {
  it("renames states and nodes inside of a declaration of the same name", () => {
    expect(pageAfter("Keep.Keep", { from: "Keep", to: "Holding", kind: "state" })).toBe("Keep.Holding");
    expect(pageAfter("Go.both", { from: "both", to: "all", kind: "node" })).toBe("Go.all");
    expect(pageAfter("Keep", { from: "Keep", to: "Holding", kind: "state" })).toBe("Keep");
  });
  it("renames a declaration, and no state in it that is called so", () => {
    expect(pageAfter("Keep.Keep", { from: "Keep", to: "Stay", kind: "assemblage" })).toBe("Stay.Keep");
    expect(pageAfter("Go.Keep", { from: "Keep", to: "Stay", kind: "assemblage" })).toBe("Go.Keep");
    expect(pageAfter("", { from: "Keep", to: "Stay", kind: "robot" })).toBe("");
  });
});
