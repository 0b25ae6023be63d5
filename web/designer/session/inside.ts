import type { Drawing, Page } from "./protocol.ts";

/** Where a look inside leads: a state that only calls an assemblage leads to that. */
export function innerOf(drawing: Drawing, name: string): Page | undefined {
  const state = drawing.states.find((one) => one.name === name);
  return state?.calls ?? state?.inner ?? drawing.nodes.find((node) => node.name === name)?.inner;
}
