import { useCallback, useSyncExternalStore } from "react";
import { type LiveValue, liveKey, liveValues } from "./values.ts";

/** The value of what is drawn; drawn anew when it changes and for nothing else. `live` empty: it has none. */
export function useLive(page: string, live: string): LiveValue | undefined {
  const key = live === "" ? "" : liveKey(page, live);
  const subscribe = useCallback(
    (listener: () => void) => (key === "" ? () => {} : liveValues.subscribe(key, listener)),
    [key],
  );
  return useSyncExternalStore(subscribe, () => (key === "" ? undefined : liveValues.get(key)));
}
