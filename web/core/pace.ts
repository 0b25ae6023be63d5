// Of many messages that come between two pictures of the page only what they came to is shown: who shows something is
// told of all changes together, before the page is painted next.

export type Listener = () => void;

const kPatience = 50; // ms

export class Pace {
  private readonly waiting = new Set<Listener>();
  private readonly patient = new Set<Listener>();
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param beforePainting  calls back before the page is painted next */
  constructor(private readonly beforePainting: (done: () => void) => void) {}

  /** Tells a listener soon, once for all that has changed until then. */
  soon(listener: Listener): void {
    if (this.waiting.size === 0) this.beforePainting(() => this.tell());
    this.waiting.add(listener);
  }

  /** Tells it together with what comes next; where nothing does, after a moment. */
  withNext(listener: Listener): void {
    this.patient.add(listener);
    this.timer ??= setTimeout(() => {
      this.timer = undefined;
      for (const one of this.patient) this.soon(one);
    }, kPatience);
  }

  /** It need not be told any more. */
  forget(listener: Listener): void {
    this.waiting.delete(listener);
    this.patient.delete(listener);
  }

  /** Tells everybody now. */
  tell(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const told = new Set([...this.waiting, ...this.patient]);
    this.waiting.clear();
    this.patient.clear();
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
