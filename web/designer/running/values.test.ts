import { expect, test } from "vitest";
import { LiveValues, liveKey } from "./values.ts";

test("only who shows a value that changed hears of it", () => {
  const values = new LiveValues();
  const heard: string[] = [];
  const ends = ["a", "b"].map((live) => values.subscribe(liveKey("Wander", live), () => heard.push(live)));
  values.set(new Map([[liveKey("Wander", "a"), { text: "1", number: 1 }]]));
  expect(heard).toEqual(["a"]);
  values.set(
    new Map([
      [liveKey("Wander", "a"), { text: "1", number: 1 }],
      [liveKey("Wander", "b"), { text: "0, 1", vector: { x: 0, y: 1 } }],
    ]),
  );
  expect(heard).toEqual(["a", "b"]);
  values.set(new Map());
  expect(heard).toEqual(["a", "b", "a", "b"]);
  for (const end of ends) end();
  values.set(new Map([[liveKey("Wander", "a"), { text: "2" }]]));
  expect(heard).toHaveLength(4);
});

test("values of a test stand in place of those of a run, which come back when they go", () => {
  const values = new LiveValues();
  const seen: (string | undefined)[] = [];
  values.subscribe("a", () => seen.push(values.get("a")?.text));
  values.set(new Map([["a", { text: "1" }]]));
  values.showInstead(new Map([["a", { text: "test" }]]));
  values.set(new Map([["a", { text: "2" }]]));
  expect(values.isEmpty).toBe(false);
  values.showInstead(null);
  expect(seen).toEqual(["1", "test", "2"]);
});
