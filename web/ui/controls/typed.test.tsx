import { act } from "react";
import { createRoot, type Root } from "react-dom/client";
import { afterEach, beforeEach, expect, test } from "vitest";
import { type Typed, useTyped } from "./typed.ts";

(globalThis as { IS_REACT_ACT_ENVIRONMENT?: boolean }).IS_REACT_ACT_ENVIRONMENT = true;

let root: Root;
let field: Typed;

beforeEach(() => {
  root = createRoot(document.createElement("div"));
});
afterEach(() => act(() => root.unmount()));

function Entry({ value }: { value: string }) {
  field = useTyped(value);
  return null;
}
const become = (value: string) => act(() => root.render(<Entry value={value} />));

test("a field shows its value, whatever that becomes", () => {
  become("1 s");
  expect(field.typed).toBe("1 s");
  become("2 s");
  expect(field.typed).toBe("2 s");
});

test("what somebody types stays while the value changes, until it is sent", () => {
  become("1 s");
  act(() => field.type("3"));
  become("2 s");
  expect(field.typed).toBe("3");
  act(() => field.show("3"));
  expect(field.typed).toBe("3");
  become("3 s");
  expect(field.typed).toBe("3 s");
});

test("who takes back what he typed sees the value again", () => {
  become("1 s");
  act(() => field.type("3"));
  act(() => field.type("1 s"));
  become("2 s");
  expect(field.typed).toBe("2 s");
});

test("what a slider shows gives way to the value", () => {
  become("1 s");
  act(() => field.show("4 s"));
  expect(field.typed).toBe("4 s");
  become("4.01 s");
  expect(field.typed).toBe("4.01 s");
});
