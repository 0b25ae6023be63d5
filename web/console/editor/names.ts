// Names in the texts of the mission and in all files of the project: where they are declared, where they are used, other
// names for them.
import type { At } from "../../core/names.ts";
import type { Reply } from "../../core/protocol.ts";
import { placesIn, type RenamingPlan, renamedText, type TextPlace } from "../../ui/names/renaming.ts";
import { sentence, withoutBackticks } from "../../ui/words/sentence.ts";
import { elsewhen } from "../session/elsewhen.ts";
import { undo } from "../session/orders.ts";
import type { Action } from "../session/registry.ts";
import type { Session } from "../session/session.ts";

export type NameAt = Pick<At, "document" | "cursor">;

/** The cursor of the text that is shown. */
export interface TextCursor {
  document: string;
  /** What was typed is sent first. */
  settle: () => Promise<void>;
  /** [bytes], and the word there; empty: none. */
  place: () => { cursor: number; word: string };
}

const cursors = new WeakMap<Session, TextCursor>();

/** @returns to be called when that text is not shown any more */
export function tellCursor(session: Session, cursor: TextCursor): () => void {
  cursors.set(session, cursor);
  return () => {
    if (cursors.get(session) === cursor) cursors.delete(session);
  };
}

const kNoName = "Put the cursor on a name in the text first.";
const kWatching = "Only the operator can rename: take control first.";

function refuse(session: Session, why: string): void {
  session.ui.tell(sentence(why, withoutBackticks), "hold");
}

/** The place that is asked about; nothing where no name stands there, which is told. */
async function asked(session: Session, text: TextCursor): Promise<(NameAt & { word: string }) | undefined> {
  await text.settle();
  const { cursor, word } = text.place();
  if (word !== "") return { document: text.document, cursor, word };
  refuse(session, kNoName);
  return undefined;
}

export async function toDefinition(session: Session, text: TextCursor): Promise<void> {
  const at = await asked(session, text);
  if (!at) return;
  const { document, cursor } = at;
  const reply = await session.connection.ask({ case: "findDefinition", value: { at: { document, cursor } } });
  if (reply.result.case !== "place" || !reply.ok) return refuse(session, reply.error);
  const { path, begin, end } = reply.result.value;
  await goTo(session, { document: path, begin, end });
}

/** Lists the places below the text. */
export async function showUses(session: Session, text: TextCursor): Promise<void> {
  const at = await asked(session, text);
  if (!at) return;
  const { ui } = session;
  const asking = { is: "asking", word: at.word } as const;
  ui.set("uses", asking);
  const { document, cursor } = at;
  const reply = await session.connection.ask({ case: "findUses", value: { at: { document, cursor } } });
  if (ui.get("uses") !== asking) return;
  const found = reply.ok && reply.result.case === "uses" ? reply.result.value : undefined;
  ui.set("uses", found ? { is: "found", list: found, places: placesIn(found) } : null);
  if (!found) refuse(session, reply.error);
}

/** Asks for another name, where it can have one. */
export async function askForName(session: Session, text: TextCursor): Promise<void> {
  if (!session.model.mayOrder()) return refuse(session, elsewhen(session.model) ?? kWatching);
  const found = await asked(session, text);
  if (!found) return;
  const { word, ...at } = found;
  const plan = await planRenaming(session, at, word);
  if (plan.is === "refused") return refuse(session, plan.why);
  session.ui.set("renaming", { at, first: plan.is === "plan" ? plan.plan.from : word });
  session.ui.set("dialog", "rename");
}

export async function planRenaming(session: Session, at: NameAt, name: string): Promise<RenamingPlan> {
  return planIn(await session.connection.ask({ case: "planRename", value: { at, name } }));
}

export function planIn({ ok, error, result }: Pick<Reply, "ok" | "error" | "result">): RenamingPlan {
  if (ok && result.case === "plan") return { is: "plan", plan: result.value };
  const why = error || "the server said no";
  if (result.case !== "place") return { is: "refused", why };
  const { path, begin, end } = result.value;
  return { is: "refused", why, place: { document: path, begin, end } };
}

/** @returns what is wrong; empty: it is done */
export async function carryOut(
  session: Session,
  at: NameAt,
  plan: Extract<RenamingPlan, { is: "plan" }>["plan"],
): Promise<string> {
  const value = { at, name: plan.to, seal: plan.seal };
  const reply = await session.connection.ask({ case: "renameEverywhere", value });
  if (!reply.ok) return reply.error;
  const { ui } = session;
  ui.set("uses", null); // their places have moved
  ui.set("notice", {
    text: renamedText(plan),
    tone: "accent",
    action: { label: "Undo", run: () => takeBack(session, `rename ${plan.from} to ${plan.to}`) },
  });
  return "";
}

function takeBack(session: Session, name: string): void {
  session.ui.set("notice", null);
  if (session.model.get("edits")?.undo === name) undo(session);
  else refuse(session, `Something else comes before “${name}”: undo that first.`);
}

/** Shows a place of a text: in its editor, or, where it is none of the mission's texts, to be read. */
export async function goTo(session: Session, { document, begin, end }: TextPlace): Promise<void> {
  const documents = session.model.get("documents")?.documents ?? [];
  const isOpen = documents.some((one) => one.path === document);
  if (!isOpen && !(await look(session, document))) return;
  session.ui.set("reveal", { document, line: 1, span: { begin, end } });
}

/** Reads a text that is not the mission's, anew where it is shown already. */
export async function look(session: Session, path: string): Promise<boolean> {
  const { ui } = session;
  const reply = await session.connection.ask({ case: "readText", value: { path } });
  if (!reply.ok || reply.result.case !== "text") {
    refuse(session, reply.error);
    return false;
  }
  const { text } = reply.result.value;
  const known = ui.get("looked");
  const isKnown = known.some((one) => one.path === path);
  if (!isKnown) ui.set("looked", [...known, { path, text }]);
  else if (known.some((one) => one.path === path && one.text !== text))
    ui.set(
      "looked",
      known.map((one) => (one.path === path ? { path, text } : one)),
    );
  return true;
}

export function nameActions(session: Session): readonly Action[] {
  const blocked = cursors.has(session) ? undefined : kNoName;
  const run = (ask: (session: Session, text: TextCursor) => Promise<void>) => () => {
    const text = cursors.get(session); // of the text that is shown by then
    if (text) void ask(session, text);
  };
  return [
    {
      id: "definition",
      label: "Go to the definition",
      group: "Edit",
      icon: "text",
      shortcut: "f12",
      blocked,
      run: run(toDefinition),
    },
    {
      id: "uses",
      label: "Find uses",
      group: "Edit",
      icon: "search",
      shortcut: "shift+f12",
      blocked,
      run: run(showUses),
    },
    {
      id: "rename",
      label: "Rename…",
      group: "Edit",
      icon: "draw",
      shortcut: "f2",
      blocked: session.model.mayOrder() ? blocked : (elsewhen(session.model) ?? kWatching),
      run: run(askForName),
    },
  ];
}
