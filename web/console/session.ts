// The session that all panels show, and how they subscribe to it.
import { createContext, useCallback, useContext, useSyncExternalStore } from "react";
import type { Connection } from "../core/connection.ts";
import type { Model, Parts } from "../core/model.ts";

export interface Session {
  readonly model: Model;
  readonly connection: Connection;
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
