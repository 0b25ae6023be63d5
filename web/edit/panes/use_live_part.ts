// How components get at running and subscribe to it.
import { useCallback, useSyncExternalStore } from "react";
import { useStore } from "zustand";
import { usePart as useSessionPart } from "../../console/session/session.ts";
import { useDesigner, useDocument, usePart } from "../../designer/session/use.ts";
import { type Live, liveOf } from "../run/live.ts";
import type { LiveState } from "../run/live_state.ts";
import { joined } from "../run/places.ts";
import type { Situation } from "../run/run_button.ts";
import { situationOf } from "../run/situation.ts";
import { activeState } from "./menu.ts";

export function useLivePage(): Live {
  return liveOf(useDesigner());
}

export function useLiveState<T>(pick: (state: LiveState) => T): T {
  return useStore(useLivePage().store, pick);
}

/** Drawn anew when how things stand changes. Only inside of the session's context. */
export function useSituation(): Situation {
  const live = useLivePage();
  useDocument();
  usePart((state) => state.page);
  useLiveState((state) => state);
  useSessionPart("status");
  useSessionPart("documents");
  useSessionPart("link");
  useSessionPart("moment");
  useSessionPart("timeLine");
  return situationOf(live);
}

/** The path of a port on the page that is shown; empty: it does not run. */
export function usePath(live: string): string {
  const place = useLiveState((state) => (state.places.includes(state.place) ? state.place : undefined));
  if (place === undefined || live === "") return "";
  return joined(place, live);
}

/** The state in which the selected robot is on the page that is shown; drawn anew when that changes, and for nothing else. */
export function useActiveState(): string {
  const live = useLivePage();
  const subscribe = useCallback((listener: () => void) => live.model.subscribe("details", listener), [live]);
  return useSyncExternalStore(subscribe, () => activeState(live));
}
