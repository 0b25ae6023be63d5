// Going to other moments of the run: what is asked of the server, and what only this browser knows of it.
import { Looker } from "../../core/look_back.ts";
import { MomentFinder, neighbourMoment } from "../../core/moment_finder.ts";
import type { Bookmarks, Log_Entry, Moment } from "../../core/protocol.ts";
import { Store } from "../../core/store.ts";
import { readRecord } from "../../core/stored.ts";
import {
  type EventKind,
  eventsOf,
  kEventKinds,
  shownEvents,
  type TimeEvent,
  withBookmarks,
} from "../../ui/time/events.ts";
import { kTimeSpeeds, type TimeDoes, type Whereabouts } from "../../ui/time/time_bar.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { perSession, type Session } from "../session/session.ts";

export interface TravelParts {
  /** A moment that was asked for and is not there yet [s]. */
  wanted: number | null;
  /** Kinds of events that are neither shown nor gone to. */
  hidden: ReadonlySet<EventKind>;
  /** At which the past is played. */
  speed: number;
  isFinding: boolean;
}

const kKey = "mlab.time";
const kLost = 3000; // ms: a moment that hasn't come by then is not waited for any longer

export class TimeTravel extends Store<TravelParts> {
  readonly finder: MomentFinder;
  private readonly looker: Looker;
  /** The newest moment that has been told since one was asked for; null: none. */
  private arrived: Moment | null = null;
  private seen: {
    log: readonly Log_Entry[];
    after: bigint;
    bookmarks: Bookmarks | null;
    events: readonly TimeEvent[];
  } = { log: [], after: 0n, bookmarks: null, events: [] };
  /** Speed at which time passes from where one goes to, once one is there. */
  private playsOn = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly session: Session) {
    super({ wanted: null, isFinding: false, ...stored() });
    const { connection, model, ui } = session;
    this.finder = new MomentFinder(connection);
    this.looker = new Looker({
      ask: (order) => connection.ask(order),
      refused: (why) => {
        this.set("wanted", null);
        ui.tell(sentence(why), "hold");
      },
      // Its moment may have come before the answer.
      idle: () => this.arrive(),
    });
    model.subscribe("moment", () => {
      this.arrived = model.get("moment");
      this.arrive();
    });
    model.subscribe("welcome", () => this.finder.forget());
    for (const name of ["hidden", "speed"] as const) this.subscribe(name, () => this.keep());
  }

  readonly does: Omit<TimeDoes, "bookmark" | "bookmarks"> = {
    go: (time) => this.go(time),
    now: () => this.now(),
    step: (cycles) => {
      this.set("wanted", null);
      this.looker.look({ to: { case: "cycles", value: BigInt(cycles) }, speed: 0 });
    },
    event: (by) => this.goToEvent(by),
    play: (direction) => this.play(direction),
    speed: (speed) => {
      this.set("speed", speed);
      const now = this.whereabouts().speed;
      if (now !== 0) this.look({ case: "here", value: true }, Math.sign(now) * speed);
    },
    hide: (hidden) => this.set("hidden", hidden),
    find: () => this.set("isFinding", !this.get("isFinding")),
  };

  /** Where in the run this browser is. */
  whereabouts(): Whereabouts {
    const { model } = this.session;
    const moment = model.get("moment");
    const isNow = !model.isElsewhen();
    const wanted = this.get("wanted");
    const at = isNow
      ? { time: this.end, cycle: model.cycle }
      : { time: moment?.time ?? this.end, cycle: Number(moment?.cycle ?? 0) };
    return {
      time: wanted ?? at.time,
      cycle: at.cycle,
      speed: isNow ? 0 : (moment?.speed ?? 0),
      isNow: isNow && wanted === null,
      isComing: wanted !== null || moment?.isComing === true,
      problem: moment?.problem ?? "",
    };
  }

  /** Of the run, as far as it is known [s]. */
  get end(): number {
    const { model } = this.session;
    const known = model.get("timeLine")?.end ?? 0;
    return model.isElsewhen() ? known : Math.max(known, model.time);
  }

  /** Why no moment but now can be looked at; nothing: each can. */
  get whyNot(): string | undefined {
    const line = this.session.model.get("timeLine");
    if (!line) return "The server knows of no other moments.";
    if (line.whyNot !== "") return sentence(line.whyNot);
    return this.end > 0 ? undefined : "The run has not begun.";
  }

  events(): readonly TimeEvent[] {
    const { model } = this.session;
    const log = model.get("log");
    const after = model.get("alertsAfter");
    const bookmarks = model.get("bookmarks");
    if (log !== this.seen.log || after !== this.seen.after || bookmarks !== this.seen.bookmarks) {
      const events = withBookmarks(eventsOf(log, after), bookmarks?.bookmarks ?? []);
      this.seen = { log, after, bookmarks, events };
    }
    return this.seen.events;
  }

  go(time: number): void {
    if (this.whyNot) return;
    const to = Math.min(Math.max(0, time), this.end);
    this.set("wanted", to);
    this.arrived = null;
    this.playsOn = 0;
    this.wait();
    this.look({ case: "time", value: to }, 0);
  }

  now(): void {
    if (!this.session.model.isElsewhen() && this.get("wanted") === null) return;
    this.set("wanted", null);
    this.look({ case: "now", value: true }, 0);
  }

  private play(direction: 1 | -1 | 0): void {
    const speed = direction * this.get("speed");
    const { model } = this.session;
    // At the end there is nothing left to play: from the beginning, then.
    const last = Number(model.get("timeLine")?.lastCycle ?? 0);
    const { time, cycle } = this.whereabouts();
    const isOver = time >= this.end - 1e-6 || (last > 0 && cycle >= last);
    if (direction > 0 && model.isRecording() && isOver) {
      this.go(0);
      this.playsOn = speed;
    } else this.look({ case: "here", value: true }, speed);
  }

  private goToEvent(by: 1 | -1): void {
    const events = shownEvents(this.events(), this.get("hidden"));
    const { time, isNow } = this.whereabouts();
    const to = neighbourMoment(events, time, by);
    if (to !== undefined) this.go(to);
    else if (by > 0 && !isNow && !this.session.model.isRecording()) this.now();
  }

  private look(to: NonNullable<Parameters<Looker["look"]>[0]["to"]>, speed: number): void {
    this.looker.look({ to, speed });
  }

  /** A moment has come: that which is wanted, unless another one was asked for meanwhile. */
  private arrive(): void {
    if (this.looker.isBusy || !this.arrived || this.arrived.isComing) return;
    this.set("wanted", null);
    if (this.playsOn !== 0) this.look({ case: "here", value: true }, this.playsOn);
    this.playsOn = 0;
  }

  private wait(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      if (this.looker.isBusy) this.wait();
      else this.set("wanted", null);
    }, kLost);
  }

  private keep(): void {
    try {
      const kept = { hidden: [...this.get("hidden")], speed: this.get("speed") };
      window.localStorage.setItem(kKey, JSON.stringify(kept));
    } catch {
      // A full or forbidden storage: it is forgotten, and nothing else.
    }
  }
}

function stored(): Pick<TravelParts, "hidden" | "speed"> {
  const kept = readRecord(globalThis.localStorage?.getItem(kKey) ?? null);
  const hidden = Array.isArray(kept.hidden)
    ? kEventKinds.filter((kind) => (kept.hidden as unknown[]).includes(kind))
    : [];
  const speed = kTimeSpeeds.find((one) => one === kept.speed) ?? 1;
  return { hidden: new Set(hidden), speed };
}

export const travelOf = perSession((session) => new TimeTravel(session));
