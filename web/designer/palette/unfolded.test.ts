import { beforeEach, expect, test } from "vitest";
import { keepUnfolded, readUnfolded } from "./unfolded.ts";

beforeEach(() => window.localStorage.clear());

test("groups stay as somebody left them", () => {
  expect(readUnfolded(window.localStorage)).toEqual({});
  keepUnfolded(window.localStorage, { Logic: true, Sensors: false });
  expect(readUnfolded(window.localStorage)).toEqual({ Logic: true, Sensors: false });
});

test("anything else that is stored means nothing", () => {
  for (const text of ["", "{", "7", "null", '{"Logic":"yes"}']) {
    window.localStorage.setItem("mlab.designer.groups", text);
    expect(readUnfolded(window.localStorage)).toEqual({});
  }
});
