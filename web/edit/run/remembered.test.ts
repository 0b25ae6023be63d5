import { beforeEach, expect, test } from "vitest";
import { remember, remembered } from "./remembered.ts";

const tried = { document: "a.cdl", revision: 12n, setup: "3 robots", mission: "try.mdl", notes: ["a body"] };

beforeEach(() => window.sessionStorage.clear());

test("what was tried is known after a reload, of the same server only", () => {
  remember(window.sessionStorage, "one", tried);
  expect(remembered(window.sessionStorage, "one", "3 robots")).toEqual(tried);
  expect(remembered(window.sessionStorage, "two", "")).toBeNull();
});

test("anything else that is stored means nothing", () => {
  for (const text of ["", "{", "7", "null", '{"server":"one"}', '{"server":"one","document":"a","revision":"x"}']) {
    window.sessionStorage.setItem("mlab.designer.tried", text);
    expect(remembered(window.sessionStorage, "one", "3 robots")).toBeNull();
  }
});
