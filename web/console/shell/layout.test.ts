import { describe, expect, it } from "vitest";
import {
  activePanel,
  firstLayout,
  isShown,
  movePanel,
  panelsIn,
  readLayout,
  resizeDock,
  showPanel,
  toggleDock,
  togglePanel,
} from "./layout.ts";

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
  it("opens the dock of a panel that is to be shown, and says so", () => {
    const edit = showPanel(firstLayout(1280), log);
    expect(edit.name).toBe("show Log");
    expect(isShown(edit.layout, panels, "log")).toBe(true);
  });
  it("hides a shown panel and shows a hidden one", () => {
    const shown = togglePanel(firstLayout(1280), panels, robots).layout;
    expect(isShown(shown, panels, "robots")).toBe(true);
    expect(isShown(togglePanel(shown, panels, robots).layout, panels, "robots")).toBe(false);
  });
  it("moves a panel and brings it back without leaving a mark", () => {
    const first = firstLayout(1280);
    const moved = movePanel(first, robots, "right").layout;
    expect(panelsIn(moved, panels, "right")).toEqual([robots]);
    expect(movePanel(moved, robots, "left").layout.moved).toEqual({});
  });
  it("shows the first panel where the active one has moved away", () => {
    const layout = movePanel(showPanel(firstLayout(1280), robots).layout, robots, "right").layout;
    expect(activePanel(layout, panels, "left")).toBe(steps);
  });
  it("never takes the map all of its room", () => {
    expect(resizeDock(firstLayout(1280), "left", 9999, 1280).layout.docks.left.size).toBe(560);
    expect(resizeDock(firstLayout(1280), "left", 9999, 700).layout.docks.left.size).toBe(440);
    expect(resizeDock(firstLayout(1280), "left", 3, 1280).layout.docks.left.size).toBe(240);
  });
  it("leaves the layout it came from alone", () => {
    const first = firstLayout(1280);
    toggleDock(first, "left");
    expect(first).toEqual(firstLayout(1280));
  });
});

describe("a stored layout", () => {
  it("comes back as it was", () => {
    const layout = movePanel(toggleDock(firstLayout(1280), "bottom").layout, robots, "right").layout;
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
