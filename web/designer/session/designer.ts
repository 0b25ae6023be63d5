// What can be asked of the server, and what its messages change here. One per page.

import { type Crumb, crumbsOf, shortened } from "./crumbs.ts";
import type { Extensions } from "./extensions.ts";
import { type Link, linkTo } from "./link.ts";
import { fromFragment, pageKey, toFragment } from "./pages.ts";
import type { Answer, ChangeInit, Document, Drawing, FromDesigner, Page, Request } from "./protocol.ts";
import {
  aloneAtTheRight,
  kNarrow,
  kWide,
  type Notice,
  renamed,
  type ShownPanes,
  type State,
  type Store,
  shownAfter,
  without,
  withoutChanged,
} from "./state.ts";

/** How a page is come to: by a step of its own, which Back takes back, or along the steps that the browser has kept. */
type Step = "on" | "along";

/** Once one of these was done, what was refused before is of yesterday. */
const kMends: ReadonlySet<Request["case"]> = new Set(["edit", "undo", "redo", "save", "reload"]);

type With = NonNullable<Extract<Request, { case: "compareWith" }>["value"]["with"]>;

export class Designer {
  readonly link: Link;
  private pendingNode = "";
  /** Path of the page that is looked at besides the one that is shown: of a trigger. */
  private beside = "";
  /** Documents by the names that they had: steps of the browser still lead to those. */
  private readonly movedTo = new Map<string, string>();
  /** The way of a page that is being gone into: a component of the library has to be opened first. */
  private entered: Crumb[] | null = null;

  constructor(
    readonly store: Store,
    readonly page: URL,
    readonly extensions: Extensions = {},
    open?: (url: string) => WebSocket,
  ) {
    this.link = linkTo({
      page,
      receive: (message) => this.receive(message),
      changed: (link) => store.setState({ link }),
      ...(open ? { open } : {}),
    });
  }

  get state(): State {
    return this.store.getState();
  }

  /** The document that is shown. */
  get document(): Document | undefined {
    return this.state.documents[this.state.document];
  }

  /** The page that is shown. */
  get drawing(): Drawing | undefined {
    return drawingOf(this.state);
  }

  tell(text: string, tone: Notice["tone"] = "danger"): void {
    this.store.setState({ notice: { text, tone } });
  }

  /** For who listens to the page instead of looking at it. */
  say(spoken: string): void {
    this.store.setState({ spoken });
  }

  show(change: Partial<ShownPanes>): void {
    const width = window.innerWidth;
    const whole = width < kNarrow ? aloneAtTheRight(change) : change;
    this.store.setState(({ shown }) => ({ shown: shownAfter(shown, whole, width < kWide) }));
  }

  select(selection: readonly string[]): void {
    const before = this.state.selection;
    if (before.length === selection.length && before.every((one, i) => one === selection[i])) return;
    this.store.setState({ selection });
  }

  /** Asks, and tells the person where the answer is no. */
  async ask(request: Request): Promise<Answer> {
    const answer = await this.link.ask(request);
    if (!answer.ok) this.tell(answer.error);
    else if (kMends.has(request.case) && this.state.notice?.tone === "danger") this.store.setState({ notice: null });
    return answer;
  }

  /** Opens a document and shows its page; an empty path: a new one. */
  async open(path: string, page?: string, node = "", step: Step = "on"): Promise<boolean> {
    const answer = await this.ask({ case: "open", value: { path } });
    if (!answer.ok) return false;
    const document = answer.result.case === "text" && answer.result.value !== "" ? answer.result.value : path;
    await this.arrived(document);
    this.turnTo(document, page ?? this.firstPage(document), node, step);
    return true;
  }

  /** Shows a page of a document that is open, or opens it. */
  goTo(document: string, page: string, node = "", step: Step = "on"): void {
    if (document !== "" && !this.state.documents[document] && this.state.hello) {
      void this.open(document, page, node, step).then((isOpen) => {
        if (!isOpen) this.entered = null;
      });
      return;
    }
    this.turnTo(document, page, node, step);
  }

  /** Goes inside of something on the page that is shown, which stays on the way back. */
  enter({ document, path }: Page): void {
    this.entered = this.crumbs;
    this.goTo(document || this.state.document, path);
  }

  /** The way to the page that is shown. */
  get crumbs(): Crumb[] {
    return crumbsIn(this.state);
  }

  private turnTo(document: string, page: string, node: string, step: Step): void {
    const isSame = this.state.document === document && this.state.page === page;
    this.pendingNode = node;
    const trail = isSame ? this.state.trail : (this.entered ?? shortened(this.state.trail, document, page));
    this.entered = null;
    this.store.setState({ trail, document, page, selection: node && this.hasNode(document, page, node) ? [node] : [] });
    this.look();
    this.keepAddress(step === "on" && !isSame, node);
  }

  /** To the start page; what is not saved stays with the server. */
  leave(): void {
    this.goTo("", "");
  }

  /** The address's fragment, as when the page is loaded or somebody goes back. */
  followAddress(): void {
    const written = fromFragment(window.location.hash);
    const place = { ...written, document: this.nowCalled(written.document) };
    if (place.document !== written.document) {
      window.history.replaceState(null, "", window.location.pathname + window.location.search + toFragment(place));
    }
    const isSame = place.document === this.state.document && place.page === this.state.page;
    if (!isSame || place.node) this.goTo(place.document, place.page, place.node, "along");
  }

  /** By the name that it has since it was saved under another one. */
  nowCalled(document: string): string {
    let now = document;
    for (let i = 0; i < this.movedTo.size && !this.state.documents[now]; ++i) now = this.movedTo.get(now) ?? now;
    return now;
  }

  /** All changes or none, as one step of undo. */
  async edit(name: string, ...changes: ChangeInit[]): Promise<Answer> {
    const { document } = this.state;
    const revision = this.drawing?.revision ?? this.document?.revision ?? 0n;
    return this.ask({
      case: "edit",
      value: { document, revision, name, changes: changes.map((change) => ({ change })) },
    });
  }

  undo(): void {
    const document = this.document;
    if (!document?.undo) return;
    this.say(`Undid ${document.undo}`);
    void this.ask({ case: "undo", value: { document: document.path } });
  }

  redo(): void {
    const document = this.document;
    if (!document?.redo) return;
    this.say(`Did again ${document.redo}`);
    void this.ask({ case: "redo", value: { document: document.path } });
  }

  /** Under its name, or asks for one where it has none or can't be changed. */
  async save(overwrite = false): Promise<boolean> {
    const document = this.document;
    if (!document) return false;
    if (document.isReadOnly || isNew(document.path)) {
      this.store.setState({ dialog: "save-as" });
      return false;
    }
    const answer = await this.ask({ case: "save", value: { document: document.path, overwrite } });
    if (answer.ok) this.say(`Saved ${document.path}`);
    return answer.ok;
  }

  /** From now on all that differs is told and shown. @returns why not; empty: it is */
  async compareWith(what: With): Promise<string> {
    const answer = await this.link.ask({
      case: "compareWith",
      value: { document: this.state.document, with: what },
    });
    if (answer.ok) this.store.setState({ difference: -1 });
    return answer.error;
  }

  stopComparing(): void {
    const { document } = this.state;
    this.link.tell({ case: "stopComparing", value: { document } });
    this.store.setState(({ differences: { [document]: _gone, ...rest } }) => ({ differences: rest }));
  }

  /** Throws away a document that has no file. */
  async discard(path: string): Promise<boolean> {
    const answer = await this.ask({ case: "discard", value: { document: path } });
    if (answer.ok) this.forget(path);
    return answer.ok;
  }

  /** It is no longer, or no longer called so. */
  forget(path: string): void {
    this.store.setState((state) => without(state, path));
  }

  /** The document itself may come a moment after the answer that it is open. */
  private arrived(document: string): Promise<void> {
    return new Promise((resolve) => {
      if (this.state.documents[document]) return resolve();
      const done = () => {
        clearTimeout(timer);
        stop();
        resolve();
      };
      const timer = setTimeout(done, 3000);
      const stop = this.store.subscribe((state) => state.documents[document] && done());
    });
  }

  /** Asks for the drawing of one more page, which is not shown on the canvas; empty: of none. */
  lookBeside(path: string): void {
    if (this.beside === path) return;
    this.beside = path;
    this.look();
  }

  private look(): void {
    const { document, page } = this.state;
    const paths = this.beside === "" ? [page] : [page, this.beside];
    this.link.tell({ case: "look", value: { pages: document ? paths.map((path) => ({ document, path })) : [] } });
  }

  private receive(message: FromDesigner): void {
    const { body } = message;
    const { store } = this;
    switch (body.case) {
      case "hello":
        store.setState({ hello: body.value, notKept: "", differences: {}, pageDifferences: {} });
        this.arrive();
        break;
      case "renamed": {
        const { from, to } = body.value;
        store.setState((state) => renamed(state, from, to));
        this.movedTo.set(from, to);
        this.keepAddress(false, "");
        break;
      }
      case "lists": {
        const { recent, files, onlyKept } = body.value;
        store.setState(({ hello }) => ({ hello: hello && { ...hello, recent, files, onlyKept } }));
        break;
      }
      case "document": {
        const document = body.value;
        store.setState(({ documents }) => ({ documents: { ...documents, [document.path]: document } }));
        break;
      }
      case "drawing":
        this.take(body.value);
        break;
      case "palette": {
        const palette = body.value;
        store.setState(({ palettes }) => ({ palettes: { ...palettes, [palette.document]: palette } }));
        break;
      }
      case "fileChanged": {
        const changed = body.value;
        store.setState((state) => ({
          changed: changed.isSameAgain
            ? withoutChanged(state.changed, changed.document)
            : { ...state.changed, [changed.document]: changed },
        }));
        break;
      }
      case "keeping":
        store.setState({ notKept: body.value.notKept });
        break;
      case "differences": {
        const all = body.value;
        store.setState(({ differences }) => ({ differences: { ...differences, [all.document]: all } }));
        break;
      }
      case "pageDifference": {
        const one = body.value;
        const key = pageKey(one.page?.document ?? "", one.page?.path ?? "");
        store.setState(({ pageDifferences }) => ({ pageDifferences: { ...pageDifferences, [key]: one } }));
        break;
      }
      case "tests": {
        const list = body.value;
        store.setState(({ tests }) => ({ tests: { ...tests, [list.document]: list } }));
        break;
      }
      case "marks": {
        const { document, marks } = body.value;
        store.setState((state) => ({ marks: { ...state.marks, [document]: marks } }));
        break;
      }
    }
  }

  private take(drawing: Drawing): void {
    const key = pageKey(drawing.page?.document ?? "", drawing.page?.path ?? "");
    this.store.setState(({ drawings }) => ({ drawings: { ...drawings, [key]: drawing } }));
    const { document, page } = this.state;
    if (key !== pageKey(document, page)) return;
    if (this.pendingNode && this.hasNode(document, page, this.pendingNode)) {
      this.store.setState({ selection: [this.pendingNode] });
      this.pendingNode = "";
    }
  }

  /** After Hello: what was open before a loss is opened again; else what the address or the command line names. */
  private arrive(): void {
    const { document, page, hello } = this.state;
    if (document) {
      void this.link.ask({ case: "open", value: { path: document } }).then((answer) => {
        if (answer.ok) this.look();
        else this.tell(answer.error);
      });
      return;
    }
    const place = fromFragment(window.location.hash);
    if (place.document) void this.open(place.document, place.page, place.node, "along");
    else if (hello?.open) void this.open(hello.open, page || undefined);
  }

  private hasNode(document: string, page: string, node: string): boolean {
    const drawing = this.state.drawings[pageKey(document, page)];
    const names = [...(drawing?.nodes ?? []), ...(drawing?.states ?? [])].map((one) => one.name);
    const transitions = (drawing?.transitions ?? []).map(({ from, index }) => `${from}/${index}`);
    return [...names, ...transitions].includes(node);
  }

  /** A file with one declaration that can be drawn opens on it. */
  private firstPage(document: string): string {
    const shown = (this.state.documents[document]?.declarations ?? []).filter(({ kind }) =>
      ["assemblage", "robot", "society"].includes(kind),
    );
    return shown.length === 1 ? shown[0]!.name : "";
  }

  private keepAddress(isNewPlace: boolean, node: string): void {
    const { document, page } = this.state;
    const address = window.location.pathname + window.location.search + toFragment({ document, page, node });
    if (isNewPlace) window.history.pushState(null, "", address);
    else window.history.replaceState(null, "", address);
  }
}

/** What the next drawing is to bring: it may come a moment after the answer. */
export function soon<T>(designer: Designer, look: () => T | undefined): Promise<T | undefined> {
  return new Promise((resolve) => {
    const found = look();
    if (found !== undefined) return resolve(found);
    const done = () => {
      clearTimeout(timer);
      stop();
      resolve(look());
    };
    const timer = setTimeout(done, 1500);
    const stop = designer.store.subscribe(() => look() !== undefined && done());
  });
}

export function drawingOf(state: State): Drawing | undefined {
  return state.drawings[pageKey(state.document, state.page)];
}

export function crumbsIn(state: State): Crumb[] {
  const declared = new Set(state.documents[state.document]?.declarations.map((one) => one.name) ?? []);
  const file = { document: state.document, page: "", title: "" };
  const crumbs = crumbsOf(state.trail, drawingOf(state), state.document, declared);
  // A page that has gone stands nowhere. What a document without a file declares is not said twice on the way.
  return (crumbs.length > 0 ? crumbs : [file]).map((one) => {
    const title = state.documents[one.document]?.title ?? "";
    return one.page === "" ? { ...one, title: title.endsWith(".cdl") ? title : titleOf(one.document) } : one;
  });
}

/** A document that has no file yet. */
export function isNew(path: string): boolean {
  return /^new:\d+$/.test(path);
}

/** What a document is called: its file's name; without a file as the server calls it. */
export function nameOf(document: Document): string {
  return document.title || titleOf(document.path);
}

/** What a file is called. */
export function titleOf(path: string): string {
  if (isNew(path)) return "New configuration";
  return path.slice(Math.max(path.lastIndexOf("/"), path.lastIndexOf(":")) + 1);
}
