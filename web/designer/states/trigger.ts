// Triggers of transitions, put together by choosing.
import { rowId } from "../drawing/form.ts";
import type { Designer } from "../session/designer.ts";
import { onceDrawn } from "../session/once_drawn.ts";
import { ChangeTrigger_How, type Drawing, type Node } from "../session/protocol.ts";
import type { TriggerChoice } from "../session/state.ts";

/** A part of a trigger: `and`, `or` or `not` with what stands in it, or a question. */
export interface Term {
  /** Which operand of which operand; empty: the whole trigger. */
  readonly part: readonly number[];
  /** What stands there where no node does: a parameter, a constant. */
  readonly text: string;
  readonly node?: Node;
  readonly terms: readonly Term[];
}

type How = "choose" | "and" | "or" | "not" | "switch" | "remove";

const kHow: Readonly<Record<How, ChangeTrigger_How>> = {
  choose: ChangeTrigger_How.CHOOSE,
  and: ChangeTrigger_How.AND,
  or: ChangeTrigger_How.OR,
  not: ChangeTrigger_How.NOT,
  switch: ChangeTrigger_How.SWITCH,
  remove: ChangeTrigger_How.REMOVE,
};

/** Path of the page with what a transition asks. */
export function triggerPage(page: string, { from, index }: { from: string; index: number }): string {
  return `${page}/${from}/${index}`;
}

/** The trigger of a page of triggers; nothing where it is no node: a parameter alone. */
export function termOf(drawing: Drawing): Term | undefined {
  const root = drawing.nodes.find((node) => node.name === drawing.resultNode);
  return root && termAt(drawing, root, []);
}

function termAt(drawing: Drawing, node: Node, part: readonly number[]): Term {
  if (!["and", "or", "not"].includes(node.component)) return { part, text: "", node, terms: [] };
  const operands = node.inputs.filter((port) => !port.isList || port.index !== undefined);
  const terms = operands.map((port, i): Term => {
    const row = rowId(port.name, port.index);
    const wire = drawing.wires.find((one) => one.to === node.name && rowId(one.port, one.index) === row);
    const from = wire && drawing.nodes.find((one) => one.name === wire.from);
    return from ? termAt(drawing, from, [...part, i]) : { part: [...part, i], text: port.value, terms: [] };
  });
  return { part, text: "", node, terms };
}

/** The part of a trigger; nothing where it has none such. */
export function termIn(term: Term | undefined, part: readonly number[]): Term | undefined {
  return part.reduce<Term | undefined>((outer, place) => outer?.terms[place], term);
}

/** Where the new one stands when something is joined to a part: joined alike, it is one more operand. */
export function joinedPart(whole: Term | undefined, part: readonly number[], how: "and" | "or"): number[] {
  const term = termIn(whole, part);
  if (term?.node?.component === how) return [...part, term.terms.length];
  const outer = part.slice(0, -1);
  const isBeside = part.length > 0 && termIn(whole, outer)?.node?.component === how;
  return isBeside ? [...outer, part.at(-1)! + 1] : [...part, 1];
}

/** What gives a node its inputs, and what gives those theirs; each once. */
export function suppliersOf(drawing: Drawing, node: Node): Node[] {
  const found = new Set<string>([node.name]);
  for (const name of found) {
    for (const wire of drawing.wires) if (wire.to === name) found.add(wire.from);
  }
  found.delete(node.name);
  return drawing.nodes.filter((one) => found.has(one.name));
}

/** Draws a transition, and asks what makes it. */
export async function addTransition(designer: Designer, from: string, to: string): Promise<void> {
  const { page } = designer.state;
  const leaving = () => designer.drawing?.transitions.filter((one) => one.from === from).length ?? 0;
  const before = leaving();
  const value = { page, from, to, trigger: "" };
  const answer = await designer.edit(`transition from ${from} to ${to}`, { case: "addTransition", value });
  if (!answer.ok) return;
  const isThere = await onceDrawn(designer, () => (leaving() > before ? true : undefined));
  if (!isThere || designer.state.page !== page) return;
  designer.select([`${from}/${before}`]);
  designer.show({ details: true });
  askTrigger(designer, { from, index: before, part: [], how: "choose" });
}

export function askTrigger(designer: Designer, triggerChoice: TriggerChoice): void {
  designer.store.setState({ dialog: "trigger", triggerChoice });
}

interface TriggerPart {
  from: string;
  index: number;
  part: readonly number[];
}

/** One step of undo. */
export async function changeTrigger(
  designer: Designer,
  { from, index, part }: TriggerPart,
  how: How,
  component = "",
): Promise<boolean> {
  const { page } = designer.state;
  const value = { page, from, index, part: [...part], how: kHow[how], component };
  return (await designer.edit(`trigger of ${from}`, { case: "changeTrigger", value })).ok;
}
