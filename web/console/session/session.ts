// The session that all panels show, and how they subscribe to it.
import { createContext, useCallback, useContext, useMemo, useSyncExternalStore } from "react";
import type { Connection } from "../../core/connection.ts";
import type { Model, Parts } from "../../core/model.ts";
import type { Store } from "../../core/store.ts";
import { elsewhen } from "./elsewhen.ts";
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
  return useStored<Parts, Name>(useSession().model, name);
}

/** A part of what only this browser knows. */
export function useUi<Name extends keyof UiParts>(name: Name): UiParts[Name] {
  return useStored<UiParts, Name>(useSession().ui, name);
}

/** A part of any store; the component is drawn anew when it changes, and for nothing else. */
export function useStored<Stored extends object, Name extends keyof Stored>(
  store: Store<Stored>,
  name: Name,
): Stored[Name] {
  const subscribe = useCallback((listener: () => void) => store.subscribe(name, listener), [store, name]);
  return useSyncExternalStore(subscribe, () => store.get(name));
}

/** What a session has one of, made when somebody first asks for it. */
export function perSession<Thing>(make: (session: Session) => Thing): (session: Session) => Thing {
  const known = new WeakMap<Session["model"], Thing>();
  return (session) => {
    const there = known.get(session.model);
    if (there !== undefined) return there;
    const made = make(session);
    known.set(session.model, made);
    return made;
  };
}

/** The panels as the window has room for them. */
export function useLayout(): Layout {
  const layout = useUi("layout");
  const room = useUi("room");
  return useMemo(() => fittedLayout(layout, room), [layout, room]);
}

/** Whether the server takes orders of this browser: its person is the operator, can be heard, and looks at what goes on. */
export function useMayOrder(): boolean {
  const isElsewhen = useIsElsewhen();
  return useIsOperator() && !isElsewhen;
}

/** Whether another moment than now is shown. */
export function useIsElsewhen(): boolean {
  const { model } = useSession();
  const subscribe = useCallback(
    (listener: () => void) => {
      const ends = [model.subscribe("moment", listener), model.subscribe("timeLine", listener)];
      return () => {
        for (const end of ends) end();
      };
    },
    [model],
  );
  return useSyncExternalStore(subscribe, () => model.isElsewhen());
}

/** Why nothing can be ordered, as a sentence; nothing: it can. `what`: as in `answer`. */
export function useWhyNoOrder(what: string): string | undefined {
  const mayOrder = useMayOrder();
  const { model } = useSession();
  if (mayOrder) return undefined;
  if (model.get("link").state !== "open") return "There is no connection.";
  return elsewhen(model) ?? `Only the operator can ${what}.`;
}

/** Whether this browser's person is the operator and can be heard. */
export function useIsOperator(): boolean {
  usePart("clients");
  usePart("welcome");
  const isOpen = usePart("link").state === "open";
  return useSession().model.isOperator() && isOpen;
}
