import { describe, expect, it } from "vitest";
import { ancestors, folderOf, join, nameOf, nameProblem, withEnding } from "./paths.ts";

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
  it("can't leave the project", () => {
    for (const name of ["../x", "/x", "a/../../x", "a//b", "", " ", "c:x"]) expect(nameProblem(name)).toBeDefined();
    expect(nameProblem("a/b.mdl")).toBeUndefined();
  });
});
