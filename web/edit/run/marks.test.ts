import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { atCondition, atTransition } from "../../console/breakpoints/break_points.ts";
import { BreakpointSchema, Breakpoint_Condition_Comparison as Comparison } from "../../core/protocol.ts";
import { Drawing_Kind, DrawingSchema, MarkSchema } from "../../designer/session/protocol.ts";
import { drawnAtOf, endedMarks, markAt, pinsOf, renamedBreakpoints } from "./marks.ts";

const way = (id: number, from: string, to: string) =>
  create(BreakpointSchema, { id, ...atTransition("movement", from, to) });
const probe = create(MarkSchema, { id: 1, page: "Wander", node: "Noise", drawn: "Noise", port: "movement.Noise" });
const stop = create(MarkSchema, {
  id: 2,
  page: "Forage",
  from: "A",
  to: "B",
  drawn: "A/0",
  breakpoint: way(7, "A", "B"),
});

test("probes and places of breakpoints are those of all documents", () => {
  const marks = { "a.cdl": [probe], "b.cdl": [stop] };
  expect(pinsOf(marks)).toEqual([
    { document: "a.cdl", page: "Wander", id: "Noise", port: "movement.Noise", mark: 1, isLost: false },
  ]);
  expect([...drawnAtOf(marks)]).toEqual([[7, { document: "b.cdl", page: "Forage", id: "A/0", isLost: false }]]);
});

test("the simulator is told of breakpoints whose names are others now, and keeps the rest of them", () => {
  const known = create(BreakpointSchema, { ...way(7, "Old", "B"), isOff: true, hits: 3n });
  expect(renamedBreakpoints([probe, stop], [known])).toEqual([{ ...known, what: stop.breakpoint?.what }]);
  expect(renamedBreakpoints([stop], [way(7, "A", "B")])).toEqual([]);
  expect(renamedBreakpoints([{ ...stop, isLost: true }], [known])).toEqual([]);
  const near = create(BreakpointSchema, { id: 9, ...atCondition("movement.near", Comparison.EQUAL, "true") });
  const moved = create(MarkSchema, {
    breakpoint: create(BreakpointSchema, { id: 9, ...atCondition("movement.all.near", Comparison.EQUAL, "true") }),
  });
  expect(renamedBreakpoints([moved], [near]).map(({ what }) => what)).toEqual([moved.breakpoint?.what]);
});

test("what the simulator has no more is no mark any more; probes stay", () => {
  expect(endedMarks([probe, stop], [])).toEqual([stop]);
  expect(endedMarks([probe, stop], [way(7, "A", "B")])).toEqual([]);
});

test("a wire's mark is on what drives it, a state's on its beginning", () => {
  const dataflow = create(DrawingSchema, {
    page: { document: "a.cdl", path: "Wander" },
    kind: Drawing_Kind.DATAFLOW,
    nodes: [{ name: "Noise", live: "Noise", type: "Vector" }],
    wires: [{ from: "Noise", to: "$result", live: "Noise", type: "Vector" }],
  });
  expect(markAt(dataflow, "Noise")).toEqual({ page: "Wander", drawn: "Noise", node: "Noise" });
  expect(markAt(dataflow, "$result")).toEqual({ page: "Wander", drawn: "$result", node: "Noise" });
  expect(markAt(dataflow, "nobody")).toBeUndefined();
  const states = create(DrawingSchema, {
    page: { document: "a.cdl", path: "Forage" },
    kind: Drawing_Kind.STATES,
    states: [{ name: "A" }, { name: "B" }],
    transitions: [{ from: "A", index: 0, to: "B" }],
  });
  expect(markAt(states, "A/0")).toEqual({ page: "Forage", drawn: "A/0", from: "A", to: "B" });
  expect(markAt(states, "B")).toEqual({ page: "Forage", drawn: "B", to: "B" });
});
