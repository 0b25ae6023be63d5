import { expect, test } from "vitest";
import { type Call, Calls } from "./calls.ts";

function begin() {
  const told: string[] = [];
  const clock = { now: 0, sounds: 0 };
  const calls = new Calls({
    sound: () => void ++clock.sounds,
    notify: ({ text }) => void told.push(text),
    now: () => clock.now,
  });
  return { calls, told, clock };
}
const call = (tag: string): Call => ({ tag, title: "mlab", text: `text of ${tag}` });

test("what is new is told once, with a sound", () => {
  const { calls, told, clock } = begin();
  calls.see([call("a")]);
  calls.see([call("a")]);
  expect(told).toEqual(["text of a"]);
  expect(clock.sounds).toBe(1);
});

test("what was there before they were switched on is not told", () => {
  const { calls, told } = begin();
  calls.know([call("a")]);
  calls.see([call("a"), call("b")]);
  expect(told).toEqual(["text of b"]);
});

test("many at once sound once, and later ones again", () => {
  const { calls, told, clock } = begin();
  calls.see([call("a"), call("b")]);
  calls.see([call("a"), call("b"), call("c")]);
  expect(told.length).toBe(3);
  expect(clock.sounds).toBe(1);
  clock.now = 5000;
  calls.see([call("d")]);
  expect(clock.sounds).toBe(2);
});
