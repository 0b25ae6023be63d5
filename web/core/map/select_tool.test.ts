import { create } from "@bufbuild/protobuf";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Model } from "../model.ts";
import { RosterSchema } from "../protocol.ts";
import { RosterIndex } from "../roster.ts";
import type { MapView } from "./map_view.ts";
import { SelectTool } from "./select_tool.ts";
import type { MapPick, MapPointer } from "./tool.ts";

beforeEach(() => void vi.useFakeTimers({ now: 0 }));
afterEach(() => void vi.useRealTimers());

/** A map on which the robots lie that `there` names; a click lands on them. */
function begin() {
  const model = new Model();
  const roster = create(RosterSchema, {
    units: [{ name: "scouts", members: [1, 2] }],
    robots: [1, 2, 3].map((id) => ({ id, unit: id < 3 ? "scouts" : "" })),
  });
  model.set("roster", new RosterIndex(roster));
  const tool = new SelectTool();
  const host = { style: {} };
  tool.start({ model, host, redraw() {}, setHover() {} } as unknown as MapView);
  let there: MapPick[] = [];
  const pointer = { screen: { x: 10, y: 10 }, world: { x: 0, y: 0 }, picks: () => there } as unknown as MapPointer;
  const click = (...robots: number[]) => {
    there = robots.map((id) => ({ kind: "robot", id }) as MapPick);
    tool.down(pointer);
    tool.up(pointer);
  };
  return { model, tool, pointer, click, doubleClick: () => tool.doubleClick(pointer) };
}

test("a double click on a robot that drives on between its two clicks selects its unit", () => {
  const { model, click, doubleClick } = begin();
  click(1);
  vi.advanceTimersByTime(150);
  click(); // it has gone
  expect(model.get("selection").robots).toEqual([1]);
  doubleClick();
  expect(model.get("selection").unit).toBe("scouts");
});

test("it is not another one's, that came in its place", () => {
  const { model, click, doubleClick } = begin();
  click(1);
  vi.advanceTimersByTime(150);
  click(3);
  expect(model.get("selection").robots).toEqual([1]);
  doubleClick();
  expect(model.get("selection").unit).toBe("scouts");
});

test("a later click on the empty place clears the selection, and one on a pile takes the next below", () => {
  const { model, click } = begin();
  click(1);
  vi.advanceTimersByTime(2_000);
  click();
  expect(model.get("selection").robots).toEqual([]);
  vi.advanceTimersByTime(2_000);
  click(1, 3);
  expect(model.get("selection").robots).toEqual([1]);
  click(1, 3);
  expect(model.get("selection").robots).toEqual([3]);
});
