// Records the chosen series, whether or not the panel is on the screen, and fills in what was before.
import type { Connection } from "../../core/connection.ts";
import type { Model } from "../../core/model.ts";
import { readPast } from "../../core/past_reader.ts";
import type { Past, SeriesData } from "../../core/protocol.ts";
import { kMostWatched, type SeriesWish } from "../../core/watching.ts";
import { SampleBuffer } from "./samples.ts";
import { quantityInfo, type SeriesSpec, seriesKey } from "./series.ts";

export interface Recording {
  readonly spec: SeriesSpec;
  readonly id: number;
  readonly buffer: SampleBuffer;
  /** Why there are no samples; empty: there are, or may come. */
  error: string;
}

export const kMostSeries = kMostWatched;

/** What the recorder needs of the connection; tests bring their own. */
export type RecorderConnection = Pick<Connection, "ask" | "watching">;

export class Recorder {
  private readonly byKey = new Map<string, Recording>();
  private readonly byId = new Map<number, Recording>();
  private version = 0;

  constructor(
    model: Pick<Model, "onSeries" | "subscribe" | "get">,
    private readonly connection: RecorderConnection,
  ) {
    model.onSeries((data) => this.accept(data));
    let before = model.get("link").state;
    model.subscribe("link", () => {
      const now = model.get("link").state;
      if (now === "open" && before !== "open") this.readAll([...this.byKey.values()]);
      before = now;
    });
  }

  /** Grows whenever something was recorded. */
  get revision(): number {
    return this.version;
  }

  /** Records these and no others; at most kMostSeries. What is known of those that stay is kept. */
  record(specs: readonly SeriesSpec[]): void {
    const wanted = new Map(specs.slice(0, kMostSeries).map((spec) => [seriesKey(spec), spec]));
    for (const [key, recording] of this.byKey) {
      if (wanted.has(key)) continue;
      this.byKey.delete(key);
      this.byId.delete(recording.id);
    }
    const fresh: Recording[] = [];
    for (const [key, spec] of wanted) {
      if (this.byKey.has(key)) continue;
      const made = { spec, id: this.connection.watching.seriesId(), buffer: new SampleBuffer(), error: "" };
      this.byKey.set(key, made);
      this.byId.set(made.id, made);
      fresh.push(made);
    }
    const series = [...this.byKey.values()].map(wishOf);
    this.connection.watching.wish("plots", series.length > 0 ? { series } : null);
    this.version += 1;
    void this.readAll(fresh);
  }

  recordingOf(key: string): Recording | undefined {
    return this.byKey.get(key);
  }

  /** Of all that is recorded: the first and the last moment; infinite where there is nothing. */
  extent(): { first: number; last: number } {
    let first = Number.POSITIVE_INFINITY;
    let last = Number.NEGATIVE_INFINITY;
    for (const { buffer } of this.byKey.values()) {
      if (buffer.size === 0) continue;
      first = Math.min(first, buffer.firstTime);
      last = Math.max(last, buffer.lastTime);
    }
    return { first, last };
  }

  /**
   * Reads what was over the whole run, as it is computed again. `goesOn`: samples don't come by themselves, as while
   * another moment is shown. @returns how to end it
   */
  readPast(model: Pick<Model, "get">, goesOn: boolean): () => void {
    const recordings = [...this.byKey.values()];
    if (recordings.length === 0) return () => {};
    return readPast(
      { model, connection: this.connection },
      { wish: { series: recordings.map(wishOf) }, take: (past) => this.takePast(past), goesOn },
    );
  }

  private takePast({ samples }: Past): void {
    for (const { id, samples: bytes, error } of samples) {
      const recording = this.byId.get(id);
      if (!recording) continue;
      if (error !== "" || recording.error !== "") recording.error = error;
      recording.buffer.fill(bytes, factorOf(recording.spec));
    }
    this.version += 1;
  }

  private accept(data: SeriesData): void {
    for (const { id, samples, error } of data.samples) {
      const recording = this.byId.get(id);
      if (!recording) continue;
      recording.error = error;
      recording.buffer.appendBytes(samples, factorOf(recording.spec));
      this.version += 1;
    }
  }

  private async readAll(recordings: readonly Recording[]): Promise<void> {
    if (recordings.length === 0) return;
    const reply = await this.connection.ask({
      case: "readSeries",
      value: { series: recordings.map(wishOf) },
    });
    if (reply.result.case !== "series") return;
    for (const { id, samples, error } of reply.result.value.samples) {
      const recording = this.byId.get(id);
      if (!recording) continue;
      if (error !== "") recording.error = error;
      recording.buffer.merge(samples, factorOf(recording.spec));
    }
    this.version += 1;
  }
}

function wishOf({ id, spec }: Recording): SeriesWish {
  const quantity = spec.quantity === "port" ? 0 : (quantityInfo(spec.quantity)?.wire ?? 0);
  return { id, quantity, robot: spec.robot, unit: spec.unit, port: spec.port };
}

function factorOf(spec: SeriesSpec): number {
  return spec.quantity === "port" ? 1 : (quantityInfo(spec.quantity)?.factor ?? 1);
}

const kRecorders = new WeakMap<Model, Recorder>();

/** The one recorder of a session. */
export function recorderOf(model: Model, connection: Connection): Recorder {
  let recorder = kRecorders.get(model);
  if (!recorder) {
    recorder = new Recorder(model, connection);
    kRecorders.set(model, recorder);
  }
  return recorder;
}
