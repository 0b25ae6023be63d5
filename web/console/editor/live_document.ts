// The documents of the mission as live texts.
import type { Documents_Document } from "../../core/protocol.ts";
import { LiveEditor, type Mark } from "../../ui/text/live_editor.ts";
import type { OutgoingEdit } from "../../ui/text/sync.ts";
import { elsewhen } from "../session/elsewhen.ts";
import type { Session } from "../session/session.ts";

export class LiveDocument extends LiveEditor<Documents_Document> {
  constructor(
    private readonly session: Session,
    first: Documents_Document,
  ) {
    super(first);
  }

  marks(): Mark[] {
    return this.server.diagnostics.map((diagnostic) => this.markOf(diagnostic));
  }

  protected isOnline(): boolean {
    return this.session.connection.model.get("link").state === "open";
  }

  protected async send(edit: OutgoingEdit): Promise<boolean | undefined> {
    const name = `typing in ${this.server.path.slice(this.server.path.lastIndexOf("/") + 1)}`;
    const reply = await this.session.connection.ask({
      case: "editText",
      value: { document: this.server.path, name, ...edit },
    });
    if (reply.ok || this.session.model.mayOrder()) return reply.ok;
    const why = elsewhen(this.session.model) ?? "Only the operator can edit.";
    this.session.ui.tell(`${why} What you typed is not part of the mission.`);
    return undefined;
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
