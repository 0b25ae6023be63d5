// Giving something another name in all files of the project: what it would change, and doing it.
import { isWide, type RenamingPlan, renamedText } from "../../ui/names/renaming.ts";
import type { Designer } from "../session/designer.ts";
import type { Answer, Plan } from "../session/protocol.ts";
import type { NameAt } from "./at.ts";

export async function planRenaming(designer: Designer, at: NameAt, name: string): Promise<RenamingPlan> {
  return read(await designer.link.ask({ case: "planRename", value: { at, name } }));
}

function read(answer: Answer): RenamingPlan {
  if (answer.ok && answer.result.case === "plan") return { is: "plan", plan: answer.result.value };
  if (answer.problems.some((one) => one.diagnostic?.kind === "no-name")) return { is: "local" };
  const { result } = answer;
  if (result.case !== "location" || result.value.document === "") return { is: "refused", why: answer.error };
  const { document, begin, end } = result.value;
  return { is: "refused", why: answer.error, place: { document, begin, end } };
}

/** @return what is wrong; empty: it is done */
export async function carryOut(designer: Designer, at: NameAt, plan: Plan): Promise<string> {
  const answer = await designer.link.ask({
    case: "renameEverywhere",
    value: { at, name: plan.to, seal: plan.seal },
  });
  if (!answer.ok) return answer.error;
  followPage(designer, plan);
  const text = renamedText(plan);
  if (!isWide(plan) && plan.notes.length === 0) designer.say(text);
  else {
    designer.store.setState({
      notice: {
        text,
        tone: "accent",
        action: { label: "Take back", run: () => void takeBack(designer) },
      },
    });
  }
  return "";
}

/** In all files that it changed. */
export async function takeBack(designer: Designer): Promise<void> {
  const answer = await designer.ask({ case: "undoRename", value: {} });
  if (!answer.ok) return;
  designer.store.setState({ notice: null });
  designer.say("The last renaming is taken back");
}

/** What a page is called after a renaming: its first part is a declaration, the others are states and nodes in it. */
export function pageAfter(page: string, { from, to, kind }: Pick<Plan, "from" | "to" | "kind">): string {
  const isInside = kind === "state" || kind === "node";
  return page
    .split(".")
    .map((part, i) => (part === from && i > 0 === isInside ? to : part))
    .join(".");
}

/** The page that is shown may be called otherwise now. */
function followPage(designer: Designer, plan: Plan): void {
  const { document, page } = designer.state;
  const now = pageAfter(page, plan);
  if (now !== page) designer.navigation.goTo(document, now);
}

/**
 * From a field that holds a name: at once where only this text changes, after a look at the whole where more does.
 * @param local  for what has no name of its own yet
 */
export async function renameNow(designer: Designer, at: NameAt, name: string, local: () => void): Promise<void> {
  const found = await planRenaming(designer, at, name);
  if (found.is === "local") local();
  else if (found.is === "refused") designer.tell(found.why);
  else if (isWide(found.plan)) {
    designer.store.setState({ dialog: "rename-name", renaming: { at, first: found.plan.from, name } });
  } else {
    const error = await carryOut(designer, at, found.plan);
    if (error) designer.tell(error);
  }
}
