// What the browser looks at: each panel says what it needs, and the server is told the sum of it.
import type { MessageInitShape } from "@bufbuild/protobuf";
import type { Series_Quantity, WatchSchema } from "./protocol.ts";

/** A number over time; `id` is what `Watching.seriesId` gave. */
export interface SeriesWish {
  readonly id: number;
  readonly quantity: Series_Quantity;
  readonly robot?: number;
  readonly unit?: string;
  readonly port?: string;
}

/** What one panel needs. What is left out, it doesn't. */
export interface WatchWish {
  /** [m, world]; only the map asks for it. Without it frames hold all robots. */
  readonly view?: { xMin: number; yMin: number; xMax: number; yMax: number };
  readonly rate?: number;
  readonly details?: readonly number[];
  /** Values of the robots in `details`: of all ports, or of these paths. */
  readonly ports?: boolean | readonly string[];
  readonly readings?: boolean;
  /** How failsafes stand for the robots in `details`. */
  readonly failsafes?: boolean;
  readonly stations?: boolean;
  readonly vectors?: boolean;
  readonly series?: readonly SeriesWish[];
}

type WatchInit = MessageInitShape<typeof WatchSchema>;

export const kMostWatched = 64;

export class Watching {
  private readonly wishes = new Map<string, WatchWish>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private lastSeries = 0;
  private told = ""; // last

  /** @param send  tells the server; called some milliseconds after a change, once for many */
  constructor(private readonly send: (watch: WatchInit) => void) {}

  /** Replaces what `owner` (a panel's own name) wished before; null: nothing any more. */
  wish(owner: string, wish: WatchWish | null): void {
    if (wish) this.wishes.set(owner, wish);
    else if (!this.wishes.delete(owner)) return;
    this.timer ??= setTimeout(() => this.tell(), 30);
  }

  /** A number that no other series has. */
  seriesId(): number {
    return ++this.lastSeries;
  }

  /** Tells the server at once, as after a new connection. */
  flush(): void {
    this.told = "";
    this.tell();
  }

  private tell(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const sum = this.sum();
    const told = JSON.stringify(sum);
    if (told === this.told) return;
    this.told = told;
    this.send(sum);
  }

  sum(): WatchInit {
    const all = [...this.wishes.values()];
    const wantsAll = all.some((wish) => wish.ports === true);
    const ports = [...new Set(all.flatMap((wish) => (Array.isArray(wish.ports) ? (wish.ports as string[]) : [])))];
    const views = all.flatMap((wish) => (wish.view ? [wish.view] : []));
    return {
      ...(views.length ? { view: views.at(-1)! } : {}),
      rate: Math.max(0, ...all.map((wish) => wish.rate ?? 0)),
      details: [...new Set(all.flatMap((wish) => wish.details ?? []))].slice(0, kMostWatched),
      withPorts: wantsAll || ports.length > 0,
      ports: wantsAll ? [] : ports,
      withReadings: all.some((wish) => wish.readings),
      withFailsafes: all.some((wish) => wish.failsafes),
      withStations: all.some((wish) => wish.stations),
      withVectors: all.some((wish) => wish.vectors),
      series: all.flatMap((wish) => wish.series ?? []).slice(0, kMostWatched),
    };
  }
}
