// The red dot on what has a breakpoint.
import { usePart } from "../session/use.ts";

/** Whether there is one on something of a page of the document that is shown; `id` as in `State.selection`. */
export function useBreaks(page: string, id: string): boolean {
  return usePart(
    ({ marks, document }) =>
      marks[document]?.some((mark) => mark.breakpoint && mark.page === page && mark.drawn === id && !mark.isLost) ??
      false,
  );
}

export function BreakDot({ page, id }: { page: string; id: string }) {
  return useBreaks(page, id) ? <span className="break-dot" title="A breakpoint stops the run here" /> : null;
}
