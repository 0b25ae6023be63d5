import { describe, expect, it } from "vitest";
import { ancestors, folderOf, join, nameOf, nameProblem, shownTitle, withEnding } from "./paths.ts";

describe("paths of the project", () => {
  it("fall into folder and name, and come together again", () => {
    expect([folderOf("a/b/c.mdl"), nameOf("a/b/c.mdl"), folderOf("c.mdl")]).toEqual(["a/b", "c.mdl", ""]);
    expect([join("a/b", "c.mdl"), join("", "c.mdl")]).toEqual(["a/b/c.mdl", "c.mdl"]);
  });
  it("know the folders on their way", () => expect(ancestors("a/b")).toEqual(["", "a", "a/b"]));
  it("get an ending where they have none", () => {
    expect([withEnding("x", ".mdl"), withEnding("x.mdl ", ".mdl"), withEnding("x.txt", ".mdl")]).toEqual([
      "x.mdl",
      "x.mdl",
      "x.txt",
    ]);
  });
  it("are called by their title, or by their file", () => {
    expect(shownTitle({ path: "a/demo_c.mdl", title: "Demo C" })).toBe("Demo C");
    expect(shownTitle({ path: "examples:demo_c/demo_c.mdl", title: "examples:demo_c/demo_c.mdl" })).toBe("demo c");
  });
  it("can't leave the project", () => {
    for (const name of ["../x", "/x", "a/../../x", "a//b", "", " ", "c:x"]) expect(nameProblem(name)).toBeDefined();
    expect(nameProblem("a/b.mdl")).toBeUndefined();
  });
});
