import { create } from "@bufbuild/protobuf";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { Log_EntrySchema, Log_Kind, Past_SequenceSchema } from "../../core/protocol.ts";
import { eventsOf, kEventKinds, kLooks, nearestEvent, shownEvents } from "./events.ts";
import { pieceAt, stripsIn, tracksOf } from "./sequences.ts";
import { clockTicks, movedSpan, shareOf, spanWith, tickText, timeAt, wholeSpan, zoomedSpan } from "./span.ts";

const entry = (number: number, time: number, kind: Log_Kind) =>
  create(Log_EntrySchema, { number: BigInt(number), time, kind, text: `entry ${number}` });

describe("events", () => {
  it("each kind of log entry has one of the line's kinds, and each of these a sign of its own", () => {
    const log = Object.values(Log_Kind)
      .filter((kind) => typeof kind === "number")
      .map((kind, i) => entry(i + 1, i, kind as Log_Kind));
    expect(new Set(eventsOf(log, 0n).map(({ kind }) => kind))).toEqual(
      new Set(kEventKinds.filter((kind) => kind !== "bookmark")),
    );
    const asked = create(Log_EntrySchema, { number: 1n, kind: Log_Kind.MESSAGE, text: "scouts: Proceed?" });
    expect(eventsOf([asked], 0n)[0]?.kind).toBe("question");
    expect(new Set(kLooks.map(({ shape }) => shape)).size).toBe(kLooks.length);
  });

  it("those of an earlier run are left out, and they are ordered by time", () => {
    const log = [
      entry(1, 90, Log_Kind.STEP),
      entry(2, 5, Log_Kind.STEP),
      entry(3, 4, Log_Kind.STATE),
      entry(4, 6, Log_Kind.STEP),
    ];
    expect(eventsOf(log, 1n).map(({ time }) => time)).toEqual([4, 5, 6]);
    expect(shownEvents(eventsOf(log, 1n), new Set(["state"])).map(({ time }) => time)).toEqual([5, 6]);
  });

  it("the nearest one is found where it is near enough", () => {
    const events = [{ time: 1 }, { time: 4 }, { time: 10 }];
    expect(nearestEvent(events, 4.4, 1)).toEqual({ time: 4 });
    expect(nearestEvent(events, 9, 2)).toEqual({ time: 10 });
    expect(nearestEvent(events, 7, 2)).toBeUndefined();
    expect(nearestEvent([], 7, 2)).toBeUndefined();
  });
});

describe("the span that is shown", () => {
  it("stays inside of the run however it is zoomed and moved, and keeps the moment under the pointer", () => {
    const moves = fc.array(
      fc.record({
        factor: fc.double({ min: 0.2, max: 5, noNaN: true }),
        at: fc.double({ min: 0, max: 1, noNaN: true }),
        by: fc.double({ min: -1, max: 1, noNaN: true }),
      }),
      { maxLength: 20 },
    );
    fc.assert(
      fc.property(fc.double({ min: 0, max: 20000, noNaN: true }), moves, (end, all) => {
        let span = wholeSpan(end);
        for (const { factor, at, by } of all) {
          span = movedSpan(zoomedSpan(span, factor, timeAt(span, at), end), by, end);
          expect(span.from).toBeGreaterThanOrEqual(0);
          expect(span.to).toBeLessThanOrEqual(Math.max(end, 1) + 1e-6);
          expect(span.to - span.from).toBeGreaterThan(0.4);
        }
      }),
    );
    const closer = zoomedSpan({ from: 100, to: 200 }, 4, 150, 1000);
    expect(shareOf(closer, 150)).toBeCloseTo(0.5);
    expect(closer.to - closer.from).toBeCloseTo(25);
  });

  it("goes with the moment that leaves it", () => {
    expect(spanWith({ from: 10, to: 20 }, 15, 100)).toEqual({ from: 10, to: 20 });
    expect(spanWith({ from: 10, to: 20 }, 30, 100)).toEqual({ from: 21, to: 31 });
    expect(spanWith({ from: 10, to: 20 }, 0.5, 100)).toEqual({ from: 0, to: 10 });
  });

  it("labels are round moments, and never more than there is room for", () => {
    expect(clockTicks({ from: 0, to: 60 }, 6)).toEqual([0, 10, 20, 30, 40, 50, 60]);
    expect(clockTicks({ from: 3601, to: 7300 }, 4)).toEqual([5400, 7200]);
    fc.assert(
      fc.property(
        fc.double({ min: 0, max: 1e6, noNaN: true }),
        fc.double({ min: 0.5, max: 1e6, noNaN: true }),
        fc.integer({ min: 1, max: 30 }),
        (from, length, most) => {
          expect(clockTicks({ from, to: from + length }, most).length).toBeLessThanOrEqual(most + 1);
        },
      ),
    );
    expect([tickText(130, false), tickText(130.5, true), tickText(3660, false)]).toEqual(["2:10", "2:10.5", "1:01:00"]);
  });
});

describe("states over the run", () => {
  const sequence = (...spans: [number, string][]) =>
    create(Past_SequenceSchema, { path: "movement", spans: spans.map(([begin, state]) => ({ begin, state })) });

  it("each state lasts until the next one, the last one as far as the run is known, and gaps are none", () => {
    const [track] = tracksOf([sequence([0, "Wait"], [5, "Go"], [8, ""], [20, "Go"])], 30);
    expect(track?.pieces).toEqual([
      { begin: 0, end: 5, state: "Wait" },
      { begin: 5, end: 8, state: "Go" },
      { begin: 20, end: 30, state: "Go" },
    ]);
    expect(track?.states).toEqual(["Wait", "Go"]);
    expect([4.9, 5, 9, 30, 31].map((time) => pieceAt(track!, time)?.state)).toEqual([
      "Wait",
      "Go",
      undefined,
      "Go",
      undefined,
    ]);
  });

  it("of an hour of changes in each cycle no more is drawn than there are pixels", () => {
    const spans = Array.from({ length: 36000 }, (_, i): [number, string] => [i / 10, i % 2 ? "A" : "B"]);
    const [track] = tracksOf([sequence(...spans)], 3600);
    const strips = stripsIn(track!, wholeSpan(3600), 400);
    expect(strips.length).toBeLessThanOrEqual(400);
    expect(strips.some(({ state }) => state === -1)).toBe(true);
    expect(strips[0]?.left).toBe(0);
    expect(strips.at(-1)?.right).toBeCloseTo(400);
    expect(stripsIn(track!, { from: 10, to: 11 }, 400)).toHaveLength(12);
  });
});
