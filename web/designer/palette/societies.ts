// What is done to the members of a society.
import type { Designer } from "../session/designer.ts";
import { type Document, type Drawing, type Node, Node_Shape } from "../session/protocol.ts";

/** Robots and societies of the file that may be members of the one that is drawn. */
export function memberChoices(document: Document | undefined, drawing: Drawing): { name: string; kind: string }[] {
  const own = drawing.page?.path;
  return (document?.declarations ?? [])
    .filter((one) => (one.kind === "robot" || one.kind === "society") && one.name !== own)
    .map(({ name, kind }) => ({ name, kind }));
}

/** How many members stand beside each other where this one stands. */
export function siblingsOf(drawing: Drawing, path: readonly number[]): number {
  return drawing.nodes.filter(({ member }) => isBelow(member, path.slice(0, -1))).length;
}

function isBelow(path: readonly number[], group: readonly number[]): boolean {
  return path.length === group.length + 1 && group.every((at, i) => path[i] === at);
}

/** Behind all members of a caste; `group`: its path. */
export async function addMember(
  designer: Designer,
  drawing: Drawing,
  group: readonly number[],
  name: string,
): Promise<void> {
  const society = drawing.page?.path ?? "";
  const top = drawing.nodes.find(({ member }) => member.length === 0);
  // A society that is one member only becomes two.
  const count = drawing.nodes.filter(({ member }) => isBelow(member, group)).length;
  const index = top?.shape === Node_Shape.CASTE ? count : Math.max(1, count);
  const answer = await designer.edit(`add ${name}`, {
    case: "setMember",
    value: { society, path: [...group, index], name, count: 1 },
  });
  if (answer.ok) designer.say(`Added ${name}`);
}

/** Those that are selected become one caste; they have to stand beside each other. */
export async function groupMembers(designer: Designer, drawing: Drawing, names: readonly string[]): Promise<void> {
  const chosen = drawing.nodes.filter((node) => names.includes(node.name));
  const reason = whyNoGroup(chosen);
  if (reason) return designer.tell(reason, "hold");
  const answer = await designer.edit(`make a caste of ${chosen.length === 1 ? chosen[0]!.title : chosen.length}`, {
    case: "groupMembers",
    value: {
      society: drawing.page?.path ?? "",
      path: chosen[0]!.member.slice(0, -1),
      members: chosen.map(({ member }) => member.at(-1)!),
    },
  });
  if (answer.ok) designer.select([]);
}

/** Why these can't become one caste; empty: they can. */
export function whyNoGroup(chosen: readonly Node[]): string {
  if (chosen.length === 0) return "Nothing is selected";
  if (chosen.some(({ member }) => member.length === 0)) return "The society itself can’t be grouped";
  const group = (node: Node) => node.member.slice(0, -1).join();
  const isOne = chosen.every((node) => group(node) === group(chosen[0]!));
  return isOne ? "" : "Only members of one caste can be grouped";
}
