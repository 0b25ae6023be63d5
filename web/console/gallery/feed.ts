// Feeds the gallery with frames as a server would, and measures what drawing them costs.
import { create, toBinary } from "@bufbuild/protobuf";
import { Connection, type Surroundings } from "../../core/connection.ts";
import type { MapView } from "../../core/map/map_view.ts";
import type { Model } from "../../core/model.ts";
import { ToBrowserSchema, WelcomeSchema } from "../../core/protocol.ts";
import { frameOf, place } from "./scenes.ts";

const kFrames = 120;

export interface FrameTimes {
  readonly renderer: string;
  readonly robots: number;
  /** Main-thread time of a frame: decoding, taking it in, drawing [ms]. */
  readonly js: { p10: number; median: number; p99: number };
  /** From the message to the end of its drawing [ms]; the browser's painting comes on top. */
  readonly latency: { median: number; p99: number };
  readonly framesPerSecond: number;
  readonly acknowledged: number;
}

/** Frames of robots on patrol, as bytes. */
function encode(robots: number): ArrayBuffer[] {
  return Array.from({ length: kFrames }, (_, i) => {
    const time = i / 30;
    const placed = Array.from({ length: robots }, (_unused, robot) => place(robot, time));
    const bytes = toBinary(
      ToBrowserSchema,
      create(ToBrowserSchema, { body: { case: "frame", value: frameOf(placed, i + 1, time) } }),
    );
    return bytes.slice().buffer;
  });
}

/** Sends a frame at each display frame for so long, and tells what that cost. */
export async function measure(map: MapView, model: Model, robots: number, seconds: number): Promise<FrameTimes> {
  const frames = encode(robots);
  let acknowledged = 0;
  const socket = fakeSocket(() => ++acknowledged);
  const connection = new Connection(model, {
    page: new URL(window.location.href),
    clientKey: "gallery",
    surroundings: { ...kSurroundings, open: () => socket },
  });
  connection.connect();
  socket.onopen?.(new Event("open"));
  const say = (data: ArrayBuffer): void => {
    socket.onmessage?.(new MessageEvent("message", { data }));
  };
  say(
    toBinary(
      ToBrowserSchema,
      create(ToBrowserSchema, { body: { case: "welcome", value: create(WelcomeSchema) } }),
    ).slice().buffer,
  );

  const js: number[] = [];
  const latency: number[] = [];
  const begin = performance.now();
  let drawn = 0;
  for (let i = 0; performance.now() - begin < seconds * 1000; ++i) {
    await pause((i * 7) % 5);
    const arrived = performance.now();
    say(frames[i % kFrames]!);
    const taken = performance.now() - arrived;
    await nextFrame();
    latency.push(performance.now() - arrived);
    js.push(taken + map.statistics().drawing);
    ++drawn;
  }
  const elapsed = (performance.now() - begin) / 1000;
  connection.close();
  return {
    renderer: map.statistics().renderer,
    robots,
    js: { p10: quantile(js, 0.1), median: quantile(js, 0.5), p99: quantile(js, 0.99) },
    latency: { median: quantile(latency, 0.5), p99: quantile(latency, 0.99) },
    framesPerSecond: Math.round((drawn / elapsed) * 10) / 10,
    acknowledged,
  };
}

const kSurroundings: Surroundings = {
  open: () => {
    throw new Error("replaced");
  },
  afterDrawing: (done) => requestAnimationFrame(done),
  post: async () => false,
};

/** A socket that only listens. Its first message out is Hello, its second Watch; the rest are acknowledgements. */
function fakeSocket(onAcknowledge: () => void): WebSocket {
  let sent = 0;
  const fake = {
    readyState: 1,
    bufferedAmount: 0,
    send: () => {
      if (++sent > 2) onAcknowledge();
    },
    close: () => undefined,
  };
  return fake as unknown as WebSocket;
}

/** Frames don't come in step with the display. */
function pause(milliseconds: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}

function nextFrame(): Promise<void> {
  return new Promise((resolve) => {
    requestAnimationFrame(() => {
      // Behind the map's own drawing, which was asked for before.
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => resolve();
      port2.postMessage(0);
    });
  });
}

function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return Math.round((sorted[Math.floor(share * (sorted.length - 1))] ?? 0) * 100) / 100;
}
