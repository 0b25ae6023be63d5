import fc from "fast-check";
import { describe, expect, it } from "vitest";
import {
  activePanel,
  firstLayout,
  fittedLayout,
  isShown,
  kDocks,
  type Layout,
  leavesAll,
  mapShare,
  movePanel,
  panelsIn,
  readLayout,
  resizeDock,
  showPanel,
  toggleDock,
  togglePanel,
} from "./layout.ts";
import type { Dock } from "./registry.ts";

const steps = { id: "steps", title: "Mission", dock: "left" as const };
const robots = { id: "robots", title: "Robots", dock: "left" as const };
const log = { id: "log", title: "Log", dock: "bottom" as const };
const panels = [steps, robots, log];

describe("a layout", () => {
  it("begins with the steps open and the drawer closed", () => {
    const layout = firstLayout(1280);
    expect(activePanel(layout, panels, "left")).toBe(steps);
    expect(isShown(layout, panels, "log")).toBe(false);
  });
  it("has room for the selection only on a wide screen", () => {
    expect(firstLayout(1280).docks.right.open).toBe(false);
    expect(firstLayout(1920).docks.right.open).toBe(true);
  });
  it("opens the dock of a panel that is to be shown", () => {
    expect(isShown(showPanel(firstLayout(1280), log), panels, "log")).toBe(true);
  });
  it("hides a shown panel and shows a hidden one", () => {
    const first = firstLayout(1280);
    const shown = togglePanel(first, first, panels, robots);
    expect(isShown(shown, panels, "robots")).toBe(true);
    expect(isShown(togglePanel(shown, shown, panels, robots), panels, "robots")).toBe(false);
  });
  it("moves a panel and brings it back without leaving a mark", () => {
    const first = firstLayout(1280);
    const moved = movePanel(first, robots, "right");
    expect(panelsIn(moved, panels, "right")).toEqual([robots]);
    expect(movePanel(moved, robots, "left").moved).toEqual({});
  });
  it("shows the first panel where the active one has moved away", () => {
    const layout = movePanel(showPanel(firstLayout(1280), robots), robots, "right");
    expect(activePanel(layout, panels, "left")).toBe(steps);
  });
  it("has docks that are neither too large nor too small", () => {
    expect(resizeDock(firstLayout(1280), "left", 9999).docks.left.size).toBe(560);
    expect(resizeDock(firstLayout(1280), "left", 3).docks.left.size).toBe(244);
  });
  it("leaves the layout it came from alone", () => {
    const first = firstLayout(1280);
    toggleDock(first, first, "left");
    expect(first).toEqual(firstLayout(1280));
  });
});

describe("in a window", () => {
  const small = { width: 1280, height: 800 };
  const open = (layout: Layout, ...docks: Dock[]) =>
    docks.reduce((out, dock) => (out.docks[dock].open ? out : toggleDock(out, fittedLayout(out, small), dock)), layout);
  const docksOf = (layout: Layout) => kDocks.filter((dock) => layout.docks[dock].open);

  it("of 1280 x 800 the map keeps half, whatever is opened, dragged or moved", () => {
    fc.assert(
      fc.property(
        fc.array(fc.tuple(fc.constantFrom(...kDocks), fc.integer({ min: 0, max: 900 })), { maxLength: 8 }),
        (changes) => {
          let layout = firstLayout(1280);
          for (const [dock, size] of changes) {
            layout = resizeDock(toggleDock(layout, fittedLayout(layout, small), dock), dock, size);
            const shown = fittedLayout(layout, small);
            expect(mapShare(shown, small)).toBeGreaterThanOrEqual(0.5);
            if (layout.docks[dock].open && layout.recent === dock) expect(shown.docks[dock].open).toBe(true);
          }
        },
      ),
    );
  });
  it("of 1280 x 800 there is room for both sides, and for the drawer beside one of them", () => {
    const sides = open(firstLayout(1280), "right");
    expect(docksOf(fittedLayout(sides, small))).toEqual(["left", "right"]);
    expect(docksOf(fittedLayout(open(sides, "bottom"), small))).toEqual(["left", "bottom"]);
  });
  it("what had no room is there again once it has, in its own size", () => {
    const all = open(firstLayout(1280), "right", "bottom");
    const closed = toggleDock(all, fittedLayout(all, small), "bottom");
    expect(docksOf(fittedLayout(closed, small))).toEqual(["left", "right"]);
    expect(fittedLayout(all, { width: 2560, height: 1440 })).toEqual(all);
  });
  it("that is narrow one panel is shown at most, and none at first", () => {
    const phone = { width: 390, height: 844 };
    expect(docksOf(fittedLayout(firstLayout(390), phone))).toEqual([]);
    const shown = togglePanel(firstLayout(390), fittedLayout(firstLayout(390), phone), panels, robots);
    expect(docksOf(fittedLayout(shown, phone))).toEqual(["left"]);
    const next = togglePanel(shown, fittedLayout(shown, phone), panels, log);
    expect(docksOf(fittedLayout(next, phone))).toEqual(["bottom"]);
    expect(docksOf(fittedLayout(togglePanel(next, fittedLayout(next, phone), panels, log), phone))).toEqual([]);
  });
  it("nothing opens by itself in the place of something else", () => {
    const view = { id: "view", title: "View", dock: "right" as const };
    expect(leavesAll(firstLayout(1280), view, small)).toBe(true);
    expect(leavesAll(open(firstLayout(1280), "bottom"), view, small)).toBe(false);
    expect(leavesAll(firstLayout(390), view, { width: 390, height: 844 })).toBe(false);
  });
});

describe("a stored layout", () => {
  it("comes back as it was", () => {
    const layout = movePanel(toggleDock(firstLayout(1280), firstLayout(1280), "bottom"), robots, "right");
    expect(readLayout(JSON.parse(JSON.stringify(layout)), 1280)).toEqual(layout);
  });
  it("is as at first where it can't be understood", () => {
    for (const junk of [null, 3, "x", [], { docks: 7, moved: [] }, { docks: { left: { size: "wide" } } }]) {
      expect(readLayout(junk, 1280)).toEqual(firstLayout(1280));
    }
  });
  it("drops docks that there are not", () => {
    expect(readLayout({ moved: { log: "ceiling" } }, 1280).moved).toEqual({});
  });
});
