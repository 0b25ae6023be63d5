// What is dragged out of the palette onto the drawing: a component, or a trigger, which a transition takes.
import type { DragEvent } from "react";
import { dropAt, kDragged } from "../palette/touch_drag.ts";
import type { Designer } from "../session/designer.ts";
import { canvasStore } from "../sight/canvas_store.ts";
import { isTriggerHere, transitionAt } from "../states/drop_trigger.ts";
import { transitionId } from "../states/flow.ts";

/** Handlers of the element that the drawing lies in. */
export function dropping(designer: Designer, isReadOnly: boolean) {
  return {
    onDragOver: (event: DragEvent) => {
      if (!event.dataTransfer.types.includes(kDragged) || isReadOnly) return;
      event.preventDefault();
      event.dataTransfer.dropEffect = "copy";
      aim(designer, event.clientX, event.clientY);
    },
    onDrop: (event: DragEvent) => {
      const component = event.dataTransfer.getData(kDragged);
      if (!component || isReadOnly) return;
      event.preventDefault();
      canvasStore.setState({ dragged: "", aimedAt: "" });
      dropAt(designer, component, event.clientX, event.clientY);
    },
  };
}

/** Shows which transition takes the trigger that is dragged over it. */
function aim(designer: Designer, x: number, y: number): void {
  const { dragged, aimedAt } = canvasStore.getState();
  const over = isTriggerHere(designer, dragged) ? transitionAt(designer, x, y) : undefined;
  const id = over ? transitionId(over) : "";
  if (id !== aimedAt) canvasStore.setState({ aimedAt: id });
}
