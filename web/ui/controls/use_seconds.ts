import { useEffect, useReducer } from "react";

/** Whole seconds until a time [ms since the epoch], as it passes; 0 where there is none. */
export function useSecondsUntil(time: number): number {
  const [, drawAgain] = useReducer((count: number) => count + 1, 0);
  useEffect(() => {
    if (time === 0) return;
    const timer = setInterval(drawAgain, 250);
    return () => clearInterval(timer);
  }, [time]);
  return time === 0 ? 0 : Math.max(0, Math.ceil((time - Date.now()) / 1000));
}
