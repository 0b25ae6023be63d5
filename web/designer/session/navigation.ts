// Which page is shown, and how one comes to it: from page to page, by the browser's steps, by the address.
import { type Crumb, crumbsIn, shortenedTrail } from "./crumbs.ts";
import type { Designer } from "./designer.ts";
import { fromFragment, pageKey, toFragment } from "./pages.ts";
import type { Drawing, Page } from "./protocol.ts";
import type { Received } from "./received.ts";
import type { State } from "./state.ts";

/** How a page is come to: by a step of its own, which Back takes back, or along the steps that the browser has kept. */
type Step = "on" | "along";

export class Navigation {
  /** To be selected once its page is drawn; empty: nothing. */
  private pendingNode = "";
  /** Path of the page that is looked at besides the one that is shown: of a trigger. */
  private beside = "";
  /** Documents by the names that they had: steps of the browser still lead to those. */
  private readonly movedTo = new Map<string, string>();
  /** The way of a page that is being gone into: a component of the library has to be opened first. */
  private entered: Crumb[] | null = null;

  constructor(private readonly designer: Designer) {}

  private get state(): State {
    return this.designer.state;
  }

  /** Opens a document and shows its page; an empty path: a new one. */
  async open(path: string, page?: string, node = "", step: Step = "on"): Promise<boolean> {
    const answer = await this.designer.ask({ case: "open", value: { path } });
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
    this.entered = crumbsIn(this.state);
    this.goTo(document || this.state.document, path);
  }

  private turnTo(document: string, page: string, node: string, step: Step): void {
    const isSame = this.state.document === document && this.state.page === page;
    this.pendingNode = node;
    const trail = isSame ? this.state.trail : (this.entered ?? shortenedTrail(this.state.trail, document, page));
    this.entered = null;
    this.designer.store.setState({
      trail,
      document,
      page,
      selection: node && this.hasNode(document, page, node) ? [node] : [],
    });
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
      const stop = this.designer.store.subscribe((state) => state.documents[document] && done());
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
    this.designer.link.tell({
      case: "look",
      value: { pages: document ? paths.map((path) => ({ document, path })) : [] },
    });
  }

  /** After Hello: what was open before a loss is opened again; else what the address or the command line names. */
  private arrive(): void {
    const { document, page, hello } = this.state;
    if (document) {
      void this.designer.link.ask({ case: "open", value: { path: document } }).then((answer) => {
        if (answer.ok) this.look();
        else this.designer.tell(answer.error);
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

  /** Follows what the page knows by now of the message. */
  received(message: Received): void {
    switch (message.case) {
      case "hello":
        this.arrive();
        break;
      case "renamed":
        this.movedTo.set(message.value.from, message.value.to);
        this.keepAddress(false, "");
        break;
      case "drawing":
        this.selectPending(message.value);
    }
  }

  private selectPending({ page: of }: Drawing): void {
    const { document, page } = this.state;
    if (of?.document !== document || of.path !== page) return;
    if (this.pendingNode && this.hasNode(document, page, this.pendingNode)) {
      this.designer.store.setState({ selection: [this.pendingNode] });
      this.pendingNode = "";
    }
  }
}
