// Over everything that may be stale, while nothing comes from the server.
import { useEffect, useState } from "react";
import type { LinkState } from "../../core/server_link.ts";
import { Icon } from "./icons.tsx";

/** Whether what is shown may no longer be so. */
export function isStale({ state, silentSince }: LinkState): boolean {
  return silentSince !== 0 || state === "lost" || state === "refused";
}

/** Whole seconds since that moment (Date.now()), counted on. */
function useSecondsSince(since: number): number {
  const [now, setNow] = useState(Date.now());
  useEffect(() => {
    if (since === 0) return;
    setNow(Date.now());
    const timer = setInterval(() => setNow(Date.now()), 250);
    return () => clearInterval(timer);
  }, [since]);
  return Math.max(1, Math.floor((now - since) / 1000));
}

export function Silence({ link }: { link: LinkState }) {
  const seconds = useSecondsSince(link.silentSince);
  if (link.silentSince === 0) return null;
  return (
    <div className="silence" data-testid="silence">
      <p className="silence-sign">
        <Icon name="warning" />
        <span>
          <strong className="number">No answer for {seconds} s</strong>
          <span className="small">What you see is the last that came.</span>
        </span>
      </p>
      <span className="hidden-text" role="alert">
        The server does not answer.
      </span>
    </div>
  );
}
