// What moves a robot: the parts of each vector sum of its program, ready to be drawn as bars and arrows.
import type { RobotDetail_Contribution } from "../../core/protocol.ts";

export interface Member {
  name: string;
  x: number; // robot frame: x ahead, y left; 1 is full strength
  y: number;
  size: number;
  share: number; // of the largest part of this sum, 0..1
  /** Whether it pulls where the sum goes. */
  effect: "with" | "against" | "across" | "none";
}

export interface VectorSum {
  name: string;
  x: number;
  y: number;
  size: number;
  members: Member[];
}

export function vectorSums(contributions: readonly RobotDetail_Contribution[]): VectorSum[] {
  const bySum = new Map<string, RobotDetail_Contribution[]>();
  for (const contribution of contributions) {
    const parts = bySum.get(contribution.sum) ?? [];
    parts.push(contribution);
    bySum.set(contribution.sum, parts);
  }
  return [...bySum].map(([name, parts]) => {
    const x = parts.reduce((sum, part) => sum + part.x, 0);
    const y = parts.reduce((sum, part) => sum + part.y, 0);
    const largest = Math.max(...parts.map((part) => Math.hypot(part.x, part.y)));
    return {
      name,
      x,
      y,
      size: Math.hypot(x, y),
      members: parts.map((part) => {
        const size = Math.hypot(part.x, part.y);
        return {
          name: part.member,
          x: part.x,
          y: part.y,
          size,
          share: largest > 0 ? size / largest : 0,
          effect: effectOf(part, x, y),
        };
      }),
    };
  });
}

/** Where a vector of the robot frame points, in words. */
export function direction(x: number, y: number): string {
  if (Math.hypot(x, y) < 1e-6) return "nowhere";
  const words = ["ahead", "ahead left", "left", "back left", "back", "back right", "right", "ahead right"];
  const eighth = Math.round(Math.atan2(y, x) / (Math.PI / 4));
  return words[(eighth + 8) % 8] as string;
}

function effectOf(part: { x: number; y: number }, x: number, y: number): Member["effect"] {
  const size = Math.hypot(part.x, part.y);
  const total = Math.hypot(x, y);
  if (size < 1e-6) return "none";
  if (total < 1e-6) return "across";
  const cosine = (part.x * x + part.y * y) / (size * total);
  return cosine > 0.3 ? "with" : cosine < -0.3 ? "against" : "across";
}
