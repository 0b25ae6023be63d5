// Gives the console's components the simulator's session of this page.
import type { ReactNode } from "react";
import { SessionContext } from "../../console/session/session.ts";
import { useLivePage } from "./use_live_part.ts";

export function InSession({ children }: { children: ReactNode }) {
  return <SessionContext value={useLivePage().session}>{children}</SessionContext>;
}
