import { useEffect } from "react";
import { isStale } from "../../ui/controls/silence.tsx";
import { emergencyStop } from "../session/orders.ts";
import { isAlike, usePart, useReading, useSession, useUi } from "../session/session.ts";
import { isTaken, type StopState, stopState } from "./stop_state.ts";

export function useStopState(): StopState {
  const isSilent = isStale(usePart("link"));
  const isSent = useUi("stopSent");
  return useReading(["status"], (model) => stopState(model.get("status"), isSent, isSilent), isAlike);
}

/** Forgets that a stop was sent once the server has taken it, and sends it again where the connection was lost before that. */
export function useFollowStop(): void {
  const session = useSession();
  const isThere = isTaken(useStopState());
  const isOpen = usePart("link").state === "open";
  useEffect(() => {
    if (isThere) session.ui.set("stopSent", false);
  }, [isThere, session]);
  useEffect(() => {
    if (isOpen && session.ui.get("stopSent")) void emergencyStop(session);
  }, [isOpen, session]);
}
