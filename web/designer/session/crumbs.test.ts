import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { crumbsOf, shortenedTrail } from "./crumbs.ts";
import { DrawingSchema } from "./protocol.ts";

const drawing = (document: string, ...paths: string[]) =>
  create(DrawingSchema, {
    way: paths.map((path) => ({ document, path })),
    wayTitles: paths.map((path) => path || document),
  });
const declared = new Set(["Wander", "Urges"]);
const pages = (crumbs: readonly { page: string }[]) => crumbs.map((one) => one.page);

test("without a way inside it is where the page stands in its file", () => {
  expect(pages(crumbsOf([], drawing("a.cdl", "", "Urges"), "a.cdl", declared))).toEqual(["", "Urges"]);
});

test("who went inside finds the page that he came from", () => {
  const before = crumbsOf([], drawing("a.cdl", "", "Wander"), "a.cdl", declared);
  const inside = crumbsOf(before, drawing("a.cdl", "", "Urges"), "a.cdl", declared);
  expect(pages(inside)).toEqual(["", "Wander", "Urges"]);
  const library = crumbsOf(inside, drawing("library:x", "", "GoTo"), "library:x", new Set(["GoTo"]));
  expect(library.map((one) => one.title)).toEqual(["a.cdl", "Wander", "Urges", "GoTo"]);
});

test("a state's inside follows its sequence once", () => {
  const before = crumbsOf([], drawing("a.cdl", "", "Wander"), "a.cdl", declared);
  expect(pages(crumbsOf(before, drawing("a.cdl", "", "Wander", "Wander.Go"), "a.cdl", declared))).toEqual([
    "",
    "Wander",
    "Wander.Go",
  ]);
});

test("a step back shortens the way, another page forgets it", () => {
  const trail = crumbsOf([], drawing("a.cdl", "", "Wander"), "a.cdl", declared);
  expect(pages(shortenedTrail(trail, "a.cdl", "Wander"))).toEqual([""]);
  expect(shortenedTrail(trail, "a.cdl", "Urges")).toEqual([]);
});

test("what has gone from the file is not on the way any more", () => {
  const trail = crumbsOf([], drawing("a.cdl", "", "Wander"), "a.cdl", declared);
  expect(pages(crumbsOf(trail, drawing("a.cdl", "", "Urges"), "a.cdl", new Set(["Urges"])))).toEqual(["", "Urges"]);
});
