// Robots between two frames. A simulation at its own speed makes ten cycles a second: drawn as they come, robots jump.
// They are shown on their way from where they were last shown to the newest frame's place instead, which they reach when
// the next frame is due: one interval late, and no more.

const kSmoothEnough = 40; // ms: frames that come faster are shown as they are
const kLongest = 1500; // ms: after such a gap nobody expects a smooth way
const kLeastReach = 2; // m
const kFastest = 40; // m/s: who went farther than that has jumped

export class Glide {
  /** What draws can take the additional drawings. */
  isWanted = false;
  private came = Number.NEGATIVE_INFINITY;
  private interval = 0; // ms; 0: no gliding

  /**
   * A frame has come.
   *
   * @param now       [ms]
   * @param advanced  simulated time since the frame before [s]; 0 where the run stands or is stepped
   * @return  how far a robot may have gone to be shown on its way [m]; 0: none is
   */
  take(now: number, advanced: number): number {
    const gap = now - this.came;
    this.came = now;
    const isSmooth = gap < kSmoothEnough || gap > kLongest;
    if (!this.isWanted || !(advanced > 0) || isSmooth) {
      this.interval = 0;
      return 0;
    }
    // Frames don't come to the millisecond.
    this.interval = this.interval > 0 ? this.interval + (gap - this.interval) * 0.3 : gap;
    return Math.max(kLeastReach, advanced * kFastest);
  }

  /** How much of the way to the newest frame's places is behind a robot, 0..1. */
  share(now: number): number {
    if (this.interval <= 0) return 1;
    return Math.min(1, Math.max(0, (now - this.came) / this.interval));
  }
}

/** Between two headings of 65536 to the full turn, the shorter way round. */
export function turnBetween(from: number, to: number, share: number): number {
  const turn = ((to - from + 0x8000) & 0xffff) - 0x8000;
  return (Math.round(from + turn * share) + 0x10000) & 0xffff;
}
