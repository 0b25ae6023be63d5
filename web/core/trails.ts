// Where robots have been: bounded for each robot, thinned out where they stand or go straight.
import { toFloats } from "./packed.ts";
import type { Trails } from "./protocol.ts";
import type { RobotTable } from "./robots.ts";

/** x, y, time of one robot's past, oldest first, in a ring. */
export class Trail {
  private points: Float32Array;
  private first = 0;
  count = 0;

  /** @param points  that there are already, oldest first; they are taken over, and of too many the last ones */
  constructor(
    private readonly capacity: number,
    points?: Float32Array,
  ) {
    const whole = points ? points.length - (points.length % 3) : 0;
    this.count = Math.min(whole / 3, capacity);
    if (points && this.count > 0) this.points = points.subarray(whole - this.count * 3, whole);
    else this.points = new Float32Array(Math.min(32, capacity) * 3);
  }

  add(x: number, y: number, time: number): void {
    if (this.count === this.points.length / 3) {
      if (this.count < this.capacity) this.grow();
      else {
        this.first = (this.first + 1) % this.capacity;
        --this.count;
      }
    }
    const at = this.at(this.count) * 3;
    this.points[at] = x;
    this.points[at + 1] = y;
    this.points[at + 2] = time;
    ++this.count;
  }

  /** Forgets what came after a moment. @returns whether there was something */
  cut(time: number): boolean {
    const before = this.count;
    while (this.count > 0 && this.time(this.count - 1) > time) --this.count;
    return this.count < before;
  }

  x(index: number): number {
    return this.points[this.at(index) * 3]!;
  }
  y(index: number): number {
    return this.points[this.at(index) * 3 + 1]!;
  }
  time(index: number): number {
    return this.points[this.at(index) * 3 + 2]!;
  }

  private at(index: number): number {
    return (this.first + index) % (this.points.length / 3);
  }

  private grow(): void {
    const wider = new Float32Array(Math.min(this.capacity, (this.points.length / 3) * 2) * 3);
    wider.set(this.points); // a ring that has not been full is in order
    this.points = wider;
  }
}

/** The trails of all robots. At most `total` points together, so that ten thousand robots have short ones. */
export class TrailStore {
  private readonly trails = new Map<number, Trail>();
  private capacity: number;
  /** Changes where the past itself did: all must be drawn anew, not only what was added. */
  generation = 0;

  /** @param spacing  a point is kept where the robot has gone so far since the last [m] */
  constructor(
    private readonly total = 600_000,
    private readonly longest = 3000,
    public spacing = 0.25,
  ) {
    this.capacity = longest;
  }

  /** Tells how many robots there are, and the size of the area, which the spacing follows. */
  fitTo(robots: number, extent: number): void {
    this.capacity = Math.max(16, Math.min(this.longest, Math.floor(this.total / Math.max(1, robots))));
    this.spacing = Math.max(0.02, extent / 2000);
  }

  clear(): void {
    this.trails.clear();
    ++this.generation;
  }

  /** Forgets what came after a moment, to the accuracy of its times. */
  cut(time: number): void {
    const last = Math.fround(time);
    let isLess = false;
    for (const trail of this.trails.values()) isLess = trail.cut(last) || isLess;
    if (isLess) ++this.generation;
  }

  replace(message: Trails): void {
    this.clear();
    for (const { robot, points } of message.trails) this.trails.set(robot, new Trail(this.capacity, toFloats(points)));
  }

  extend(robots: RobotTable, time: number): void {
    for (let row = 0; row < robots.count; ++row) {
      const id = robots.id(row);
      const x = robots.x(row);
      const y = robots.y(row);
      let trail = this.trails.get(id);
      if (!trail) {
        trail = new Trail(this.capacity);
        this.trails.set(id, trail);
      } else if (trail.count > 0) {
        const last = trail.count - 1;
        const dx = x - trail.x(last);
        const dy = y - trail.y(last);
        if (dx * dx + dy * dy < this.spacing * this.spacing) continue;
      }
      trail.add(x, y, time);
    }
  }

  get(robot: number): Trail | undefined {
    return this.trails.get(robot);
  }

  [Symbol.iterator](): IterableIterator<[number, Trail]> {
    return this.trails.entries();
  }
}
