// Of many messages that come between two pictures of the page only what they came to is shown: who shows something is
// told of all changes together, before the page is painted next.

export type Listener = () => void;

export class Pace {
  private readonly waiting = new Set<Listener>();

  /** @param beforePainting  calls back before the page is painted next */
  constructor(private readonly beforePainting: (done: () => void) => void) {}

  /** Tells a listener soon, once for all that has changed until then. */
  soon(listener: Listener): void {
    if (this.waiting.size === 0) this.beforePainting(() => this.tell());
    this.waiting.add(listener);
  }

  /** It need not be told any more. */
  forget(listener: Listener): void {
    this.waiting.delete(listener);
  }

  /** Tells everybody now. */
  tell(): void {
    const told = [...this.waiting];
    this.waiting.clear();
    for (const listener of told) listener();
  }
}

/** The page's own. One that is hidden is not painted, but still calls people. */
export function pageOf(document: Document): Pace {
  const pace = new Pace((done) => {
    if (document.visibilityState === "hidden") setTimeout(done, 0);
    else requestAnimationFrame(done);
  });
  document.addEventListener("visibilitychange", () => pace.tell());
  return pace;
}
