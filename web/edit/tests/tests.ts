// Tests of components, for one page of the designer: which are listed, what can be asked of them, and the cycle of one
// that the drawing shows in place of what runs.
import { createStore } from "zustand/vanilla";
import type { Port, RobotDetail } from "../../core/protocol.ts";
import { Traces } from "../../designer/running/traces.ts";
import { liveValues } from "../../designer/running/values.ts";
import type { Designer } from "../../designer/session/designer.ts";
import { isOfLibrary } from "../../designer/session/pages.ts";
import type { Location, TestList, TestList_Test, TestName } from "../../designer/session/protocol.ts";
import { drawingOf, kNarrow } from "../../designer/session/state.ts";
import { choosePlace } from "../run/places.ts";
import { planOf, valuesOf } from "../run/reading.ts";
import { bringsCode, dueTests, isRunning } from "./listed.ts";

/** A cycle of a test that is looked at. */
export interface ShownCycle {
  readonly test: TestName;
  /** Where the component is drawn; none: nowhere. */
  readonly page: Location | undefined;
  /** From 1. */
  readonly cycle: number;
  /** That the test runs. */
  readonly cycles: number;
  /** Where the page that is shown runs in it; none: it does not. */
  readonly places: readonly string[];
  readonly place: string;
  readonly ports: readonly Port[];
  readonly values: RobotDetail | undefined;
  /** Why there are no values; empty: there are. */
  readonly error: string;
}

export interface TestsState {
  /** Whose tests are listed. */
  home: string;
  /** What somebody has chosen; null: nobody has. */
  runsAfterChange: boolean | null;
  shown: ShownCycle | null;
}

const kKey = "mlab.designer.tests";
const kSoon = 150; // after a change that may be followed by others [ms]

export class Tests {
  readonly store = createStore<TestsState>(() => ({
    home: "",
    runsAfterChange: storedChoice(),
    shown: null,
  }));
  private watched = "";
  private question = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** The texts of which somebody wants nothing to be run by itself. */
  private left = "";

  constructor(readonly designer: Designer) {
    designer.store.subscribe((state, before) => {
      if (state.document !== before.document) this.settle();
      if (state.shown.tests !== before.shown.tests || state.document !== before.document) this.watch();
      // Behind what opens the documents of the page again.
      if (state.hello !== before.hello) setTimeout(() => this.watch(true));
      if (state.tests !== before.tests) this.runSoon();
      if (state.document !== before.document || state.page !== before.page) void this.ask();
      else if (drawingOf(state) !== drawingOf(before)) void this.ask();
    });
    this.settle();
    this.watch();
  }

  get list(): TestList | undefined {
    return this.designer.state.tests[this.store.getState().home];
  }

  /** Whether they are run whenever a text changes. */
  get runsAfterChange(): boolean {
    return this.store.getState().runsAfterChange ?? !bringsCode(this.list);
  }

  setRunsAfterChange(runsAfterChange: boolean): void {
    this.store.setState({ runsAfterChange });
    window.sessionStorage.setItem(kKey, String(runsAfterChange));
    this.runSoon();
  }

  async run(tests: readonly TestList_Test[]): Promise<void> {
    const { home } = this.store.getState();
    const names = tests.flatMap(({ test }) => (test ? [test] : []));
    await this.designer.ask({ case: "runTests", value: { document: home, tests: names } });
  }

  async runAll(): Promise<void> {
    await this.run(this.list?.tests ?? []);
  }

  /** What runs is given up, and is not begun again by itself before a text changes. */
  async stop(): Promise<void> {
    this.left = this.texts;
    await this.run([]);
  }

  private get texts(): string {
    const documents = Object.values(this.designer.state.documents);
    return documents.map(({ path, revision }) => `${path} ${revision}`).join("\n");
  }

  /** A first test of what is shown goes to the end of the text, which opens on it. */
  async write(): Promise<void> {
    const { designer } = this;
    const { document, page } = designer.state;
    const owner = page.split(/[./]/)[0] ?? "";
    const answer = await designer.ask({ case: "addTest", value: { document, component: owner } });
    if (!answer.ok || answer.result.case !== "location") return;
    designer.say("Wrote a test to the text");
    this.reveal(answer.result.value);
  }

  /** To a place of a text. */
  reveal({ document, begin, end }: Location): void {
    const { designer } = this;
    if (document !== "" && document !== designer.state.document) designer.navigation.goTo(document, "");
    designer.show({ text: true });
    designer.store.setState({ reveal: { begin, end, focus: true } });
  }

  /** To the page of what a test tests. */
  goToPage({ document, page }: Location): void {
    this.designer.navigation.goTo(document, page);
  }

  /** The drawing shows that cycle of the test; 0: its last. */
  async show({ test, page }: TestList_Test, cycle: number): Promise<void> {
    if (!test) return;
    const before = this.store.getState().shown;
    const isSame = before?.test.file === test.file && before.test.name === test.name;
    this.store.setState({
      shown: {
        ...(isSame ? before : { cycles: 0, places: [], place: "", ports: [], values: undefined }),
        test,
        page,
        cycle: cycle === 0 ? Number.MAX_SAFE_INTEGER : cycle,
        error: "",
      },
    });
    // Where the sides lie over the drawing nothing could be seen of it.
    if (window.innerWidth < kNarrow) this.designer.show({ palette: false, details: false, text: false, live: false });
    await this.ask();
    const { shown } = this.store.getState();
    const isElsewhere = shown !== null && shown.error === "" && shown.places.length === 0;
    if (isElsewhere && page && page.document !== "") this.goToPage(page);
  }

  async step(by: 1 | -1): Promise<void> {
    const { shown } = this.store.getState();
    if (!shown || !canStep(shown, by)) return;
    this.store.setState({ shown: { ...shown, cycle: shown.cycle + by } });
    await this.ask();
  }

  choosePlace(place: string): void {
    const { shown } = this.store.getState();
    if (shown) this.store.setState({ shown: { ...shown, place } });
    this.draw();
  }

  /** The drawing shows what runs again. */
  close(): void {
    ++this.question;
    this.store.setState({ shown: null });
    liveValues.showInstead(null);
    this.watch();
    this.designer.say("The values of the test are gone");
  }

  /** Inside of a component of the library one still looks at the tests of what uses it. */
  private settle(): void {
    const { document } = this.designer.state;
    if (!isOfLibrary(document) || this.store.getState().home === "") this.store.setState({ home: document });
  }

  /** `again`: the server is another one. */
  private watch(again = false): void {
    const { link } = this.designer;
    const { home, shown } = this.store.getState();
    const wanted = this.designer.state.shown.tests || shown ? home : "";
    if (wanted === this.watched && !again) return;
    if (this.watched !== "" && !again)
      link.tell({ case: "watchTests", value: { document: this.watched, isWanted: false } });
    this.watched = wanted;
    if (wanted === "") return;
    void this.open(wanted).then(() => link.tell({ case: "watchTests", value: { document: wanted, isWanted: true } }));
  }

  /** The server knows only documents that this page has opened. */
  private open(document: string): Promise<void> {
    if (this.designer.state.documents[document]) return Promise.resolve();
    return new Promise((resolve) => {
      const stop = this.designer.store.subscribe((state) => {
        if (!state.documents[document] && state.document === document) return;
        stop();
        resolve();
      });
    });
  }

  private runSoon(): void {
    clearTimeout(this.timer);
    if (!this.runsAfterChange || !this.isDue()) return;
    this.timer = setTimeout(() => this.isDue() && void this.run(dueTests(this.list)), kSoon);
  }

  private isDue(): boolean {
    const { list } = this;
    if (this.left === this.texts) return false;
    return this.watched !== "" && list !== undefined && list.isKnown && dueTests(list).length > 0 && !isRunning(list);
  }

  /** Asks for the values of the page that is shown. */
  private async ask(): Promise<void> {
    const { designer, store } = this;
    const { shown } = store.getState();
    const { document, page } = designer.state;
    if (!shown) return;
    if (!designer.state.documents[document] || page === "") {
      store.setState({ shown: { ...shown, places: [], ports: [], values: undefined } });
      this.draw();
      return;
    }
    const question = ++this.question;
    const cycle = Math.min(shown.cycle, 0xffffffff);
    const answer = await designer.link.ask({
      case: "showTestCycle",
      value: { test: shown.test, cycle, document, page },
    });
    if (question !== this.question) return;
    if (!answer.ok || answer.result.case !== "testCycle") {
      store.setState({ shown: { ...shown, places: [], ports: [], values: undefined, error: answer.error } });
      this.draw();
      return;
    }
    const { cycle: at, cycles, places, ports, values } = answer.result.value;
    const place = choosePlace(places, { chosen: shown.place, before: shown.place, isActive: () => false }) ?? "";
    store.setState({ shown: { ...shown, cycle: at, cycles, places, place, ports, values, error: "" } });
    this.draw();
  }

  private draw(): void {
    const { shown } = this.store.getState();
    const { drawing } = this.designer;
    const isThere = shown?.values && drawing && shown.places.length > 0;
    liveValues.showInstead(
      isThere ? valuesOf(planOf(drawing, shown.place, shown.ports), shown.values!, new Traces(), new Set()) : new Map(),
    );
  }
}

export function canStep({ cycle, cycles, error }: ShownCycle, by: 1 | -1): boolean {
  return error === "" && cycles > 0 && cycle + by >= 1 && cycle + by <= cycles;
}

function storedChoice(): boolean | null {
  const stored = window.sessionStorage.getItem(kKey);
  return stored === "true" ? true : stored === "false" ? false : null;
}

const kTests = new WeakMap<Designer, Tests>();

/** The page's. */
export function testsOf(designer: Designer): Tests {
  let tests = kTests.get(designer);
  if (!tests) {
    tests = new Tests(designer);
    kTests.set(designer, tests);
  }
  return tests;
}
