// A component dragged out of the palette by a finger or a pen: the browser's own dragging knows mice only. Up and down
// scrolls, sideways drags.
import { onPitch } from "../arrange/elk.ts";
import type { Designer } from "../session/designer.ts";
import { Drawing_Kind } from "../session/protocol.ts";
import { camera } from "../sight/view.ts";
import { dropTrigger, isTriggerHere, transitionAt } from "../states/drop_trigger.ts";
import { placeState } from "./place.ts";

/** What the browser drags out of the palette. */
export const kDragged = "application/x-mlab-component";
const kSlop = 10; // [px]

interface TouchStart {
  readonly pointerType: string;
  readonly pointerId: number;
  readonly clientX: number;
  readonly clientY: number;
}

/** Puts it where it was let go, where that is on the canvas [px of the window]. */
export function dropAt(designer: Designer, component: string, x: number, y: number): void {
  const { drawing } = designer;
  const at = camera()?.screenToFlowPosition({ x, y });
  if (!drawing || drawing.isReadOnly || !at) return;
  const where = { x: onPitch(at.x - 80), y: onPitch(at.y - 20) };
  if (isTriggerHere(designer, component)) void dropTrigger(designer, component, transitionAt(designer, x, y));
  else if (drawing.kind === Drawing_Kind.STATES) void placeState(designer, component, "", where);
  else {
    const page = drawing.page?.path ?? "";
    void designer.edit(`place ${component}`, { case: "place", value: { page, component, ...where } });
  }
}

/** From when the finger came down; ends with it. */
export function dragByTouch(designer: Designer, component: string, title: string, began: TouchStart): void {
  if (began.pointerType === "mouse") return;
  let ghost: HTMLElement | null = null;
  const move = (event: PointerEvent) => {
    if (event.pointerId !== began.pointerId) return;
    if (!ghost) {
      if (Math.hypot(event.clientX - began.clientX, event.clientY - began.clientY) < kSlop) return;
      ghost = document.createElement("div");
      ghost.className = "palette-ghost";
      ghost.textContent = title;
      document.body.append(ghost);
    }
    ghost.style.translate = `${event.clientX}px ${event.clientY}px`;
  };
  const end = (event: PointerEvent) => {
    if (event.pointerId !== began.pointerId) return;
    for (const [name, listener] of listeners) window.removeEventListener(name, listener);
    const wasDragged = ghost !== null;
    ghost?.remove();
    if (!wasDragged || event.type !== "pointerup") return; // cancelled: it scrolled
    const over = document.elementFromPoint(event.clientX, event.clientY);
    if (over?.closest(".centre")) dropAt(designer, component, event.clientX, event.clientY);
  };
  const listeners = [
    ["pointermove", move],
    ["pointerup", end],
    ["pointercancel", end],
  ] as const;
  for (const [name, listener] of listeners) window.addEventListener(name, listener);
}
