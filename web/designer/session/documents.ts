// What is done with a whole document: changed back, saved, compared, thrown away.
import type { Designer } from "./designer.ts";
import type { Request } from "./protocol.ts";
import { withoutDocument } from "./state.ts";
import { isNew } from "./titles.ts";

type With = NonNullable<Extract<Request, { case: "compareWith" }>["value"]["with"]>;

export function undo(designer: Designer): void {
  const { document } = designer;
  if (!document?.undo) return;
  designer.say(`Undid ${document.undo}`);
  void designer.ask({ case: "undo", value: { document: document.path } });
}

export function redo(designer: Designer): void {
  const { document } = designer;
  if (!document?.redo) return;
  designer.say(`Did again ${document.redo}`);
  void designer.ask({ case: "redo", value: { document: document.path } });
}

/** Under its name, or asks for one where it has none or can't be changed. */
export async function save(designer: Designer, overwrite = false): Promise<boolean> {
  const { document } = designer;
  if (!document) return false;
  if (document.isReadOnly || isNew(document.path)) {
    designer.store.setState({ dialog: "save-as" });
    return false;
  }
  const answer = await designer.ask({ case: "save", value: { document: document.path, overwrite } });
  if (answer.ok) designer.say(`Saved ${document.path}`);
  return answer.ok;
}

/** From now on all that differs is told and shown. @returns why not; empty: it is */
export async function compareWith(designer: Designer, what: With): Promise<string> {
  const answer = await designer.link.ask({
    case: "compareWith",
    value: { document: designer.state.document, with: what },
  });
  if (answer.ok) designer.store.setState({ difference: -1 });
  return answer.error;
}

export function stopComparing(designer: Designer): void {
  const { document } = designer.state;
  designer.link.tell({ case: "stopComparing", value: { document } });
  designer.store.setState(({ differences: { [document]: _gone, ...rest } }) => ({ differences: rest }));
}

/** Throws away a document that has no file. */
export async function discard(designer: Designer, path: string): Promise<boolean> {
  const answer = await designer.ask({ case: "discard", value: { document: path } });
  if (answer.ok) forget(designer, path);
  return answer.ok;
}

/** It is no longer, or no longer called so. */
export function forget(designer: Designer, path: string): void {
  designer.store.setState((state) => withoutDocument(state, path));
}
