// The menu of what is under the pointer: the right button, or the menu key on what is selected.
import type { ReactFlowProps } from "@xyflow/react";
import { type MouseEvent, useEffect, useRef } from "react";
import { Menu, MenuItem, Popover } from "react-aria-components";
import { create } from "zustand";
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Icon } from "../../ui/controls/icons.tsx";
import { allActions } from "../actions/all_actions.ts";
import type { Action } from "../session/action.ts";
import type { Designer } from "../session/designer.ts";
import { useDesigner } from "../session/use.ts";

interface OpenedMenu {
  readonly id: string;
  /** [px] of the window. */
  readonly x: number;
  readonly y: number;
}

const useOpened = create<{ opened: OpenedMenu | null }>(() => ({ opened: null }));

/** What everything has in its menu, where it can be done. */
const kCommon = ["enter", "rename", "uses", "component-uses", "connect", "replace", "copy", "duplicate", "remove"];

/** Selects it and opens its menu. */
export function openMenu(designer: Designer, id: string, event: { clientX: number; clientY: number }): void {
  if (!designer.state.selection.includes(id)) designer.select([id]);
  useOpened.setState({ opened: { id, x: event.clientX, y: event.clientY } });
}

/** Handlers of React Flow: the right button. */
export function menus(designer: Designer): Pick<ReactFlowProps, "onNodeContextMenu" | "onEdgeContextMenu"> {
  const show = (event: MouseEvent, { id }: { id: string }) => {
    event.preventDefault();
    openMenu(designer, id, event);
  };
  return { onNodeContextMenu: show, onEdgeContextMenu: show };
}

function entriesOf(designer: Designer, id: string): Action[] {
  const common = allActions(designer).filter((one) => kCommon.includes(one.id) && one.blocked === undefined);
  // What only waits for a run is there before one, and says so.
  return [...(designer.extensions.menu?.(designer, id) ?? []), ...common];
}

export function ContextMenu() {
  const designer = useDesigner();
  const opened = useOpened((state) => state.opened);
  const anchor = useRef<HTMLSpanElement>(null);
  const close = () => useOpened.setState({ opened: null });
  useMenuKey(designer);
  if (!opened) return null;
  const entries = entriesOf(designer, opened.id);
  return (
    <>
      <span ref={anchor} className="menu-anchor" style={{ left: opened.x, top: opened.y }} />
      <Popover
        className="popover"
        triggerRef={anchor}
        isOpen
        aria-label={`Menu of ${opened.id}`}
        placement="bottom start"
        onOpenChange={(open) => !open && close()}
      >
        <Menu className="menu" aria-label={`Menu of ${opened.id}`} autoFocus="first" onClose={close}>
          {entries.map((entry) => (
            <MenuItem
              key={entry.id}
              id={entry.id}
              className="menu-item"
              textValue={entry.label}
              isDisabled={entry.blocked !== undefined}
              onAction={entry.run}
            >
              {entry.icon && <Icon name={entry.icon} />}
              <span className="texts">
                {entry.label}
                {entry.blocked !== undefined && <span className="small muted">{entry.blocked}</span>}
              </span>
              {entry.shortcut && (
                <span className="tail">
                  <kbd>{shownShortcut(entry.shortcut)}</kbd>
                </span>
              )}
            </MenuItem>
          ))}
        </Menu>
      </Popover>
    </>
  );
}

/** The menu key, and Shift F10, on what is selected. */
function useMenuKey(designer: Designer): void {
  useEffect(() => {
    const open = (event: KeyboardEvent) => {
      if (event.key !== "ContextMenu" && !(event.key === "F10" && event.shiftKey)) return;
      const id = designer.state.selection[0];
      const element = id === undefined ? null : document.querySelector(`[data-id="${CSS.escape(id)}"]`);
      if (id === undefined || (event.target instanceof Element && event.target.closest("input, textarea"))) return;
      event.preventDefault();
      const box = (element ?? document.querySelector(".canvas"))?.getBoundingClientRect();
      openMenu(designer, id, { clientX: (box?.x ?? 0) + 40, clientY: (box?.y ?? 0) + 30 });
    };
    window.addEventListener("keydown", open);
    return () => window.removeEventListener("keydown", open);
  }, [designer]);
}
