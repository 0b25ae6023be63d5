// What the browser knows of the session. Parts that people read (scene, status, log, ...) are replaced as a whole and
// announced by name; what moves (robots, trails, stations) stands in typed arrays that each frame overwrites, for the
// map and the plots, which listen to frames.
import { Glide } from "./glide.ts";
import { applyMissionOptions, kDefaultSettings, type MapSettings } from "./map_settings.ts";
import { PointTable } from "./packed.ts";
import {
  type Bookmarks,
  type Breakpoint,
  type Clients,
  type Documents,
  type EditState,
  type FailsafeStandings,
  type Failsafes_Bounds,
  type Failsafes_Row,
  type Frame,
  type Halted,
  type HeldValues_Held,
  type Journal,
  type Log,
  type Log_Entry,
  type Machines,
  type Moment,
  type OtherFuture,
  type Plan,
  type Preflight,
  type Project,
  type Questions_Question,
  type RobotDetail,
  type Roster,
  type Scene,
  type SeriesData,
  type Status,
  Status_Mode,
  type TimeLine,
  type ToBrowser,
  type Trails,
  type Welcome,
} from "./protocol.ts";
import { RobotTable } from "./robots.ts";
import { RosterIndex } from "./roster.ts";
import { kNothing, type Selection } from "./selection.ts";
import type { LinkState } from "./server_link.ts";
import { Store } from "./store.ts";
import { TrailStore } from "./trails.ts";

export interface Parts {
  link: LinkState;
  welcome: Welcome | null;
  project: Project | null;
  documents: Documents | null;
  scene: Scene | null;
  roster: RosterIndex;
  /** Where robots that have not been started will be. */
  starts: RobotTable;
  plan: Plan | null;
  status: Status | null;
  questions: readonly Questions_Question[];
  /** Newest last, at most kLogLength. */
  log: readonly Log_Entry[];
  /** Alerts up to the log entry of this number are of an earlier run. */
  alertsAfter: bigint;
  clients: Clients | null;
  edits: EditState | null;
  breakpoints: readonly Breakpoint[];
  /** Where the run has paused at breakpoints; none while it goes on. */
  halted: Halted | null;
  /** Outputs of robots' programs that somebody holds. */
  held: readonly HeldValues_Held[];
  /** Runs that did not end, and whether what is done outlives the server. */
  journal: Journal | null;
  /** The mission's table of failsafes, the highest rank first. */
  failsafes: readonly Failsafes_Row[];
  /** What is looked at and signed before the mission moves vehicles; null: the server does not say. */
  preflight: Preflight | null;
  /** Who is in the fleet that carries the robots; null: none does. */
  machines: Machines | null;
  /** What may be tried with them. */
  failsafeBounds: Failsafes_Bounds | null;
  /** How its rows stand for robots that are watched for it, by id; announced at most ten times a second. */
  standings: ReadonlyMap<number, FailsafeStandings>;
  /** How far the run is known, and whether other moments of it can be looked at; null: the server does not say. */
  timeLine: TimeLine | null;
  /** Moments that people have marked, by time; null: the server does not say. */
  bookmarks: Bookmarks | null;
  /** Which moment this browser is told of; null: now. */
  moment: Moment | null;
  /** How the run would have gone on with something else, or the recording that it is compared with; null: none. */
  otherFuture: OtherFuture | null;
  /** Run time of the newest frame [s]; announced at most ten times a second. */
  time: number;
  /** Details of watched robots, by id; announced at most ten times a second. `Model.detail` has the newest. */
  details: ReadonlyMap<number, RobotDetail>;
  selection: Selection;
  map: MapSettings;
}

export const kLogLength = 5000;
/** RobotDetail.life of a robot that stands nowhere yet. */
export const kNotStarted = "not started";
const kMany = 1500; // robots
const kSlow = 100; // ms between announcements of what every frame changes

/** An object's place where it is not that of the Scene. */
export interface MovedObject {
  readonly x: number;
  readonly y: number;
  /** The robot that carries it; 0: nobody. */
  readonly carrier: number;
}

function placeIn(robots: RobotTable, id: number): { x: number; y: number; heading: number } | undefined {
  const row = robots.rowOf(id);
  return row < 0 ? undefined : { x: robots.x(row), y: robots.y(row), heading: robots.heading(row) };
}

export class Model extends Store<Parts> {
  readonly robots = new RobotTable();
  readonly glide = new Glide();
  readonly trails = new TrailStore();
  /** Where formations want robots, of the newest frame; empty unless watched. */
  readonly stations = new PointTable();
  /** Wanted velocities [m/s, world], of the newest frame; empty unless watched. */
  readonly vectors = new PointTable();
  readonly movedObjects = new Map<number, MovedObject>();
  /** Of the newest frame. */
  time = 0;
  cycle = 0;
  frameNumber = 0n;
  /** Started robots that the watched view leaves out. */
  robotsElsewhere = 0;

  private readonly newest = new Map<number, RobotDetail>();
  private readonly standings = new Map<number, FailsafeStandings>();
  private hasNewStandings = false;
  private readonly moved = new PointTable(4);
  private readonly frameListeners = new Set<() => void>();
  private readonly seriesListeners = new Set<(data: SeriesData) => void>();
  private announced = 0;
  private extended = 0;
  private pending: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super({
      link: { state: "connecting", reason: "", retryAt: 0, silentSince: 0 },
      welcome: null,
      project: null,
      documents: null,
      scene: null,
      roster: new RosterIndex(null),
      starts: new RobotTable(),
      plan: null,
      status: null,
      questions: [],
      log: [],
      alertsAfter: 0n,
      clients: null,
      edits: null,
      breakpoints: [],
      halted: null,
      held: [],
      journal: null,
      failsafes: [],
      failsafeBounds: null,
      preflight: null,
      machines: null,
      standings: new Map(),
      timeLine: null,
      bookmarks: null,
      moment: null,
      otherFuture: null,
      time: 0,
      details: new Map(),
      selection: kNothing,
      map: kDefaultSettings,
    });
  }

  /** Called when a frame has been taken in, before the next drawing. */
  onFrame(listener: () => void): () => void {
    this.frameListeners.add(listener);
    return () => this.frameListeners.delete(listener);
  }

  /** Called with each batch of new samples. */
  onSeries(listener: (data: SeriesData) => void): () => void {
    this.seriesListeners.add(listener);
    return () => this.seriesListeners.delete(listener);
  }

  detail(robot: number): RobotDetail | undefined {
    return this.newest.get(robot);
  }

  /** Whether this browser's person is the operator. */
  isOperator(): boolean {
    const client = this.get("welcome")?.client ?? 0;
    return client !== 0 && this.get("clients")?.operator === client;
  }

  /** Whether what is shown is of another moment than now; in a recording it always is. */
  isElsewhen(): boolean {
    return this.get("moment")?.isNow === false || this.isRecording();
  }

  /** Whether a recording was opened: nothing goes on in it. */
  isRecording(): boolean {
    return (this.get("timeLine")?.recording ?? "") !== "";
  }

  /** Whether the server takes orders of this browser: it is the operator's, and looks at what goes on. */
  mayOrder(): boolean {
    return this.isOperator() && !this.isElsewhen();
  }

  /**
   * Where the robot is: from the frame, or from its detail where the frame leaves it out; before it is started where
   * it will be.
   */
  placeOf(robot: number): { x: number; y: number; heading: number } | undefined {
    const found = placeIn(this.robots, robot) ?? placeIn(this.get("starts"), robot);
    if (found) return found;
    const detail = this.newest.get(robot);
    if (!detail || detail.life === kNotStarted) return undefined;
    return { x: detail.x, y: detail.y, heading: detail.heading };
  }

  updateMap(change: Partial<MapSettings>): void {
    this.set("map", { ...this.get("map"), ...change });
  }

  select(selection: Selection): void {
    this.set("selection", selection);
  }

  /** Takes in a message of the server. Replies are the connection's business. */
  accept(message: ToBrowser): void {
    const { body } = message;
    switch (body.case) {
      case "welcome":
        this.welcome(body.value);
        break;
      case "plan":
      case "clients":
      case "edits":
      case "documents":
      case "project":
      case "timeLine":
      case "bookmarks":
      case "moment":
      case "preflight":
      case "machines":
        this.set(body.case, body.value);
        break;
      case "otherFuture":
        this.set("otherFuture", body.value.name === "" ? null : body.value);
        break;
      case "frame":
        this.takeFrame(body.value);
        break;
      case "scene":
        this.takeScene(body.value);
        break;
      case "roster":
        this.takeRoster(body.value);
        break;
      case "starts":
        this.takeStarts(body.value.robots);
        break;
      case "status":
        this.takeStatus(body.value);
        break;
      case "questions":
        this.set("questions", body.value.questions);
        break;
      case "log":
        this.takeLog(body.value);
        break;
      case "breakpoints":
        this.set("breakpoints", body.value.breakpoints);
        break;
      case "halted":
        this.set("halted", body.value.hits.length > 0 ? body.value : null);
        break;
      case "heldValues":
        this.set("held", body.value.values);
        break;
      case "journal":
        this.set("journal", body.value);
        break;
      case "failsafes":
        this.set("failsafes", body.value.rows);
        this.set("failsafeBounds", body.value.bounds ?? null);
        break;
      case "trails":
        this.takeTrails(body.value);
        break;
    }
  }

  takeFrame(frame: Frame): void {
    const before = this.time;
    if (frame.time < before) this.goBack(frame.time);
    this.frameNumber = frame.number;
    this.time = frame.time;
    this.cycle = Number(frame.cycle);
    this.robotsElsewhere = frame.robotsElsewhere;
    const advanced = this.passes() ? frame.time - before : 0;
    this.robots.accept(frame.robots, this.glide.take(performance.now(), advanced));
    this.stations.accept(frame.stations);
    this.vectors.accept(frame.vectors);
    this.takeObjects(frame.objects);
    // From one moment to another one nobody went straight.
    if (!this.isElsewhen() || this.passes()) this.extendTrails();
    this.newest.clear();
    for (const detail of frame.details) this.newest.set(detail.id, detail);
    this.takeStandings(frame.failsafes);
    // Of another moment they are none of what goes on.
    if (frame.series && !this.isElsewhen()) for (const listener of this.seriesListeners) listener(frame.series);
    for (const listener of this.frameListeners) listener();
    this.announceSoon();
  }

  /** Whether time passes in what is shown; a jump to another moment is none. */
  private passes(): boolean {
    if (this.isElsewhen()) return (this.get("moment")?.speed ?? 0) > 0;
    const mode = this.get("status")?.mode;
    return mode === Status_Mode.RUNNING || mode === Status_Mode.WAITING;
  }

  private welcome(welcome: Welcome): void {
    const before = this.get("welcome");
    if (before && before.session !== welcome.session) {
      this.forgetPast();
      this.robots.clear();
      this.set("log", []);
      this.set("timeLine", null);
      this.set("machines", null);
      this.set("bookmarks", null);
      this.set("questions", []);
      this.set("selection", kNothing);
    }
    // A connection begins at now, also where one before it looked elsewhere.
    this.set("moment", null);
    this.set("otherFuture", null);
    this.set("welcome", welcome);
  }

  private takeScene(scene: Scene): void {
    this.trails.fitTo(this.get("roster").robots.length, Math.max(scene.width, scene.height));
    this.movedObjects.clear();
    const selection = this.get("selection");
    if (selection.items.length) {
      const lengths = {
        measure: scene.measures.length,
        obstacle: scene.obstacles.length,
        object: scene.objects.length,
      };
      const items = selection.items.filter((item) => item.index < lengths[item.kind]);
      if (items.length < selection.items.length) this.set("selection", { ...selection, items });
    }
    this.set("scene", scene);
  }

  private takeRoster(roster: Roster): void {
    const index = new RosterIndex(roster);
    const scene = this.get("scene");
    this.trails.fitTo(index.robots.length, scene ? Math.max(scene.width, scene.height) : 1000);
    const selection = this.get("selection");
    const robots = selection.robots.filter((id) => index.robot(id));
    const unit = index.unit(selection.unit) ? selection.unit : "";
    if (robots.length < selection.robots.length || unit !== selection.unit)
      this.set("selection", { ...selection, robots, unit });
    this.set("roster", index);
  }

  private takeStarts(records: Uint8Array): void {
    const starts = new RobotTable();
    starts.accept(records);
    this.set("starts", starts);
  }

  private takeStatus(status: Status): void {
    const before = this.get("status")?.options ?? [];
    this.set("map", applyMissionOptions(this.get("map"), before, status.options));
    this.set("status", status);
  }

  private takeLog(log: Log): void {
    this.set("alertsAfter", log.alertsAfter);
    const known = log.isWhole ? [] : this.get("log");
    const last = known.at(-1)?.number ?? 0n;
    const fresh = known.length ? log.entries.filter((entry) => entry.number > last) : log.entries;
    this.set("log", [...known, ...fresh].slice(-kLogLength));
  }

  /** Only those that have changed come. */
  private takeStandings(changed: readonly FailsafeStandings[]): void {
    for (const one of changed) this.standings.set(one.robot, one);
    this.hasNewStandings ||= changed.length > 0;
  }

  private takeTrails(trails: Trails): void {
    this.trails.replace(trails);
    for (const listener of this.frameListeners) listener();
  }

  private takeObjects(bytes: Uint8Array): void {
    if (bytes.length === 0) return;
    this.moved.accept(bytes);
    for (let row = 0; row < this.moved.count; ++row) {
      const carrier = this.moved.last(row);
      this.movedObjects.set(this.moved.id(row), { x: this.moved.x(row), y: this.moved.y(row), carrier });
    }
  }

  /** Of many robots a few times a second: that takes longer than all else of a frame. */
  private extendTrails(): void {
    const now = performance.now();
    if (this.robots.count > kMany && now - this.extended < kSlow) return;
    this.extended = now;
    this.trails.extend(this.robots, this.time);
  }

  /** A restart, or an earlier moment is looked at, whose trails have come before: what they say of later is forgotten. */
  private goBack(to: number): void {
    this.trails.cut(to);
    this.forgetChanges();
  }

  /** It is another server's. */
  private forgetPast(): void {
    this.time = 0;
    this.trails.clear();
    this.forgetChanges();
  }

  /** Of which frames tell what has changed alone. */
  private forgetChanges(): void {
    this.movedObjects.clear();
    this.standings.clear();
    this.hasNewStandings = true;
  }

  private announceSoon(): void {
    const now = performance.now();
    if (now - this.announced >= kSlow) this.announce(now);
    else this.pending ??= setTimeout(() => this.announce(performance.now()), kSlow - (now - this.announced));
  }

  private announce(now: number): void {
    clearTimeout(this.pending);
    this.pending = undefined;
    this.announced = now;
    this.set("time", this.time);
    if (this.hasNewStandings) this.set("standings", new Map(this.standings));
    this.hasNewStandings = false;
    if (this.newest.size || this.get("details").size) this.set("details", new Map(this.newest));
  }
}
