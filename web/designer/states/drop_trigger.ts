// Triggers that come out of the palette: they go to a transition, not to a place.
import type { Designer } from "../session/designer.ts";
import { Drawing_Kind, type Transition } from "../session/protocol.ts";
import { transitionId, transitionOf } from "./flow.ts";
import { isTrigger } from "./member.ts";
import { changeTrigger } from "./trigger.ts";
import { isNoTrigger } from "./trigger_words.ts";

/** Whether it would be a trigger on the page that is shown. */
export function isTriggerHere(designer: Designer, component: string): boolean {
  const { document, palettes } = designer.state;
  const known = palettes[document]?.components.find(({ name }) => name === component);
  return designer.drawing?.kind === Drawing_Kind.STATES && !!known && isTrigger(known);
}

export function selectedTransition({ drawing, state }: Designer): Transition | undefined {
  return drawing && transitionOf(drawing, state.selection[0] ?? "");
}

/** The arrow or the label there [px of the window]. */
export function transitionAt({ drawing }: Designer, x: number, y: number): Transition | undefined {
  const found = window.document.elementFromPoint(x, y);
  const label = found?.closest<HTMLElement>("[data-transition]")?.dataset.transition;
  const id = label ?? found?.closest(".react-flow__edge")?.getAttribute("data-id");
  return id && drawing ? transitionOf(drawing, id) : undefined;
}

/** Where it has a trigger, both have to be true: nothing is lost, and the details change it to `or`. */
export async function dropTrigger(
  designer: Designer,
  component: string,
  transition: Transition | undefined,
): Promise<boolean> {
  if (!transition) {
    designer.tell(`${component} says when a transition is made: drop it on an arrow, or select one before.`, "hold");
    return false;
  }
  const { from, index, to } = transition;
  const how = isNoTrigger(transition.trigger) ? "choose" : "and";
  if (!(await changeTrigger(designer, { from, index, part: [] }, how, component))) return false;
  designer.select([transitionId(transition)]);
  designer.show({ details: true });
  designer.say(`${how === "and" ? "And when" : "When"} ${component}, from ${from} to ${to}`);
  return true;
}
