// Where the map is looked at: north is up, a metre is `scale` pixels both ways.
import type { Box, Point } from "./geometry.ts";

export const kSmallestScale = 1e-4; // [px/m]
export const kLargestScale = 5000;
const kGap = 10; // [px] between what covers the screen and what is fitted
const kLeast = 0.5; // What covers so much of the screen that not even this share of the scale is left, is not avoided.

export class Camera {
  /** The world point in the middle of the screen [m]. */
  x = 0;
  y = 0;
  /** [CSS pixels per metre] */
  scale = 1;
  /** Of the screen [CSS pixels]. */
  width = 1;
  height = 1;
  /** Grows with each change. */
  version = 0;

  toScreenX(x: number): number {
    return (x - this.x) * this.scale + this.width / 2;
  }
  toScreenY(y: number): number {
    return this.height / 2 - (y - this.y) * this.scale;
  }

  toScreen(world: Point): Point {
    return { x: this.toScreenX(world.x), y: this.toScreenY(world.y) };
  }

  toWorld(screen: Point): Point {
    return {
      x: (screen.x - this.width / 2) / this.scale + this.x,
      y: (this.height / 2 - screen.y) / this.scale + this.y,
    };
  }

  /** What can be seen [m]. */
  visible(): Box {
    const x = this.width / 2 / this.scale;
    const y = this.height / 2 / this.scale;
    return { xMin: this.x - x, yMin: this.y - y, xMax: this.x + x, yMax: this.y + y };
  }

  /** The screen's size changed: the middle stays. */
  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    ++this.version;
  }

  lookAt(world: Point): void {
    this.x = world.x;
    this.y = world.y;
    ++this.version;
  }

  /** What is shown moves by so many pixels, as when it is dragged. */
  pan(dx: number, dy: number): void {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
    ++this.version;
  }

  /** The world point under `screen` stays under it. */
  zoomAbout(screen: Point, factor: number): void {
    const before = this.toWorld(screen);
    this.scale = Math.min(kLargestScale, Math.max(kSmallestScale, this.scale * factor));
    const after = this.toWorld(screen);
    this.x += before.x - after.x;
    this.y += before.y - after.y;
    ++this.version;
  }

  /**
   * All of the box, with so many pixels to spare on each side (less where the screen is small), beside what covers the
   * screen [CSS pixels, y down].
   */
  fit(box: Box, margin = 40, covered: readonly Box[] = []): void {
    const spare = Math.min(margin, this.width / 4, this.height / 4);
    const width = Math.max(1e-3, box.xMax - box.xMin);
    const height = Math.max(1e-3, box.yMax - box.yMin);
    const scaleIn = (room: Room) =>
      Math.min((this.width - room.left - room.right) / width, (this.height - room.top - room.bottom) / height);
    let room: Room = { left: spare, right: spare, top: spare, bottom: spare };
    for (const place of covered) {
      const beside = roomBeside(place, room, { width: this.width, height: this.height });
      if (scaleIn(beside) >= kLeast * scaleIn(room)) room = beside;
    }
    this.scale = Math.min(kLargestScale, Math.max(kSmallestScale, scaleIn(room)));
    this.lookAt({
      x: (box.xMin + box.xMax) / 2 + (room.right - room.left) / 2 / this.scale,
      y: (box.yMin + box.yMax) / 2 + (room.top - room.bottom) / 2 / this.scale,
    });
  }

  copy(): Camera {
    return Object.assign(new Camera(), this);
  }

  saved(): { x: number; y: number; scale: number } {
    return { x: this.x, y: this.y, scale: this.scale };
  }

  restore(saved: { x: number; y: number; scale: number }): void {
    this.scale = Math.min(kLargestScale, Math.max(kSmallestScale, saved.scale));
    this.lookAt(saved);
  }
}

/** What is kept free at each edge of the screen [CSS pixels]. */
interface Room {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** Keeps clear of a covered place: of a tall one at its side, else above or below it, where there is more room. */
function roomBeside(place: Box, room: Room, screen: { width: number; height: number }): Room {
  const [fromRight, fromBottom] = [screen.width - place.xMin + kGap, screen.height - place.yMin + kGap];
  const [fromLeft, fromTop] = [place.xMax + kGap, place.yMax + kGap];
  if (place.yMax - place.yMin > place.xMax - place.xMin) {
    return fromLeft < fromRight
      ? { ...room, left: Math.max(room.left, fromLeft) }
      : { ...room, right: Math.max(room.right, fromRight) };
  }
  return fromTop < fromBottom
    ? { ...room, top: Math.max(room.top, fromTop) }
    : { ...room, bottom: Math.max(room.bottom, fromBottom) };
}
