import { afterEach, beforeEach, expect, test } from "vitest";
import { goToPane, offerFocus, watchPanes } from "./panes.ts";

let stop = () => {};

beforeEach(() => {
  document.body.innerHTML = `
    <header class="topbar"><button id="menu">Menu</button></header>
    <section class="dock"><input id="find"><section class="panel" id="parts" tabindex="0"></section></section>
    <section class="canvas" id="canvas" tabindex="-1"><div class="react-flow__node" id="node" tabindex="0"></div></section>
    <section class="dock"><section class="panel"><div class="cm-content" id="text" tabindex="0"></div></section></section>
    <footer class="strip"><button id="toggle">Text</button></footer>`;
  stop = watchPanes();
});
afterEach(() => stop());

const focused = () => document.activeElement?.id;

test("the focus goes from part to part, round the whole page, both ways", () => {
  document.getElementById("find")!.focus();
  const way = [1, 1, 1, 1, 1].map((step) => {
    goToPane(step as 1);
    return focused();
  });
  expect(way).toEqual(["canvas", "text", "toggle", "menu", "parts"]);
  goToPane(-1);
  expect(focused()).toBe("menu");
});

test("the selected node has the focus of the drawing", () => {
  document.getElementById("node")!.classList.add("selected");
  document.getElementById("parts")!.focus();
  goToPane(1);
  expect(focused()).toBe("node");
});

test("from nowhere the first way leads to the drawing", () => {
  (document.activeElement as HTMLElement | null)?.blur();
  goToPane(1);
  expect(focused()).toBe("canvas");
});

test("a focus that is lost is offered to people who use keys only", async () => {
  const canvas = document.getElementById("canvas")!;
  (document.activeElement as HTMLElement | null)?.blur();
  window.dispatchEvent(new Event("pointerdown"));
  offerFocus(canvas);
  await new Promise((resolve) => setTimeout(resolve, 150));
  expect(focused()).not.toBe("canvas");
  window.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter" }));
  offerFocus(canvas);
  await expect.poll(focused).toBe("canvas");
});

test("what a dialog gives the focus back to keeps it", async () => {
  window.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter" }));
  (document.activeElement as HTMLElement | null)?.blur();
  offerFocus(document.getElementById("canvas"));
  document.getElementById("find")!.focus();
  await new Promise((resolve) => setTimeout(resolve, 150));
  expect(focused()).toBe("find");
});
