import { useEffect } from "react";
import { isTakenByFocus, matches } from "../../ui/commands/keys.ts";
import type { Designer } from "../session/designer.ts";
import { allActions } from "./all_actions.ts";

/** Keys of the whole page. */
export function useShortcuts(designer: Designer): void {
  useEffect(() => {
    const pressed = (event: KeyboardEvent) => {
      if (event.defaultPrevented || designer.state.dialog !== "") return;
      const action = allActions(designer).find((one) =>
        [one.shortcut, ...(one.also ?? [])].some((key) => key !== undefined && matches(key, event)),
      );
      if (!action) return;
      const target = event.target instanceof Element ? event.target : null;
      // A node of the canvas that has the focus leaves keys to the page.
      const isNode = target?.classList.contains("react-flow__node") ?? false;
      if (!action.everywhere && !isNode && isTakenByFocus(target, event)) return;
      if (!action.everywhere && target?.closest(".cm-editor")) return;
      event.preventDefault();
      if (!action.blocked) action.run();
      else designer.say(action.blocked);
    };
    // Fields keep what is typed in them to themselves, also keys that mean the same everywhere, such as Ctrl S.
    const pressedInField = (event: KeyboardEvent) => {
      const { target } = event;
      if (!(target instanceof HTMLInputElement || target instanceof HTMLTextAreaElement)) return;
      if (target.closest(".cm-editor") || designer.state.dialog !== "") return;
      if (!allActions(designer).some((one) => one.everywhere && one.shortcut && matches(one.shortcut, event))) return;
      target.blur(); // sends what has been typed
      pressed(event);
    };
    window.addEventListener("keydown", pressed);
    window.addEventListener("keydown", pressedInField, { capture: true });
    return () => {
      window.removeEventListener("keydown", pressed);
      window.removeEventListener("keydown", pressedInField, { capture: true });
    };
  }, [designer]);
}
