// A frame with all that can be told of watched robots.
import { create } from "@bufbuild/protobuf";
import { type Frame, RobotDetailSchema } from "../../core/protocol.ts";
import { frameOf, type PlacedRobot, type Session } from "./scenes.ts";

function floats(...values: number[]): Uint8Array {
  return new Uint8Array(new Float32Array(values).buffer);
}

function points(list: readonly (readonly [number, number, number])[]): Uint8Array {
  const bytes = new Uint8Array(list.length * 12);
  const view = new DataView(bytes.buffer);
  list.forEach(([id, x, y], row) => {
    view.setUint32(row * 12, id, true);
    view.setFloat32(row * 12 + 4, x, true);
    view.setFloat32(row * 12 + 8, y, true);
  });
  return bytes;
}

/** The nearest hit of a ray on the obstacles, or the range where there is none. */
function rayLength(session: Session, robot: PlacedRobot, angle: number, range: number): number {
  let nearest = range;
  for (const { x = 0, y = 0, radius = 0 } of session.scene.obstacles ?? []) {
    const dx = x - robot.x;
    const dy = y - robot.y;
    const ahead = dx * Math.cos(angle) + dy * Math.sin(angle);
    const aside = Math.abs(dy * Math.cos(angle) - dx * Math.sin(angle));
    if (ahead > 0 && aside < radius) nearest = Math.min(nearest, ahead - Math.sqrt(radius ** 2 - aside ** 2));
  }
  return nearest;
}

export function watchedFrame(session: Session, number: number, time: number): Frame {
  const frame = frameOf(session.robots, number, time);
  const size = session.scene.width! / 1100;
  frame.stations = points(session.robots.map(({ id, x, y }) => [id, x + 14 * size, y + (id % 2 ? 9 : -12) * size]));
  frame.vectors = points(session.robots.map(({ id, heading }) => [id, 2 * Math.cos(heading), 2 * Math.sin(heading)]));
  frame.details = session.robots.map((robot) => detailOf(session, robot, size));
  return frame;
}

function detailOf(session: Session, robot: PlacedRobot, size: number) {
  const range = 100 * size;
  const rays = Array.from({ length: 32 }, (_, i) => (i / 32) * 2 * Math.PI);
  const near = (session.scene.obstacles ?? []).filter(
    ({ x = 0, y = 0, radius = 0 }) => Math.hypot(x - robot.x, y - robot.y) < range + radius,
  );
  return create(RobotDetailSchema, {
    ...robot,
    contributions: [
      { sum: "Move", member: "MoveToGoal", x: 0.8, y: 0.1 },
      { sum: "Move", member: "AvoidObstacles", x: -0.25, y: 0.55 },
      { sum: "Move", member: "MaintainFormation", x: 0.3, y: -0.45 },
      { sum: "Move", member: "Noise", x: -0.12, y: -0.3 },
    ],
    goal: { x: 470 * size, y: 420 * size },
    station: { x: robot.x + 14 * size, y: robot.y + (robot.id % 2 ? 9 : -12) * size },
    ranges: floats(
      ...rays.flatMap((angle) => {
        const length = rayLength(session, robot, robot.heading + angle, range);
        return [angle, length, length < range ? 1 : 0];
      }),
    ),
    obstacles: floats(...near.flatMap(({ x = 0, y = 0, radius = 0 }) => [x, y, radius])),
  });
}
