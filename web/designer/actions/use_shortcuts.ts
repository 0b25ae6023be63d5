import { useEffect } from "react";
import { isShortcut, isTakenByFocus } from "../../ui/commands/keys.ts";
import type { Designer } from "../session/designer.ts";
import { allActions } from "./all_actions.ts";

/** Keys of the whole page. */
export function useShortcuts(designer: Designer): void {
  useEffect(() => {
    const pressed = (event: KeyboardEvent) => press(designer, event);
    const pressedInField = (event: KeyboardEvent) => pressInField(designer, event);
    window.addEventListener("keydown", pressed);
    window.addEventListener("keydown", pressedInField, { capture: true });
    return () => {
      window.removeEventListener("keydown", pressed);
      window.removeEventListener("keydown", pressedInField, { capture: true });
    };
  }, [designer]);
}

function press(designer: Designer, event: KeyboardEvent): void {
  if (event.defaultPrevented || designer.state.dialog !== "") return;
  const action = allActions(designer).find((one) =>
    [one.shortcut, ...(one.also ?? [])].some((key) => key !== undefined && isShortcut(key, event)),
  );
  if (!action || (!action.everywhere && isOfFocus(event))) return;
  event.preventDefault();
  if (!action.blocked) action.run();
  else designer.say(action.blocked);
}

/** The key belongs to what has the focus. A node of the canvas leaves keys to the page. */
function isOfFocus(event: KeyboardEvent): boolean {
  const target = event.target instanceof Element ? event.target : null;
  if (target?.closest(".cm-editor")) return true;
  const isNode = target?.classList.contains("react-flow__node") ?? false;
  return !isNode && isTakenByFocus(target, event);
}

/** Fields keep what is typed in them to themselves, also keys that mean the same everywhere, such as Ctrl S. */
function pressInField(designer: Designer, event: KeyboardEvent): void {
  const { target } = event;
  if (!(target instanceof HTMLInputElement || target instanceof HTMLTextAreaElement)) return;
  if (target.closest(".cm-editor") || designer.state.dialog !== "") return;
  if (!allActions(designer).some((one) => one.everywhere && one.shortcut && isShortcut(one.shortcut, event))) return;
  target.blur(); // sends what has been typed
  press(designer, event);
}
