// A text of the server and the editor that may show it. Lives as long as the page, so that nothing that was typed is lost
// when the editor is closed.
import { Annotation, type ChangeSet } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";
import type { Diagnostic } from "../../core/protocol.ts";
import { unitsOf } from "./bytes.ts";
import { type OutgoingEdit, type ServerText, TextSync } from "./sync.ts";

/** On what the server changed, so that it isn't sent back. */
export const kFromServer = Annotation.define<boolean>();

const kPause = 120; // ms after a key until it goes out

export interface Mark {
  from: number;
  to: number;
  isWarning: boolean;
  message: string;
}

export abstract class LiveEditor<Document extends ServerText> {
  view: EditorView | null = null;
  protected readonly sync: TextSync;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(protected server: Document) {
    this.sync = new TextSync(server);
  }

  get text(): string {
    return this.sync.text;
  }

  get isAhead(): boolean {
    return this.sync.isAhead;
  }

  arrived(document: Document): void {
    if (document === this.server) return;
    this.server = document;
    this.show(this.sync.arrived(document));
    this.flushSoon();
  }

  typed(changes: ChangeSet): void {
    this.sync.typed(changes);
    this.flushSoon();
  }

  disconnected(): void {
    this.sync.disconnected();
  }

  /** A place of the server's text as one in the editor. */
  placeOf(bytes: number): number {
    return Math.min(this.sync.fromServer(unitsOf(this.server.text, bytes)), this.sync.text.length);
  }

  /** What was typed goes out, if the server can be reached and nothing else is under way. */
  async flush(): Promise<void> {
    clearTimeout(this.timer);
    if (!this.isOnline()) return;
    const edit = this.sync.takeOutgoing();
    if (!edit) return;
    const isTaken = await this.send(edit);
    if (isTaken === undefined) return;
    this.show(this.sync.answered(isTaken));
    if (this.sync.isAhead) this.flushSoon();
  }

  /** What is wrong, at its place in the editor. */
  protected markOf({ begin, end, isWarning, message, label, hints }: Diagnostic): Mark {
    const from = this.placeOf(begin);
    return {
      from,
      to: Math.max(from, this.placeOf(Math.max(begin, end))),
      isWarning,
      message: `${message}${label ? ` (${label})` : ""}${hints.map((hint) => `\n${hint}`).join("")}`,
    };
  }

  protected abstract isOnline(): boolean;
  /** @returns whether the server took it; undefined: it will not, whatever is sent */
  protected abstract send(edit: OutgoingEdit): Promise<boolean | undefined>;

  private flushSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.flush(), kPause);
  }

  private show(changes: ChangeSet | undefined): void {
    if (changes && this.view) this.view.dispatch({ changes, annotations: kFromServer.of(true) });
  }
}
