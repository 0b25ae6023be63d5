import { useEffect } from "react";
import { isTakenByFocus, matches } from "../../console/actions/keys.ts";
import type { Designer } from "../designer.ts";
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
    window.addEventListener("keydown", pressed);
    return () => window.removeEventListener("keydown", pressed);
  }, [designer]);
}
