// Keeps the drawing's values those of the selected robot: asks where the page runs, watches that robot, and reads its
// details some times a second.
import { placeOfPort } from "../../core/port_values.ts";
import { Traces } from "../../designer/running/traces.ts";
import { type LiveValue, liveKey, liveValues } from "../../designer/running/values.ts";
import type { Drawing } from "../../designer/session/protocol.ts";
import { drawingOf } from "../../designer/session/state.ts";
import { heldPorts } from "./interventions.ts";
import { choosePlace, guessPlaces, witnessesOf } from "./places.ts";
import { livesOf, type Plan, planOf, portReader, portsOf, valuesOf, withTrace } from "./reading.ts";
import type { RunContext } from "./run_context.ts";
import { situationOf } from "./situation.ts";

const kPause = 50; // ms at least between two readings: 20 a second
const kPauseOfMany = 100; // where the page has many values

/** The page under which values of pins are kept. */
export const kPinPage = "$pin";
/** Below it: how long the plots of probes are; `number` is in seconds. */
export const kPinSpan = "$span";

export class Follower {
  private readonly traces = new Traces();
  /** The robot of which they are. */
  private traced = 0;
  private known: readonly { program: string; path: string }[] = [];
  private plan: Plan | null = null;
  private witnesses: ReadonlyMap<string, readonly string[]> = new Map();
  private from = ""; // the place before this page was shown
  private isUnsure = false; // which place runs was not known when one was chosen
  private asked = 0;
  private last = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly context: RunContext) {
    const { model, designer, store } = context;
    model.onFrame(() => this.soon());
    model.subscribe("selection", () => this.turn());
    model.subscribe("roster", () => this.look());
    model.subscribe("held", () => this.read());
    store.subscribe((state, before) => {
      if (state.chosenPlace !== before.chosenPlace || state.pins !== before.pins) this.turn();
    });
    designer.store.subscribe((state, before) => {
      if (state.document !== before.document || state.page !== before.page) this.look();
      else if (drawingOf(state) !== drawingOf(before)) this.turn();
    });
  }

  /** Whose values are shown; 0: nobody's. */
  get robot(): number {
    const { robots } = this.context.model.get("selection");
    return robots[0] ?? 0;
  }

  /** Asks anew where the page runs. */
  look(): void {
    const { designer, model, store } = this.context;
    const { document, page } = designer.state;
    const request = ++this.asked;
    if (document === "" || page === "" || model.get("roster").robots.length === 0) {
      this.known = [];
      this.turn();
      return;
    }
    // A place that was chosen is one of another page from here on.
    store.setState({ chosenPlace: "" });
    const programs = model.get("roster").programNames();
    void designer.link.ask({ case: "findLive", value: { document, page, programs } }).then((answer) => {
      if (request !== this.asked) return;
      this.known = answer.result.case === "live" ? answer.result.value.places : [];
      this.turn();
    });
  }

  /** Robot, page, place or pins are others now; `again`: nothing is, but which places run is known better. */
  private turn(again = false): void {
    const { model, designer, store, connection } = this.context;
    const drawing = designer.drawing;
    const ports = model.get("roster").portsOf(this.robot);
    const places = drawing && ports.length > 0 ? this.placesOf(drawing) : [];
    const before = store.getState();
    if (!again) this.from = before.place;
    this.witnesses = witnessesOf(places, ports);
    this.isUnsure = !again && places.length > 1;
    const place = choosePlace(places, {
      chosen: before.chosenPlace,
      before: this.from,
      isActive: (one) => this.isActive(one) === true,
    });
    const isSame = before.places.length === places.length && before.places.every((one, i) => one === places[i]);
    if (!isSame) store.setState({ places });
    if (place !== undefined && place !== before.place) store.setState({ place });
    this.plan = drawing && place !== undefined ? planOf(drawing, place, ports) : null;
    // Probes go on: what they have shown is of the same ports, of the same robot.
    const isOther = this.traced !== this.robot;
    this.traced = this.robot;
    this.traces.keep(new Set(isOther ? [] : before.pins.map(({ port }) => liveKey(kPinPage, port))));
    connection.watching.wish("drawing", {
      rate: designer.state.shown.live ? 30 : 15,
      details: this.robot === 0 ? [] : [this.robot],
      ports: [
        ...(this.plan ? portsOf(this.plan) : []),
        ...before.pins.map(({ port }) => port),
        ...[...this.witnesses.values()].flat(),
      ],
      readings: designer.state.shown.live && this.robot !== 0,
    });
    this.read();
  }

  private placesOf(drawing: Drawing): string[] {
    const roster = this.context.model.get("roster");
    const program = roster.programOf(this.robot);
    const own = this.known.filter((one) => one.program === program).map(({ path }) => path);
    // Of another configuration's robots nothing is guessed: they may have nodes of the same names.
    if (own.length > 0 || !situationOf(this.context).isOurs) return own;
    const lives = livesOf(drawing);
    if (lives.length === 0) return [];
    const paths = roster.portsOf(this.robot).map((port) => port.path);
    return guessPlaces(lives, paths);
  }

  /** Nothing: it is not known yet. */
  private isActive(place: string): boolean | undefined {
    const detail = this.context.model.detail(this.robot);
    const witnesses = this.witnesses.get(place) ?? [];
    if (!detail || witnesses.length === 0) return undefined;
    const ports = this.context.model.get("roster").portsOf(this.robot);
    const activities = witnesses.map((path) => {
      const at = placeOfPort(
        detail,
        ports.findIndex((port) => port.path === path),
      );
      return at < 0 ? undefined : detail.active[at] === 1;
    });
    return activities.includes(undefined) ? undefined : activities.includes(true);
  }

  private soon(): void {
    const pause = (this.plan?.index.size ?? 0) > 60 ? kPauseOfMany : kPause;
    const wait = this.last + pause - performance.now();
    if (wait <= 0) this.read();
    else this.timer ??= setTimeout(() => this.read(), wait);
  }

  private read(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.last = performance.now();
    const { model, store } = this.context;
    const detail = model.detail(this.robot);
    if (!detail) {
      if (!liveValues.isEmpty) liveValues.set(new Map());
      return;
    }
    if (this.isUnsure && [...this.witnesses.keys()].some((place) => this.isActive(place) !== undefined)) {
      this.turn(true);
      return;
    }
    this.traces.at(model.time);
    const held = heldPorts(model.get("held"), this.robot);
    const values = this.plan ? valuesOf(this.plan, detail, this.traces, held) : new Map<string, LiveValue>();
    const { pins } = store.getState();
    if (pins.length > 0) {
      const ports = model.get("roster").portsOf(this.robot);
      const read = portReader(ports, detail);
      for (const { port: path } of pins) {
        const at = ports.findIndex((port) => port.path === path);
        const value = at < 0 ? undefined : read(at);
        const key = liveKey(kPinPage, path);
        if (value) values.set(key, withTrace(value, ports[at]!, key, this.traces));
      }
      const span = Math.round(this.traces.span);
      values.set(liveKey(kPinPage, kPinSpan), { text: span < 1 ? "" : `the last ${span} s`, number: span });
    }
    liveValues.set(values);
  }
}
