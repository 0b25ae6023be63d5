// What all parts of the page ask of the server, and tell the person. One per page.

import type { Extensions } from "./extensions.ts";
import { type Link, linkTo } from "./link.ts";
import { Navigation } from "./navigation.ts";
import type { Answer, ChangeInit, Document, Drawing, FromDesigner, Request } from "./protocol.ts";
import { stateAfter } from "./received.ts";
import {
  aloneAtTheRight,
  drawingOf,
  kNarrow,
  kWide,
  type Notice,
  type ShownPanes,
  type State,
  type Store,
  shownAfter,
} from "./state.ts";

/** Once one of these was done, what was refused before is of yesterday. */
const kMends: ReadonlySet<Request["case"]> = new Set(["edit", "undo", "redo", "save", "reload"]);

export class Designer {
  readonly link: Link;
  readonly navigation: Navigation;

  constructor(
    readonly store: Store,
    readonly page: URL,
    readonly extensions: Extensions = {},
    open?: (url: string) => WebSocket,
  ) {
    this.navigation = new Navigation(this);
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

  /** All changes or none, as one step of undo. */
  async edit(name: string, ...changes: ChangeInit[]): Promise<Answer> {
    const { document } = this.state;
    const revision = this.drawing?.revision ?? this.document?.revision ?? 0n;
    return this.ask({
      case: "edit",
      value: { document, revision, name, changes: changes.map((change) => ({ change })) },
    });
  }

  private receive({ body }: FromDesigner): void {
    if (body.case === undefined || body.case === "answer" || body.case === "beat") return;
    const { case: kind, value } = body;
    this.store.setState((state) => stateAfter(state, kind, value));
    this.navigation.received(body);
  }
}
