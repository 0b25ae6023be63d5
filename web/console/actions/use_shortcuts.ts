import { useEffect } from "react";
import { isForPageInList, isShortcut, isTakenByFocus } from "../../ui/commands/keys.ts";
import type { Session } from "../session/session.ts";
import { allActions } from "./shell_actions.ts";

/** Keys of the whole page. Listens early, so that the emergency stop comes before anything else. */
export function useShortcuts(session: Session): void {
  useEffect(() => {
    const early = (event: KeyboardEvent) => {
      // Before a list takes the letter to look for what begins with it.
      const isForPage = isForPageInList(event.target as Element | null, event);
      const action = allActions(session).find(
        (one) => (one.everywhere || isForPage) && one.shortcut !== undefined && isShortcut(one.shortcut, event),
      );
      if (!action || event.repeat) return;
      event.preventDefault();
      event.stopPropagation();
      if (!action.blocked) action.run();
    };
    const late = (event: KeyboardEvent) => {
      if (event.defaultPrevented || isTakenByFocus(event.target as Element | null, event)) return;
      const action = allActions(session).find((one) => one.shortcut !== undefined && isShortcut(one.shortcut, event));
      if (!action) return;
      event.preventDefault();
      if (!action.blocked) action.run();
    };
    window.addEventListener("keydown", early, true);
    window.addEventListener("keydown", late);
    return () => {
      window.removeEventListener("keydown", early, true);
      window.removeEventListener("keydown", late);
    };
  }, [session]);
}
