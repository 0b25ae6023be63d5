import fc from "fast-check";
import { expect, test } from "vitest";
import { contrast, parseColor, readableOn, toHex } from "./color.ts";

const part = fc.integer({ min: 0, max: 255 });
const color = fc.record({ r: part, g: part, b: part });

test("a colour that was written is read again", () => {
  fc.assert(
    fc.property(color, (one) => {
      expect(parseColor(toHex(one))).toEqual(one);
    }),
  );
});

test("X11's names are known without case and spaces, with their shades", () => {
  expect(parseColor("Forest Green")).toEqual({ r: 34, g: 139, b: 34 });
  expect(parseColor("red3")).toEqual({ r: 255, g: 0, b: 0 });
  expect(parseColor("#0af")).toEqual({ r: 0, g: 170, b: 255 });
  expect(parseColor("no such colour")).toBeNull();
});

test("what has to be readable stands out from light and from dark ground", () => {
  for (const ground of [
    { r: 252, g: 252, b: 250 },
    { r: 20, g: 24, b: 28 },
  ]) {
    fc.assert(
      fc.property(color, (one) => {
        expect(contrast(readableOn(one, ground), ground)).toBeGreaterThanOrEqual(3);
      }),
    );
  }
});

test("a colour that stands out already stays as it is", () => {
  expect(readableOn({ r: 0, g: 0, b: 160 }, { r: 255, g: 255, b: 255 })).toEqual({ r: 0, g: 0, b: 160 });
});
