// The text of each open configuration, live.
import { LiveEditor, type Mark } from "../../ui/text/live_editor.ts";
import type { OutgoingEdit } from "../../ui/text/sync.ts";
import type { Designer } from "../session/designer.ts";
import type { Document, Fix } from "../session/protocol.ts";
import { titleOf } from "../session/titles.ts";

export class LiveText extends LiveEditor<Document> {
  constructor(
    private readonly designer: Designer,
    first: Document,
  ) {
    super(first);
  }

  /** What is wrong with this file, with what the server offers to do about it. */
  marks(): (Mark & { fixes: readonly Fix[] })[] {
    return this.server.problems.flatMap(({ diagnostic, fixes }) => {
      if (!diagnostic || (diagnostic.document !== "" && diagnostic.document !== this.server.path)) return [];
      return [{ ...this.markOf(diagnostic), fixes }];
    });
  }

  protected isOnline(): boolean {
    return this.designer.link.isOpen;
  }

  protected async send(edit: OutgoingEdit): Promise<boolean> {
    const name = `typing in ${titleOf(this.server.path)}`;
    const value = { document: this.server.path, name, ...edit };
    return (await this.designer.link.ask({ case: "editText", value })).ok;
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
