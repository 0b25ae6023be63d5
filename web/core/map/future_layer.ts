// The other future on the map: its trails dashed, its robots as outlines where they would be.
import type { Model } from "../model.ts";
import { ghostAt, isShown, sampleBefore } from "../other_future.ts";
import type { OtherFuture, OtherFuture_Robot } from "../protocol.ts";
import { kRobotShape, RobotStyles } from "./robot_styles.ts";
import { fill, isOnScreen, kSans, stroke, writeText } from "./strokes.ts";
import type { Pen } from "./tool.ts";

const kMostNamed = 40; // ghosts: of more, names would be a tangle

/** Draws it as it is at `time` [s]. */
export class FutureLayer {
  private readonly styles = new RobotStyles();

  draw(pen: Pen, model: Model, time: number): void {
    const future = model.get("otherFuture");
    if (!isShown(future)) return;
    this.styles.update(model);
    for (const robot of future.robots) this.drawTrail(pen, future, robot, time);
    for (const robot of future.robots) this.drawGhost(pen, future, robot, time);
  }

  /** Up to the moment strongly, beyond it faintly. */
  private drawTrail(pen: Pen, future: OtherFuture, robot: OtherFuture_Robot, time: number): void {
    const now = sampleBefore(future.times, time);
    const last = future.times.length - 1;
    const { context } = pen;
    for (const [from, to, opacity] of [
      [Math.max(0, now), last, 0.35],
      [0, now, 0.9],
    ] as const) {
      if (to <= from) continue;
      context.beginPath();
      this.trace(pen, robot, from, to);
      context.globalAlpha = opacity;
      stroke(pen, { color: this.styles.cssColor(robot.robot), width: 2, dash: [6, 5] });
      context.globalAlpha = 1;
    }
  }

  private trace({ context, camera }: Pen, { x, y }: OtherFuture_Robot, from: number, to: number): void {
    let isDown = false;
    for (let i = from; i <= to; ++i) {
      const isThere = Number.isFinite(x[i]);
      if (isThere && isDown) context.lineTo(camera.toScreenX(x[i]!), camera.toScreenY(y[i]!));
      else if (isThere) context.moveTo(camera.toScreenX(x[i]!), camera.toScreenY(y[i]!));
      isDown = isThere;
    }
  }

  private drawGhost(pen: Pen, future: OtherFuture, robot: OtherFuture_Robot, time: number): void {
    const ghost = ghostAt(future, robot, time);
    if (!ghost) return;
    const { context, camera, palette } = pen;
    const x = camera.toScreenX(ghost.x);
    const y = camera.toScreenY(ghost.y);
    if (!isOnScreen(camera, x, y)) return;
    const size = this.styles.pixels(ghost.id, camera.scale);
    const c = Math.cos(ghost.heading);
    const s = Math.sin(ghost.heading);
    context.beginPath();
    kRobotShape.forEach(([ahead, left], i) => {
      const px = x + size * (ahead * c - left * s);
      const py = y - size * (ahead * s + left * c);
      if (i === 0) context.moveTo(px, py);
      else context.lineTo(px, py);
    });
    context.closePath();
    context.globalAlpha = 0.75;
    fill(pen, palette.ground);
    context.globalAlpha = 1;
    stroke(pen, { color: palette.halo, width: 4 });
    stroke(pen, { color: this.styles.cssColor(ghost.id), width: 1.75 });
    if (future.robots.length > kMostNamed) return;
    writeText(pen, `${ghost.id}′`, x, y + size * 0.5 + 8, palette.softInk, `600 10.5px ${kSans}`);
  }
}
