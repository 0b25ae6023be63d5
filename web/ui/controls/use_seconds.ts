import { useEffect, useState } from "react";

/** Whole seconds until a time [ms since the epoch], as it passes; 0 where there is none. */
export function useSecondsUntil(time: number): number {
  const [now, setNow] = useState(() => Date.now());
  useEffect(() => {
    if (time === 0) return;
    const timer = setInterval(() => setNow(Date.now()), 250);
    return () => clearInterval(timer);
  }, [time]);
  return time === 0 ? 0 : Math.max(0, Math.ceil((time - now) / 1000));
}
