// Looking at other moments of the run. Scrubbing wants more moments than can be computed: one is asked for at a time, at
// most as many a second as can be told apart, and of those that wait the newest wins.
import type { MessageInitShape } from "@bufbuild/protobuf";
import type { LookBackSchema, Order, Reply } from "./protocol.ts";

export type Look = MessageInitShape<typeof LookBackSchema>;

const kShortest = 1000 / 40; // ms between two that are asked for: thirty a second also where one comes late

export interface LookerSurroundings {
  readonly ask: (order: Order) => Promise<Reply>;
  /** Why a moment can't be shown, as the server says it. */
  readonly refused: (why: string) => void;
  /** Nothing waits any longer, and the last one was answered. */
  readonly idle?: () => void;
  /** [ms], replaced in tests. */
  readonly now?: () => number;
}

export class Looker {
  /** At most two: a moment, and steps on from it. */
  private waiting: Look[] = [];
  private isUnderWay = false;
  private last = Number.NEGATIVE_INFINITY;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly surroundings: LookerSurroundings) {}

  look(look: Look): void {
    this.waiting = withLook(this.waiting, look);
    this.send();
  }

  /** Something is asked for, or waits. */
  get isBusy(): boolean {
    return this.isUnderWay || this.waiting.length > 0;
  }

  private send(): void {
    if (this.isUnderWay || this.timer !== undefined || this.waiting.length === 0) return;
    const wait = this.last + kShortest - this.now();
    if (wait > 0) {
      this.timer = setTimeout(() => {
        this.timer = undefined;
        this.send();
      }, wait);
      return;
    }
    void this.ask(this.waiting.shift()!);
  }

  private async ask(look: Look): Promise<void> {
    this.isUnderWay = true;
    this.last = this.now();
    const reply = await this.surroundings.ask({ case: "lookBack", value: look });
    this.isUnderWay = false;
    if (!reply.ok) {
      // What was to follow on it has no ground, but what is asked for by itself has.
      this.waiting = this.waiting.filter(({ to }) => to?.case !== "cycles");
      if (this.waiting.length === 0) this.surroundings.refused(reply.error);
    }
    if (this.waiting.length === 0) this.surroundings.idle?.();
    this.send();
  }

  private now(): number {
    return this.surroundings.now?.() ?? performance.now();
  }
}

/** Steps add up; a moment takes the place of all that waits; another speed is that of what waits. */
export function withLook(waiting: readonly Look[], look: Look): Look[] {
  const last = waiting.at(-1);
  const kind = look.to?.case;
  if (!last || (kind !== "cycles" && kind !== "here")) return [look];
  if (kind === "here") return [...waiting.slice(0, -1), { ...last, speed: look.speed ?? 0 }];
  if (last.to?.case !== "cycles") return last.to?.case === "here" ? [look] : [...waiting, look];
  const cycles = last.to.value + (look.to?.value as bigint);
  return [...waiting.slice(0, -1), { to: { case: "cycles", value: cycles }, speed: look.speed ?? 0 }];
}
