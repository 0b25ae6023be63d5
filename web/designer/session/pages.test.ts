import fc from "fast-check";
import { expect, test } from "vitest";
import { declarationOf, fromFragment, innerPath, lastPart, outerPath, toFragment } from "./pages.ts";

test("a page stands in the one before its last dot", () => {
  expect(outerPath("Forage.Searching.Noise")).toBe("Forage.Searching");
  expect(outerPath("Forage")).toBe("");
  expect(outerPath("")).toBeUndefined();
  expect(lastPart("Forage.Searching")).toBe("Searching");
  expect(declarationOf("Forage.Searching.Noise")).toBe("Forage");
  expect(innerPath("", "Forage")).toBe("Forage");
  expect(innerPath("Forage", "Searching")).toBe("Forage.Searching");
});

test("a link leads back to where it was made", () => {
  fc.assert(
    fc.property(fc.string({ minLength: 1 }), fc.string(), fc.string(), (document, page, node) => {
      expect(fromFragment(toFragment({ document, page, node }))).toEqual({ document, page, node });
    }),
  );
});

test("a link can be read by a person", () => {
  expect(toFragment({ document: "examples:forage/forager.cdl", page: "Forage.Searching", node: "Noise" })).toBe(
    "#file=examples:forage/forager.cdl&page=Forage.Searching&node=Noise",
  );
});
