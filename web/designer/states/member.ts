// What a state does, in CDL, where somebody chose a component for it; and a name for such a state.
import { type Component, Node_Shape } from "../session/protocol.ts";

/** `Wander()`; operators are begun empty. */
export function memberOf(component: string): string {
  if (component === "sequence") return "sequence {\n  start Waiting: Stand();\n}";
  if (component === "cooperate" || component.startsWith("compete by ")) return `${component} {}`;
  if (component.startsWith("coordinate by ")) return `${component}() {}`;
  return `${component}()`;
}

/** As its component, with a number where that is taken. */
export function stateName(component: string, taken: readonly string[]): string {
  const word = component.split(" ")[0]!;
  const base = word[0]!.toUpperCase() + word.slice(1);
  let name = base;
  for (let number = 2; taken.includes(name); ++number) name = `${base}_${number}`;
  return name;
}

const kMoving: readonly Node_Shape[] = [
  Node_Shape.ASSEMBLAGE,
  Node_Shape.BEHAVIOR,
  Node_Shape.SEQUENCE,
  Node_Shape.COOPERATION,
  Node_Shape.COMPETITION,
];

/** Whether a transition can ask it; the language's own `and`, `or` and `not` are not placed: they have buttons. */
export function isTrigger({ name, type }: Component): boolean {
  return type === "bool" && !["and", "or", "not"].includes(name);
}

/** Whether a state can do it. */
export function canBeDone(component: Component): boolean {
  if (isTrigger(component)) return false;
  return kMoving.includes(component.shape) || component.name.startsWith("coordinate by ");
}
