// Quantities and states over the whole run. The server computes them in pieces: whoever wants them asks until all is
// there, and while the run goes on now and then for what has come since.
import type { Connection } from "./connection.ts";
import type { Model } from "./model.ts";
import type { Past } from "./protocol.ts";
import type { SeriesWish } from "./watching.ts";

const kAgain = 2000; // ms, where the run has gone on since
const kAfterRefusal = 5000; // ms
const kLittle = 2; // s of the run

export interface PastWish {
  readonly series?: readonly SeriesWish[];
  /** Robots whose states are wanted. */
  readonly statesOf?: readonly number[];
}

/** What it needs; tests bring their own. */
export interface PastSurroundings {
  readonly model: Pick<Model, "get">;
  readonly connection: Pick<Connection, "ask">;
}

export interface PastReaderOptions {
  readonly wish: PastWish;
  readonly take: (past: Past) => void;
  /** Why there is none, as the server says it; empty: there is. */
  readonly failed?: (why: string) => void;
  /** Whether what comes after the end that was known first is wanted, too. */
  readonly goesOn: boolean;
}

/** Begins to read. @returns how to end it */
export function readPast({ model, connection }: PastSurroundings, options: PastReaderOptions): () => void {
  const { wish, take, failed, goesOn } = options;
  let isOver = false;
  let known = Number.NEGATIVE_INFINITY;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const ask = async (): Promise<void> => {
    const { series = [], statesOf = [] } = wish;
    const reply = await connection.ask({ case: "readPast", value: { series: [...series], statesOf: [...statesOf] } });
    if (isOver) return;
    if (reply.result.case !== "past") {
      failed?.(reply.error);
      if (goesOn) timer = setTimeout(ask, kAfterRefusal);
      return;
    }
    failed?.("");
    const past = reply.result.value;
    take(past);
    const end = model.get("timeLine")?.end ?? 0;
    const isWhole = past.knownTo >= end - 1e-6;
    const getsOn = past.knownTo > known;
    known = past.knownTo;
    // What has come while it was computed can wait.
    if (!isWhole && getsOn && end - known > kLittle) timer = setTimeout(ask, 0);
    else if (!isWhole || goesOn) timer = setTimeout(ask, kAgain);
  };
  void ask();
  return () => {
    isOver = true;
    clearTimeout(timer);
  };
}
