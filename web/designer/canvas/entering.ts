// Going inside of what stands on the drawing.
import type { ReactFlowProps } from "@xyflow/react";
import type { Designer } from "../session/designer.ts";
import { innerOf } from "../session/inside.ts";
import type { Drawing } from "../session/protocol.ts";

/** Handlers of React Flow: a double click goes inside of what has an inside. */
export function entering(designer: Designer, drawing: Drawing): Pick<ReactFlowProps, "onNodeDoubleClick"> {
  return {
    onNodeDoubleClick: (_, { id }) => {
      // The browser has taken it for a word: what it found to select is in a pane beside the canvas.
      window.getSelection()?.removeAllRanges();
      const inner = innerOf(drawing, id);
      if (inner) designer.navigation.enter(inner);
    },
  };
}
