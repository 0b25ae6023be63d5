// How components get at the page's designer and subscribe to what it knows.
import { createContext, useContext } from "react";
import { useStore } from "zustand";
import type { Designer } from "./designer.ts";
import type { Document, Drawing } from "./protocol.ts";
import { drawingOf, type State } from "./state.ts";

export const DesignerContext = createContext<Designer | null>(null);

export function useDesigner(): Designer {
  const designer = useContext(DesignerContext);
  if (!designer) throw new Error("a part stands outside of the designer");
  return designer;
}

/** Drawn anew when what `pick` gives changes, and for nothing else. */
export function usePart<T>(pick: (state: State) => T): T {
  return useStore(useDesigner().store, pick);
}

export function useDocument(): Document | undefined {
  return usePart((state) => state.documents[state.document]);
}

export function useDrawing(): Drawing | undefined {
  return usePart(drawingOf);
}

/** Errors and warnings that are about a node, a state or a transition of the page that is shown. */
export function useTrouble(name: string): "has-error" | "has-warning" | "" {
  return usePart(({ documents, document, page }) => {
    const problems = documents[document]?.problems ?? [];
    const own = problems.filter((problem) => problem.node === name && problem.page === page);
    if (own.length === 0) return "";
    return own.some((problem) => !problem.diagnostic?.isWarning) ? "has-error" : "has-warning";
  });
}

/** Whether the page that is shown can't be changed. */
export function useIsReadOnly(): boolean {
  return usePart((state) => drawingOf(state)?.isReadOnly || state.documents[state.document]?.isReadOnly || false);
}
