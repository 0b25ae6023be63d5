// The session that all panels show, and how they subscribe to it.
import { createContext, useCallback, useContext, useMemo, useSyncExternalStore } from "react";
import type { Connection } from "../../core/connection.ts";
import type { Model, Parts } from "../../core/model.ts";
import { fittedLayout, type Layout } from "./layout.ts";
import type { Ui, UiParts } from "./ui.ts";

export interface Session {
  /** What the server tells, and what is selected. */
  readonly model: Model;
  readonly connection: Connection;
  /** What only this browser knows: layout, tool, theme, open dialogs. */
  readonly ui: Ui;
}

export const SessionContext = createContext<Session | null>(null);

export function useSession(): Session {
  const session = useContext(SessionContext);
  if (!session) throw new Error("a panel stands outside of the session");
  return session;
}

/** A part of the model; the component is drawn anew when it changes, and for nothing else. */
export function usePart<Name extends keyof Parts>(name: Name): Parts[Name] {
  const { model } = useSession();
  const subscribe = useCallback((listener: () => void) => model.subscribe(name, listener), [model, name]);
  return useSyncExternalStore(subscribe, () => model.get(name));
}

/** A part of what only this browser knows. */
export function useUi<Name extends keyof UiParts>(name: Name): UiParts[Name] {
  const { ui } = useSession();
  const subscribe = useCallback((listener: () => void) => ui.subscribe(name, listener), [ui, name]);
  return useSyncExternalStore(subscribe, () => ui.get(name));
}

/** The panels as the window has room for them. */
export function useLayout(): Layout {
  const layout = useUi("layout");
  const room = useUi("room");
  return useMemo(() => fittedLayout(layout, room), [layout, room]);
}

/** Whether this browser's person is the operator and can be heard. */
export function useIsOperator(): boolean {
  usePart("clients");
  usePart("welcome");
  const isOpen = usePart("link").state === "open";
  return useSession().model.isOperator() && isOpen;
}
