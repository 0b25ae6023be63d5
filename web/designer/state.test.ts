import { expect, test } from "vitest";
import { createState, firstShown, readShown } from "./state.ts";

test("what is shown is kept over a reload", () => {
  localStorage.clear();
  const store = createState(localStorage, 1280);
  store.setState(({ shown }) => ({ shown: { ...shown, text: true, textWidth: 500 }, theme: "dark" }));
  const again = createState(localStorage, 1280).getState();
  expect(again.shown).toMatchObject({ text: true, textWidth: 500, palette: true });
  expect(again.theme).toBe("dark");
});

test("what was stored may be anything", () => {
  const first = firstShown(1280);
  for (const stored of [null, 3, "x", [], { text: "yes", textWidth: "wide" }])
    expect(readShown(stored, first)).toEqual(first);
  expect(readShown({ textWidth: 99_999, live: true }, first)).toMatchObject({ textWidth: 1200, live: true });
});
