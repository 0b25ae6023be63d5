// Where the keyboard's focus is on the drawing, and what it selects.
import { type FocusEvent, type RefObject, useEffect } from "react";
import type { Designer } from "../session/designer.ts";
import { isTabbed, offerFocus } from "../session/panes.ts";
import { useDesigner } from "../session/use.ts";
import { nodeElement } from "../sight/view.ts";

/** Who works with keys has the focus on what is selected, or on the drawing; else it would be lost with each dialog. */
export function useKeptFocus(section: RefObject<HTMLElement | null>): void {
  const designer = useDesigner();
  useEffect(() => {
    if (designer.state.dialog !== "") return;
    const { selection } = designer.state;
    const chosen = selection.length === 1 ? nodeElement(selection[0]!) : null;
    const focused = document.activeElement;
    const isOurs = focused === section.current || (focused?.matches(".canvas .react-flow__node") ?? false);
    if (chosen && isOurs && chosen !== focused) chosen.focus({ preventScroll: true });
    else offerFocus(chosen ?? section.current);
  });
}

/** What the Tab key reaches is selected: keys do something to it. `ids`: what can be selected. */
export function selectTabbed(designer: Designer, ids: ReadonlySet<string>, { target }: FocusEvent): void {
  const id = isTabbed() && target.matches(".react-flow__node") ? target.getAttribute("data-id") : null;
  if (id && ids.has(id) && !designer.state.selection.includes(id)) designer.select([id]);
}
