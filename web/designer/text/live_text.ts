// One document's text and the editor that may show it. Lives as long as the page, so that nothing that was typed is lost
// when the text is hidden.
import { Annotation, type ChangeSet } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";
import { unitsOf } from "../../console/editor/bytes.ts";
import { TextSync } from "../../console/editor/sync.ts";
import { type Designer, titleOf } from "../designer.ts";
import type { Document, Fix } from "../protocol.ts";

/** On what the server changed, so that it isn't sent back. */
export const kFromServer = Annotation.define<boolean>();

const kPause = 150; // ms after a key until it goes out

export interface Mark {
  from: number;
  to: number;
  isWarning: boolean;
  message: string;
  fixes: readonly Fix[];
}

export class LiveText {
  view: EditorView | null = null;
  private readonly sync: TextSync;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly designer: Designer,
    private server: Document,
  ) {
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

  /** What is wrong, at its place in the editor. */
  marks(): Mark[] {
    return this.server.problems.flatMap(({ diagnostic, fixes }) => {
      if (!diagnostic || (diagnostic.document !== "" && diagnostic.document !== this.server.path)) return [];
      const from = this.placeOf(diagnostic.begin);
      const hints = diagnostic.hints.map((hint) => `\n${hint}`).join("");
      return [
        {
          from,
          to: Math.max(from, this.placeOf(Math.max(diagnostic.begin, diagnostic.end))),
          isWarning: diagnostic.isWarning,
          message: `${diagnostic.message}${diagnostic.label ? ` (${diagnostic.label})` : ""}${hints}`,
          fixes,
        },
      ];
    });
  }

  async flush(): Promise<void> {
    clearTimeout(this.timer);
    if (!this.designer.link.isOpen) return;
    const edit = this.sync.takeOutgoing();
    if (!edit) return;
    const name = `typing in ${titleOf(this.server.path)}`;
    const answer = await this.designer.link.ask({
      case: "editText",
      value: { document: this.server.path, name, ...edit },
    });
    this.show(this.sync.answered(answer.ok));
    if (this.sync.isAhead) this.flushSoon();
  }

  private flushSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.flush(), kPause);
  }

  private show(changes: ChangeSet | undefined): void {
    if (changes && this.view) this.view.dispatch({ changes, annotations: kFromServer.of(true) });
  }
}

const known = new WeakMap<Designer, Map<string, LiveText>>();

/** The page's live text of a document. */
export function liveText(designer: Designer, document: Document): LiveText {
  let texts = known.get(designer);
  if (!texts) {
    texts = new Map();
    known.set(designer, texts);
    const all = texts;
    designer.store.subscribe((state, before) => {
      if (state.link !== before.link && state.link.state !== "open")
        for (const text of all.values()) text.disconnected();
      if (state.documents === before.documents) return;
      for (const one of Object.values(state.documents)) all.get(one.path)?.arrived(one);
    });
  }
  let text = texts.get(document.path);
  if (!text) {
    text = new LiveText(designer, document);
    texts.set(document.path, text);
  }
  return text;
}
