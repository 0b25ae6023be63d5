// The session that all panels show, and how they subscribe to it.
import { createContext, useCallback, useContext, useMemo, useRef, useSyncExternalStore } from "react";
import type { Connection } from "../../core/connection.ts";
import type { Model, Parts } from "../../core/model.ts";
import type { Pace } from "../../core/pace.ts";
import { Status_Mode } from "../../core/protocol.ts";
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
  /** When panels hear of what the server tells; without it at once. */
  readonly pace?: Pace;
}

export const SessionContext = createContext<Session | null>(null);

export function useSession(): Session {
  const session = useContext(SessionContext);
  if (!session) throw new Error("a panel stands outside of the session");
  return session;
}

/** A part of the model; the component is drawn anew when it changes, and for nothing else. */
export function usePart<Name extends keyof Parts>(name: Name): Parts[Name] {
  const { model, pace } = useSession();
  const subscribe = useCallback((listener: () => void) => hear(model, name, listener, pace), [model, name, pace]);
  return useSyncExternalStore(subscribe, () => model.get(name));
}

/** What this browser itself changes: fields show at once what is typed into them. */
const kOwn: ReadonlySet<keyof Parts> = new Set(["selection", "map"]);
/** Told some times a second, whatever comes with the frames between. */
const kSlow: ReadonlySet<keyof Parts> = new Set(["time", "details", "standings"]);

/** As Model.subscribe, at a pace. */
export function hear(model: Model, name: keyof Parts, listener: () => void, pace: Pace | undefined): () => void {
  if (!pace || kOwn.has(name)) return model.subscribe(name, listener);
  // While a moment is being computed the one before is shown: that is told with the new one, unless it takes long.
  const canWait = () => kSlow.has(name) || (name === "moment" && model.get("moment")?.isComing === true);
  const end = model.subscribe(name, () => (canWait() ? pace.withNext(listener) : pace.soon(listener)));
  return () => {
    end();
    pace.forget(listener);
  };
}

/**
 * What `read` finds in some parts of the model; the component is drawn anew when it finds something else. For who shows
 * little of a part that changes often: `status` does with each moment that is shown.
 */
export function useReading<Value>(
  names: readonly (keyof Parts)[],
  read: (model: Model) => Value,
  isSame: (a: Value, b: Value) => boolean = Object.is,
): Value {
  const { model, pace } = useSession();
  const key = names.join();
  const subscribe = useCallback(
    (listener: () => void) => {
      const ends = (key.split(",") as (keyof Parts)[]).map((name) => hear(model, name, listener, pace));
      return () => {
        for (const end of ends) end();
      };
    },
    [model, pace, key],
  );
  return useSyncExternalStore(
    subscribe,
    useSteady(() => read(model), isSame),
  );
}

/** The same as before where what it finds is alike. */
export function useSteady<Value>(find: () => Value, isSame: (a: Value, b: Value) => boolean): () => Value {
  const last = useRef<{ value: Value } | null>(null);
  return () => {
    const value = find();
    if (!last.current || !isSame(last.current.value, value)) last.current = { value };
    return last.current.value;
  };
}

/** Whether two plain values, without big numbers, read alike. */
export function isAlike(a: unknown, b: unknown): boolean {
  return a === b || JSON.stringify(a) === JSON.stringify(b);
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
  return useReading(["moment", "timeLine"], (model) => model.isElsewhen());
}

/** How the mission stands. */
export function useMode(): Status_Mode {
  return useReading(["status"], (model) => model.get("status")?.mode ?? Status_Mode.NO_MISSION);
}

/** Whether a recording was opened. */
export function useIsRecording(): boolean {
  return useReading(["timeLine"], (model) => model.isRecording());
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
