import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { Model } from "../../core/model.ts";
import {
  MomentSchema,
  type Order,
  PastSchema,
  type Reply,
  ReplySchema,
  SeriesDataSchema,
  TimeLineSchema,
} from "../../core/protocol.ts";
import { Watching } from "../../core/watching.ts";
import { Recorder } from "./recorder.ts";
import type { SeriesSpec } from "./series.ts";

const kSpeed: SeriesSpec = { quantity: "speed", robot: 1, unit: "", port: "" };
const kHeading: SeriesSpec = { quantity: "heading", robot: 1, unit: "", port: "" };

function samples(...pairs: [number, number][]): Uint8Array {
  return new Uint8Array(Float64Array.from(pairs.flat()).buffer);
}

function setUp(history: (id: number) => Uint8Array) {
  const model = new Model();
  const asked: Order[] = [];
  const connection = {
    watching: new Watching(() => {}),
    ask: async (order: Order): Promise<Reply> => {
      asked.push(order);
      const wishes = order.case === "readSeries" ? (order.value.series ?? []) : [];
      const value = { samples: wishes.map((wish) => ({ id: wish.id ?? 0, samples: history(wish.id ?? 0) })) };
      return create(ReplySchema, { ok: true, result: { case: "series", value } });
    },
  };
  const recorder = new Recorder(model, connection);
  const live = (id: number, ...pairs: [number, number][]) => {
    const series = create(SeriesDataSchema, { samples: [{ id, samples: samples(...pairs) }] });
    model.accept({ body: { case: "frame", value: frameWith(series) } } as never);
  };
  return { model, recorder, connection, asked, live };
}

function frameWith(series: unknown) {
  const none = new Uint8Array();
  return {
    number: 1n,
    time: 5,
    cycle: 1n,
    robots: none,
    robotsElsewhere: 0,
    details: [],
    failsafes: [],
    stations: none,
    vectors: none,
    objects: none,
    series,
  };
}

const settle = () => new Promise((done) => setTimeout(done, 0));

describe("the recorder", () => {
  it("joins what was recorded before with what comes", async () => {
    const { recorder, live } = setUp(() => samples([0, 1], [1, 2]));
    recorder.record([kSpeed]);
    const id = recorder.recordingOf("r1/speed")?.id ?? 0;
    live(id, [2, 3]);
    await settle();
    expect([...(recorder.recordingOf("r1/speed")?.buffer.samples().values ?? [])]).toEqual([1, 2, 3]);
    expect(recorder.extent()).toEqual({ first: 0, last: 2 });
  });

  it("watches just what is chosen, and asks for the past of new series only", async () => {
    const { recorder, connection, asked } = setUp(() => samples());
    recorder.record([kSpeed]);
    recorder.record([kSpeed, kHeading]);
    await settle();
    expect(connection.watching.sum().series?.map((s) => s.quantity)).toEqual([3, 7]);
    expect(asked.map((o) => (o.case === "readSeries" ? o.value.series?.map((s) => s.quantity) : []))).toEqual([
      [3],
      [7],
    ]);
    recorder.record([]);
    expect(connection.watching.sum().series).toEqual([]);
  });

  it("shows angles in degrees", async () => {
    const { recorder } = setUp(() => samples([0, Math.PI / 2]));
    recorder.record([kHeading]);
    await settle();
    expect(recorder.recordingOf("r1/heading")?.buffer.samples().values[0]).toBeCloseTo(90);
  });

  it("fills the hole that a lost connection leaves", async () => {
    let known = samples([0, 1]);
    const { recorder, model, live } = setUp(() => known);
    recorder.record([kSpeed]);
    await settle();
    const id = recorder.recordingOf("r1/speed")?.id ?? 0;
    known = samples([0, 1], [1, 2], [2, 3]);
    live(id, [3, 4]);
    model.set("link", { state: "lost", reason: "", retryAt: 0, silentSince: 0 });
    model.set("link", { state: "open", reason: "", retryAt: 0, silentSince: 0 });
    await settle();
    expect([...(recorder.recordingOf("r1/speed")?.buffer.samples().times ?? [])]).toEqual([0, 1, 2, 3]);
  });

  it("takes nothing of another moment for what goes on, and reads the whole run there", async () => {
    const { recorder, model, connection, live } = setUp(() => samples([8, 8]));
    recorder.record([kSpeed]);
    await settle();
    const id = recorder.recordingOf("r1/speed")?.id ?? 0;
    model.set("timeLine", create(TimeLineSchema, { end: 9 }));
    model.set("moment", create(MomentSchema, { time: 3 }));
    live(id, [3, 99]);
    const past = create(PastSchema, { knownTo: 9, samples: [{ id, samples: samples([0, 1], [3, 3], [9, 9]) }] });
    connection.ask = async () => create(ReplySchema, { ok: true, result: { case: "past", value: past } });
    const stop = recorder.readPast(model, true);
    await settle();
    stop();
    expect([...(recorder.recordingOf("r1/speed")?.buffer.samples().times ?? [])]).toEqual([0, 3, 8, 9]);
    expect([...(recorder.recordingOf("r1/speed")?.buffer.samples().values ?? [])]).toEqual([1, 3, 8, 9]);
  });
});
