import type { Designer } from "./designer.ts";

/** [ms] A machine that has much else to do takes its time. */
const kPatience = 30_000;

/** What the next drawing of this page is to bring: it may come a moment after the answer. */
export function onceDrawn<T>(designer: Designer, look: () => T | undefined): Promise<T | undefined> {
  const { document, page } = designer.state;
  return new Promise((resolve) => {
    const found = look();
    if (found !== undefined) return resolve(found);
    const end = (brought: T | undefined) => {
      clearTimeout(timer);
      stop();
      resolve(brought);
    };
    const timer = setTimeout(() => end(undefined), kPatience);
    const stop = designer.store.subscribe((now) => {
      if (now.document !== document || now.page !== page) return end(undefined);
      const brought = look();
      if (brought !== undefined) end(brought);
    });
  });
}
