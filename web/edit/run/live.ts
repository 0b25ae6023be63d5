// Running, for one page of the designer: its connection to the simulator, and what can be asked of it.

import type { Session } from "../../console/session/session.ts";
import { Ui } from "../../console/session/ui.ts";
import { Connection, tabKey } from "../../core/connection.ts";
import { Model } from "../../core/model.ts";
import { spokenPath } from "../../core/port_words.ts";
import { type Breakpoint, Control_Action, type Order, type Reply, Status_Mode } from "../../core/protocol.ts";
import { selectRobots } from "../../core/selection.ts";
import { withToken } from "../../core/server_link.ts";
import type { Designer } from "../../designer/session/designer.ts";
import { lastPart } from "../../designer/session/pages.ts";
import type { Drawing, Mark } from "../../designer/session/protocol.ts";
import { besideSimulator, kWide } from "../../designer/session/state.ts";
import { fit } from "../../designer/sight/view.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { type BreakpointInit, hitText } from "./break_points.ts";
import { gridFor, readArrows } from "./field_arrows.ts";
import { Follower } from "./follower.ts";
import { createLiveState, type DrawnAt, type LastTrial, type LiveState, setupKey } from "./live_state.ts";
import { drawnAtOf, endedMarks, type MarkInit, markAt, pinsOf, renamedBreakpoints, untoldMarks } from "./marks.ts";
import { joined } from "./places.ts";
import { remember, remembered } from "./remembered.ts";
import { isMoving, runButton, type Situation } from "./run_button.ts";
import { subjectOf } from "./subject.ts";

/** What a console keeps over reloads is the console's, not ours. */
const kForgetful = { getItem: () => null, setItem: () => {} } as unknown as Storage;
const kTakeOver = 1500; // ms in which another window hands over
const kHandOver = 30_000; // ms in which the console that was opened becomes the operator

export class Live {
  readonly model = new Model();
  readonly connection: Connection;
  readonly session: Session;
  readonly store = createLiveState();
  readonly follower: Follower;
  private handsOverUntil = 0;
  private known = new Set<number>();
  private fieldRequest = 0;
  private isTelling = false;

  constructor(readonly designer: Designer) {
    this.connection = new Connection(this.model, {
      page: designer.page,
      name: "Designer",
      clientKey: tabKey(window.sessionStorage),
    });
    const ui = new Ui(this.model, kForgetful, { width: window.innerWidth, height: window.innerHeight });
    ui.subscribe("notice", () => {
      const notice = ui.get("notice");
      if (notice) designer.tell(notice.text, notice.tone);
    });
    this.session = { model: this.model, connection: this.connection, ui };
    this.model.updateMap({ robotLabels: "all" });
    this.follower = new Follower(this);
    this.model.subscribe("roster", () => this.selectSomebody());
    this.model.subscribe("welcome", () => this.recall());
    this.store.subscribe(({ tried }, before) => {
      if (tried && tried !== before.tried) remember(window.sessionStorage, this.server, tried);
    });
    designer.store.subscribe(({ marks }, before) => {
      if (marks !== before.marks) this.takeMarks();
    });
    this.takeMarks();
    this.model.subscribe("clients", () => {
      void this.tellKept();
      this.handOver();
      this.giveWay();
    });
    this.model.subscribe("halted", () => this.tellHalt());
    this.connection.connect();
  }

  get situation(): Situation {
    const { designer, model, store } = this;
    const { isBusy, tried, subject } = store.getState();
    const document = designer.document;
    const isOurs =
      tried !== null && this.designer.nowCalled(tried.document) === document?.path && this.holds(tried.mission);
    return {
      isConnected: model.get("link").state === "open",
      isBusy,
      errors: document?.problems.filter(({ diagnostic }) => !diagnostic?.isWarning).length ?? 0,
      hasSubject: subjectOf(document?.declarations ?? [], subject, designer.state.page) !== undefined,
      isOurs,
      isCurrent: isOurs && tried.revision === document?.revision && !this.isOtherSetup(tried),
      isSameSetup: isOurs && !this.isOtherSetup(tried),
      mode: model.get("status")?.mode ?? Status_Mode.NO_MISSION,
    };
  }

  /** Whether what runs, how many or where was changed since; another page alone is none: it may be only looked at. */
  private isOtherSetup(tried: LastTrial): boolean {
    const state = this.store.getState();
    return tried.setup !== setupKey(state.subject, state);
  }

  /** Opens the pane; where the window is narrow the drawing gets the palette's room. */
  showPane(): void {
    const { shown } = this.designer.state;
    if (shown.live) return;
    this.designer.show(besideSimulator(shown, window.innerWidth < kWide));
    // Once the canvas has its new width.
    setTimeout(() => fit(), 200);
  }

  /** The large button. */
  async press(): Promise<void> {
    switch (runButton(this.situation).act) {
      case "try":
        await this.tryOut(true);
        break;
      case "execute":
        this.showPane();
        await this.control(Control_Action.EXECUTE);
        break;
      case "resume":
        await this.control(Control_Action.RESUME);
        break;
      case "pause":
        await this.control(Control_Action.PAUSE);
        break;
      case "release":
        await this.control(Control_Action.RELEASE_STOP);
        break;
      case "problems":
        this.showProblem();
        break;
      case "none":
        this.designer.say(runButton(this.situation).hint);
    }
  }

  /** The robots that run go on with what the text says now; where that can't be, they go on as they did. */
  async takeOver(): Promise<boolean> {
    return this.tryOut(false, true);
  }

  /** Hands the configuration to the simulator. */
  async tryOut(execute: boolean, takeOver = false): Promise<boolean> {
    const { designer, store } = this;
    const document = designer.document;
    if (!document) return false;
    const { robots, overlay, starts, subject } = store.getState();
    const found = subjectOf(document.declarations, subject, designer.state.page);
    if (!found || !(await this.becomeOperator())) return false;
    this.showPane();
    store.setState({ isBusy: true, error: "", takenOver: "" });
    const before = await this.renameBreakpoints(document.path);
    // Breakpoints go with their pages to where those run now, which is known when it stands ready.
    const waits = execute && (designer.state.marks[document.path] ?? []).some(({ breakpoint }) => breakpoint);
    const answer = await designer.link.ask({
      case: "try",
      value: {
        document: document.path,
        robot: found.name,
        count: robots,
        overlay,
        starts: [...starts],
        execute: execute && !waits,
        takeOver,
      },
    });
    store.setState({ isBusy: false });
    if (!answer.ok) {
      await this.goOnAsBefore(before, takeOver ? notTakenOver(answer.error) : answer.error);
      if (answer.problems.length > 0) this.showProblem();
      return false;
    }
    const trial = answer.result.case === "trial" ? answer.result.value : undefined;
    const tried = {
      document: document.path,
      revision: document.revision,
      setup: setupKey(subject, { robots, overlay, starts }),
      mission: trial?.mission ?? "",
      notes: trial?.notes ?? [],
    };
    const takenOver = sentence(trial?.takenOver ?? "");
    store.setState({ tried, takenOver, field: null, fieldError: "" });
    if (waits) {
      await this.renameBreakpoints(document.path);
      await this.control(Control_Action.EXECUTE);
    }
    designer.say(takeOver ? takenOver : execute ? `${found.name} runs` : `${found.name} stands ready`);
    this.follower.look();
    return true;
  }

  /** What ran before goes on, under its names; `why`: what was tried does not. */
  private async goOnAsBefore(breakpoints: readonly Breakpoint[], why: string): Promise<void> {
    this.store.setState({ error: sentence(why) });
    for (const breakpoint of breakpoints) await this.connection.ask({ case: "setBreakpoint", value: { breakpoint } });
    this.designer.say(why);
  }

  /** One control cycle; where nothing has been tried yet, the first. */
  async step(): Promise<void> {
    const { isOurs, isCurrent, mode } = this.situation;
    if ((!isOurs || !isCurrent) && !isMoving(mode) && !(await this.tryOut(false))) return;
    await this.control(Control_Action.SINGLE_CYCLE);
  }

  /** The robots leave; the next run begins anew. */
  async stop(): Promise<void> {
    await this.control(Control_Action.RESTART);
  }

  async control(action: Control_Action): Promise<Reply> {
    return this.order({ case: "control", value: { action } });
  }

  /** Asks of the simulator, as its operator, and tells the person where the answer is no. */
  async order(body: Order): Promise<Reply> {
    await this.becomeOperator();
    const reply = await this.connection.ask(body);
    if (!reply.ok)
      this.designer.tell(sentence(reply.error || reply.diagnostics[0]?.message || "the simulator said no"));
    return reply;
  }

  /** `id`: what of the page that is shown it is set on; `trigger`: which condition of that transition. */
  async setBreakpoint(made: (place: string) => BreakpointInit, id: string, trigger = ""): Promise<void> {
    const { drawing } = this.designer;
    const mark = drawing && markAt(drawing, id);
    const place = await this.placeToMark();
    if (!drawing || !mark || place === undefined) return;
    const { what } = made(place);
    const reply = await this.order({ case: "setBreakpoint", value: { breakpoint: { what } } });
    if (!reply.ok || reply.result.case !== "breakpoint") return;
    this.designer.say("Set a breakpoint");
    const port = what?.case === "condition" ? (what.value.port ?? "") : "";
    await this.setMark(drawing, { ...mark, place, trigger, port, breakpoint: { id: reply.result.value, what } });
  }

  async switchBreakpoint(breakpoint: Breakpoint, isOn: boolean): Promise<void> {
    await this.order({ case: "setBreakpoint", value: { breakpoint: { ...breakpoint, isOff: !isOn } } });
  }

  async removeBreakMark({ id, breakpoint }: Mark): Promise<void> {
    if (breakpoint && breakpoint.id !== 0) await this.removeBreakpoint(breakpoint.id);
    else await this.removeMark(this.designer.state.document, id);
  }

  async removeBreakpoint(id: number): Promise<void> {
    await this.order({ case: "removeBreakpoint", value: { id } });
    for (const [document, marks] of Object.entries(this.designer.state.marks)) {
      const ended = marks.filter(({ breakpoint }) => breakpoint && (id === 0 || breakpoint.id === id));
      for (const mark of ended) await this.removeMark(document, mark.id);
    }
  }

  private async setMark(drawing: Drawing, mark: MarkInit): Promise<void> {
    const document = drawing.page?.document ?? "";
    await this.designer.ask({ case: "setMark", value: { document, mark } });
  }

  /** Where the page that is shown runs; where it would, while it does not. */
  private async placeToMark(): Promise<string | undefined> {
    const { place, places } = this.store.getState();
    if (places.includes(place)) return place;
    const { document, page } = this.designer.state;
    const answer = await this.designer.ask({ case: "findLive", value: { document, page, isPlanned: true } });
    return answer.ok && answer.result.case === "live" ? answer.result.value.places[0]?.path : undefined;
  }

  /** Tells the simulator of breakpoints that an earlier one had. */
  private async tellKept(): Promise<void> {
    if (this.isTelling || !this.model.isOperator()) return;
    this.isTelling = true;
    for (const { document, mark } of untoldMarks(this.designer.state.marks)) {
      const breakpoint = { what: mark.breakpoint!.what };
      const reply = await this.connection.ask({ case: "setBreakpoint", value: { breakpoint } });
      if (!reply.ok || reply.result.case !== "breakpoint") continue;
      await this.removeMark(document, mark.id);
      const { page, node, from, to, trigger, place, port, drawn } = mark;
      const told = { page, node, from, to, trigger, place, port, drawn };
      const id = reply.result.value;
      await this.designer.link.ask({
        case: "setMark",
        value: { document, mark: { ...told, breakpoint: { ...breakpoint, id } } },
      });
    }
    this.isTelling = false;
  }

  private async removeMark(document: string, id: number): Promise<void> {
    await this.designer.link.ask({ case: "removeMark", value: { document, id } });
  }

  /** Calls breakpoints what they are called in the text that is about to run. @returns how they were */
  private async renameBreakpoints(document: string): Promise<readonly Breakpoint[]> {
    const marks = this.designer.state.marks[document] ?? [];
    const known = this.model.get("breakpoints");
    for (const { id } of endedMarks(marks, known)) await this.removeMark(document, id);
    const renamed = renamedBreakpoints(marks, known);
    for (const breakpoint of renamed) {
      await this.connection.ask({ case: "setBreakpoint", value: { breakpoint } });
    }
    return known.filter(({ id }) => renamed.some((one) => one.id === id));
  }

  /** The live parameter of all robots with the selected one's program. */
  async setParameter(port: string, value: string): Promise<boolean> {
    const roster = this.model.get("roster");
    const program = roster.robot(this.follower.robot)?.program;
    const robots = roster.robots.filter((robot) => robot.program === program).map(({ id }) => id);
    return (await this.order({ case: "setParameter", value: { robots, port, value } })).ok;
  }

  /** In the next cycle the selected robot's sequence goes to the state; `sequence`: its path. */
  async force(sequence: string, state: string): Promise<void> {
    const { robot } = this.follower;
    const { ok } = await this.order({ case: "forceState", value: { robot, sequence, state } });
    if (ok) this.designer.say(`${this.model.get("roster").nameOf(robot)} goes to ${state}`);
  }

  /** From the next cycle on the selected robot's output is held at the value. */
  async hold(port: string, value: string): Promise<boolean> {
    const { robot } = this.follower;
    const { ok } = await this.order({ case: "holdValue", value: { robot, port, value } });
    if (ok) this.designer.say(`Held ${spokenPath(port)} at ${value}`);
    return ok;
  }

  /** Robot 0: of all; port empty: all values. */
  async release(robot: number, port: string): Promise<void> {
    const { ok } = await this.order({ case: "releaseValue", value: { robot, port } });
    if (ok) this.designer.say(port === "" ? "Released all values" : `Released ${spokenPath(port)}`);
  }

  /** A live value becomes the text's. What runs is then what the text says, so it counts as tried. */
  async writeBack(port: string, value: string): Promise<void> {
    const { designer, store } = this;
    const { isOurs, isCurrent } = this.situation;
    const document = designer.state.document;
    const answer = await designer.ask({ case: "writeBack", value: { document, port, value } });
    if (!answer.ok) return;
    designer.say(`Wrote ${lastPart(port)} = ${value} to the text`);
    if (!isOurs || !isCurrent) return;
    const before = designer.document?.revision ?? 0n;
    const end = designer.store.subscribe((state) => {
      const revision = state.documents[document]?.revision ?? before;
      const { tried } = store.getState();
      if (revision === before || !tried) return;
      end();
      store.setState({ tried: { ...tried, revision } });
    });
    // The new text may have come before the answer.
    const { tried } = store.getState();
    if (tried && before !== tried.revision) {
      end();
      store.setState({ tried: { ...tried, revision: before } });
    }
  }

  /** The movement field of a node of the page, or of its result, over what the map shows. */
  async readField(node: string, visible: Parameters<typeof gridFor>[0], scale: number): Promise<void> {
    const { designer, store, model } = this;
    const scene = model.get("scene");
    const request = ++this.fieldRequest;
    const tell = (field: LiveState["field"], fieldError: string) => {
      if (request === this.fieldRequest && store.getState().showsField) store.setState({ field, fieldError });
    };
    if (!scene) {
      tell(null, "Nothing runs.");
      return;
    }
    const { area, columns, rows } = gridFor(visible, scene, scale);
    if (columns === 0 || rows === 0) {
      tell(null, "The map shows nothing of the mission's area.");
      return;
    }
    const { document, page } = designer.state;
    if (page === "") {
      tell(null, "The page of a file gives no movement; open one of its declarations.");
      return;
    }
    const robot = this.situation.isOurs ? this.follower.robot : 0; // others' robots don't run this
    const heading = model.placeOf(robot)?.heading ?? 0;
    const answer = await designer.link.ask({
      case: "readField",
      value: { document, page, node, robot, area, columns, rows, heading },
    });
    if (!answer.ok || answer.result.case !== "field") {
      tell(null, sentence(answer.error || "there is no field"));
      return;
    }
    const { arrows, note } = answer.result.value;
    const pitch = Math.min((area.xMax - area.xMin) / columns, (area.yMax - area.yMin) / rows);
    const title = spokenPath(node === "" ? page : node);
    tell({ arrows: readArrows(arrows), pitch, note, title }, "");
  }

  /** To where it is drawn. */
  goTo({ document, page, id }: DrawnAt): void {
    this.designer.goTo(document, page, id);
    this.designer.select([id]);
  }

  /** Keeps the value of what is drawn in sight; `value`: below the page's place. */
  async pin(id: string, value: string): Promise<void> {
    const { drawing } = this.designer;
    const mark = drawing && markAt(drawing, id);
    const place = await this.placeToMark();
    if (!drawing || !mark || place === undefined) return;
    this.showPane();
    await this.setMark(drawing, { ...mark, place, port: joined(place, value) });
  }

  async unpin(document: string, mark: number): Promise<void> {
    await this.removeMark(document, mark);
  }

  /** To the first error: where it is drawn, and in the list. */
  showProblem(): void {
    const { designer } = this;
    const problem = designer.document?.problems.find(({ diagnostic }) => !diagnostic?.isWarning);
    designer.show({ problems: true });
    if (!problem) return;
    designer.tell(`It does not compile: ${problem.diagnostic?.message ?? ""}`, "hold");
    if (problem.page !== "" || problem.node !== "") {
      designer.goTo(problem.diagnostic?.document || designer.state.document, problem.page, problem.node);
    }
  }

  /** The same run in the operator console, which becomes the operator. */
  openConsole(): void {
    this.known = new Set(this.model.get("clients")?.clients.map(({ id }) => id));
    this.handsOverUntil = Date.now() + kHandOver;
    window.open(withToken(this.designer.page, "./"), "_blank", "noopener");
  }

  private takeMarks(): void {
    const { marks } = this.designer.state;
    this.store.setState({ pins: pinsOf(marks), drawnAt: drawnAtOf(marks) });
    void this.tellKept();
  }

  private get server(): string {
    return this.model.get("welcome")?.session ?? "";
  }

  private recall(): void {
    const state = this.store.getState();
    if (state.tried) return;
    const tried = remembered(window.sessionStorage, this.server, setupKey(state.subject, state));
    this.store.setState({ tried });
  }

  private handOver(): void {
    if (Date.now() > this.handsOverUntil || !this.model.isOperator()) return;
    const fresh = this.model.get("clients")?.clients.find((client) => client.isConnected && !this.known.has(client.id));
    if (!fresh) return;
    this.handsOverUntil = 0;
    void this.connection.ask({ case: "passOperator", value: { client: fresh.id } });
  }

  /** Another window, or a console, asks for the operator's place: nobody here has to be asked. */
  private giveWay(): void {
    const asks = this.model.get("clients")?.asks ?? 0;
    if (asks !== 0 && this.model.isOperator())
      void this.connection.ask({ case: "passOperator", value: { client: asks } });
  }

  /** Who has set a breakpoint wants to see what it stopped at. */
  private tellHalt(): void {
    const hit = this.model.get("halted")?.hits[0];
    if (!hit) return;
    this.designer.say(`Paused: ${hitText(hit)}`);
    if (this.store.getState().drawnAt.has(hit.breakpoint)) this.showPane();
  }

  private async becomeOperator(): Promise<boolean> {
    if (this.model.isOperator()) return true;
    const reply = await this.connection.ask({ case: "takeOperator", value: {} });
    if (!reply.ok) this.designer.tell(sentence(reply.error));
    // Another window hands it over at once; a console asks who sits there.
    if (reply.ok && !(await this.isOperatorSoon()))
      this.designer.tell("A console is the operator and has been asked to hand over.", "hold");
    return reply.ok;
  }

  private isOperatorSoon(): Promise<boolean> {
    if (this.model.isOperator()) return Promise.resolve(true);
    return new Promise((resolve) => {
      const done = () => {
        clearTimeout(timer);
        stop();
        resolve(this.model.isOperator());
      };
      const timer = setTimeout(done, kTakeOver);
      const stop = this.model.subscribe("clients", () => this.model.isOperator() && done());
    });
  }

  /** Whether the mission is what the simulator holds now. */
  private holds(mission: string): boolean {
    const first = this.model.get("documents")?.documents[0]?.path;
    return mission === "" || first === mission;
  }

  private selectSomebody(): void {
    const first = this.model.get("roster").robots[0];
    if (first && this.model.get("selection").robots.length === 0) this.model.select(selectRobots([first.id]));
  }
}

const kLives = new WeakMap<Designer, Live>();

/** The page's; it connects when it is first asked for. */
export function liveOf(designer: Designer): Live {
  let live = kLives.get(designer);
  if (!live) {
    live = new Live(designer);
    kLives.set(designer, live);
  }
  return live;
}

/** Without connecting. */
export function knownLive(designer: Designer): Live | undefined {
  return kLives.get(designer);
}

function notTakenOver(why: string): string {
  return `it can't be taken over: ${why}. "Run the change" begins anew`;
}
