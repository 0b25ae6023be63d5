// What has a place on the page without belonging to drawing: the page that puts the designer together says what.
import type { ComponentType, ReactNode } from "react";
import type { Action } from "./action.ts";
import type { Designer } from "./designer.ts";
import type { Drawing, Node, Port } from "./protocol.ts";

/** What stands in place of the field that changes the text; nothing: that field. */
export type FieldOf = (port: Port, what: "value" | "weight") => ReactNode;

export interface InputsProps {
  node: Node;
  /** `chooser`: of what is changed; null where nothing runs. */
  children: (fieldOf: FieldOf, chooser: ReactNode) => ReactNode;
}

/** What is left out has no place. */
export interface Extensions {
  /** In the middle of the top bar: Run, Pause and the like. */
  readonly run?: ComponentType;
  /** The pane right of the canvas, shown while `shown.live`. */
  readonly live?: ComponentType;
  /** Below the drawing, shown while `shown.tests`. */
  readonly tests?: { readonly header: ComponentType; readonly panel: ComponentType };
  /** Below all panes. */
  readonly bottom?: ComponentType;
  /** Over the drawing, above what else is told there. */
  readonly over?: readonly ComponentType[];
  /** At the end of the details of what is selected; `id` as in `State.selection`. */
  readonly details?: ComponentType<{ drawing: Drawing; id: string }>;
  /** Gives the fields of a node's inputs while it runs. */
  readonly inputs?: ComponentType<InputsProps>;
  /** Added to the menus of a node, a wire or a transition. */
  readonly menu?: (designer: Designer, id: string) => readonly Action[];
  /** Added to all actions, with their shortcuts. */
  readonly actions?: (designer: Designer) => readonly Action[];
}
