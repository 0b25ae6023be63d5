import type { Designer } from "./designer.ts";

/** What the next drawing is to bring: it may come a moment after the answer. */
export function onceDrawn<T>(designer: Designer, look: () => T | undefined): Promise<T | undefined> {
  return new Promise((resolve) => {
    const found = look();
    if (found !== undefined) return resolve(found);
    const done = () => {
      clearTimeout(timer);
      stop();
      resolve(look());
    };
    const timer = setTimeout(done, 1500);
    const stop = designer.store.subscribe(() => look() !== undefined && done());
  });
}
