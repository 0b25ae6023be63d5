// One document of the mission and the editor that may show it. Lives as long as the page, so that nothing that was
// typed is lost when the panel is closed.
import { Annotation, type ChangeSet } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";
import type { Documents_Document } from "../../core/protocol.ts";
import type { Session } from "../session.ts";
import { unitsOf } from "./bytes.ts";
import { TextSync } from "./sync.ts";

/** On what the server changed, so that it isn't sent back. */
export const kFromServer = Annotation.define<boolean>();

const kPause = 120; // ms after a key until it goes out

export interface Mark {
  from: number;
  to: number;
  isWarning: boolean;
  message: string;
}

export class LiveDocument {
  view: EditorView | null = null;
  private readonly sync: TextSync;
  private server: Documents_Document;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly session: Session,
    first: Documents_Document,
  ) {
    this.server = first;
    this.sync = new TextSync(first);
  }

  get text(): string {
    return this.sync.text;
  }

  get isAhead(): boolean {
    return this.sync.isAhead;
  }

  arrived(document: Documents_Document): void {
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

  /** What is wrong, at its place in the editor. */
  marks(): Mark[] {
    const { text, diagnostics } = this.server;
    const length = this.sync.text.length;
    return diagnostics.map((diagnostic) => {
      const from = this.sync.fromServer(unitsOf(text, diagnostic.begin));
      const to = this.sync.fromServer(unitsOf(text, Math.max(diagnostic.begin, diagnostic.end)));
      const hints = diagnostic.hints.map((hint) => `\n${hint}`).join("");
      return {
        from: Math.min(from, length),
        to: Math.min(Math.max(from, to), length),
        isWarning: diagnostic.isWarning,
        message: `${diagnostic.message}${diagnostic.label ? ` (${diagnostic.label})` : ""}${hints}`,
      };
    });
  }

  async flush(): Promise<void> {
    clearTimeout(this.timer);
    if (this.session.connection.model.get("link").state !== "open") return;
    const edit = this.sync.takeOutgoing();
    if (!edit) return;
    const name = `typing in ${this.server.path.slice(this.server.path.lastIndexOf("/") + 1)}`;
    const reply = await this.session.connection.ask({
      case: "editText",
      value: { document: this.server.path, name, ...edit },
    });
    if (!reply.ok && !this.session.model.isOperator()) {
      this.session.ui.tell("Only the operator can edit. What you typed is not part of the mission.");
      return;
    }
    this.show(this.sync.answered(reply.ok));
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

/** All documents of the mission, by path. */
export class LiveDocuments {
  private readonly byPath = new Map<string, LiveDocument>();

  constructor(private readonly session: Session) {
    const { model } = session;
    const take = () => {
      const documents = model.get("documents")?.documents ?? [];
      const paths = new Set(documents.map((document) => document.path));
      for (const path of [...this.byPath.keys()]) if (!paths.has(path)) this.byPath.delete(path);
      for (const document of documents) this.byPath.get(document.path)?.arrived(document);
    };
    model.subscribe("documents", take);
    model.subscribe("link", () => {
      if (model.get("link").state === "open") return;
      for (const document of this.byPath.values()) document.disconnected();
    });
  }

  of(document: Documents_Document): LiveDocument {
    let live = this.byPath.get(document.path);
    if (!live) {
      live = new LiveDocument(this.session, document);
      this.byPath.set(document.path, live);
    }
    return live;
  }
}

const known = new WeakMap<Session, LiveDocuments>();

export function liveDocuments(session: Session): LiveDocuments {
  let documents = known.get(session);
  if (!documents) {
    documents = new LiveDocuments(session);
    known.set(session, documents);
  }
  return documents;
}
