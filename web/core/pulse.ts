// Whether the other side of a connection is alive: both send beats, and ours are answered. Seconds in which this page
// itself slept (a hidden tab, a closed laptop) are nobody's silence.

const kEvery = 250; // ms between beats of a page that is shown
const kMost = 400; // ms that one look at the clock counts at most: the rest the page has slept
/** So long without a sign, and the other side is silent [ms]. */
export const kSilence = 1000;

export interface PulseOptions {
  /** Sends a beat of this number. */
  readonly send: (number: bigint) => void;
  /** When the last sign came, as Date.now(); 0: there are signs. Called when it becomes another. */
  readonly changed: (silentSince: number) => void;
  /** Replaced in tests. */
  readonly now?: () => number;
}

export class Pulse {
  private timer: ReturnType<typeof setInterval> | undefined;
  private looked = 0;
  private number = 0n;
  private heardAt = 0;
  /** When the beat was sent that has not been answered yet; 0: none. */
  private askedAt = 0;
  /** How long each has lasted, of the time in which the page was awake [ms]. */
  private quiet = 0;
  private unanswered = 0;
  private told = 0;
  private readonly now: () => number;

  constructor(private readonly options: PulseOptions) {
    this.now = options.now ?? Date.now;
  }

  start(): void {
    this.stop();
    this.looked = this.heardAt = this.now();
    this.quiet = this.unanswered = this.askedAt = 0;
    this.timer = setInterval(() => this.look(), kEvery);
    this.beat();
  }

  /** When the last sign came, as Date.now(); 0: none yet. */
  get lastSign(): number {
    return this.heardAt;
  }

  stop(): void {
    clearInterval(this.timer);
    this.timer = undefined;
    this.told = 0;
  }

  /** Something came; `answered`: the number of the beat that it answers. */
  heard(answered?: bigint): void {
    if (this.timer === undefined) return;
    this.heardAt = this.now();
    this.quiet = 0;
    if (answered !== undefined && answered >= this.number) this.askedAt = this.unanswered = 0;
    this.tell();
  }

  private look(): void {
    const now = this.now();
    const passed = Math.min(kMost, Math.max(0, now - this.looked));
    this.looked = now;
    this.quiet += passed;
    if (this.askedAt !== 0) this.unanswered += passed;
    this.beat();
    this.tell();
  }

  /** The same again where it was not answered: the other side may have lost it. */
  private beat(): void {
    if (this.askedAt === 0) {
      ++this.number;
      this.askedAt = this.now();
    }
    this.options.send(this.number);
  }

  private tell(): void {
    const signs = [
      ...(this.quiet >= kSilence ? [this.heardAt] : []),
      ...(this.unanswered >= kSilence ? [this.askedAt] : []),
    ];
    const since = signs.length > 0 ? Math.min(...signs) : 0;
    if (since === this.told) return;
    this.told = since;
    this.options.changed(since);
  }
}
