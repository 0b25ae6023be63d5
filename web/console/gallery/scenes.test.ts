import { expect, it } from "vitest";
import { kKinds } from "../../core/tables/measures.ts";
import { everything } from "./scenes.ts";

it("the gallery has each kind of control measure", () => {
  const drawn = new Set(everything().scene.measures?.map((measure) => measure.kind));
  expect(kKinds.filter(({ wire }) => !drawn.has(wire)).map(({ kind }) => kind)).toEqual([]);
});
