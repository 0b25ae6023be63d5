// What a question about a name is about: something drawn, or a place of the text.
import type { Designer } from "../session/designer.ts";
import { type Drawing, type Node, Node_Shape } from "../session/protocol.ts";

export interface NameAt {
  document: string;
  /** [bytes]; where nothing drawn is meant. */
  cursor?: number;
  isDrawn?: boolean;
  page?: string;
  node?: string;
  /** The component that the node is one of, instead of the node. */
  ofComponent?: boolean;
}

export function drawnAt({ state }: Designer, node: string, ofComponent = false): NameAt {
  return { document: state.document, isDrawn: true, page: state.page, node, ofComponent };
}

/** Nodes of a component that is not called as they are: it can be looked for by itself. */
export function componentOf(drawing: Drawing | undefined, id: string): string {
  const node = drawing?.nodes.find((one) => one.name === id);
  if (node) return isCall(node) ? node.component : "";
  const state = drawing?.states.find((one) => one.name === id);
  return /^(\w+)\(/.exec(state?.member ?? "")?.[1] ?? "";
}

function isCall({ shape, component }: Node): boolean {
  const isOther = shape === Node_Shape.DECLARATION || shape === Node_Shape.PARAMETER || shape === Node_Shape.ACTUATOR;
  return !isOther && /^[A-Z]\w*$/.test(component);
}
