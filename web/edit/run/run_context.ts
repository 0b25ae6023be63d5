// What all parts of a run share: the page of the designer, and its connection to the simulator.
import type { Connection } from "../../core/connection.ts";
import type { Model } from "../../core/model.ts";
import type { Designer } from "../../designer/session/designer.ts";
import { besideSimulator, kWide } from "../../designer/session/state.ts";
import { fit } from "../../designer/sight/view.ts";
import type { LiveStore } from "./live_state.ts";

export interface RunContext {
  readonly designer: Designer;
  /** What the simulator tells. */
  readonly model: Model;
  readonly connection: Connection;
  readonly store: LiveStore;
}

/** Opens the pane; where the window is narrow the drawing gets the palette's room. */
export function showPane(designer: Designer): void {
  const { shown } = designer.state;
  if (shown.live) return;
  designer.show(besideSimulator(shown, window.innerWidth < kWide));
  // Once the canvas has its new width.
  setTimeout(() => fit(), 200);
}

/** To the first error: where it is drawn, and in the list. */
export function showProblem(designer: Designer): void {
  const problem = designer.document?.problems.find(({ diagnostic }) => !diagnostic?.isWarning);
  designer.show({ problems: true });
  if (!problem) return;
  designer.tell(`It does not compile: ${problem.diagnostic?.message ?? ""}`, "hold");
  if (problem.page !== "" || problem.node !== "") {
    designer.navigation.goTo(problem.diagnostic?.document || designer.state.document, problem.page, problem.node);
  }
}
