// Obstacles and objects of the map as things that can be listed, taken hold of and changed.

export interface ObstacleThing {
  readonly type: "obstacle";
  readonly index: number;
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  readonly height: number;
  readonly document: string;
}

export type ObjectStyle = "fixed" | "movable" | "container";

export interface ObjectThing {
  readonly type: "object";
  readonly index: number;
  readonly x: number;
  readonly y: number;
  readonly diameter: number;
  readonly style: ObjectStyle;
  readonly color: string;
  readonly document: string;
}

export type Thing = ObstacleThing | ObjectThing;

/** `obstacle 3`: counted from 1, as it is listed. */
export function thingName(thing: Thing): string {
  return `${thing.type} ${thing.index + 1}`;
}

export function thingKey(thing: { type: string; index: number }): string {
  return `${thing.type}/${thing.index}`;
}

export function radiusOf(thing: Thing): number {
  return thing.type === "obstacle" ? thing.radius : thing.diameter / 2;
}

export function isEditable(thing: Thing): boolean {
  return thing.document !== "";
}

export function movedTo<T extends Thing>(thing: T, x: number, y: number): T {
  return { ...thing, x, y };
}

export function withRadius<T extends Thing>(thing: T, radius: number): T {
  return thing.type === "obstacle" ? { ...thing, radius } : { ...thing, diameter: 2 * radius };
}

export type ThingGrip = "body" | "edge";

/**
 * What a press at this point takes hold of. The edge of the selected thing wins, then the smallest thing under the point:
 * what lies on top of a large one can be reached. `reach` [m] is how near counts as on it.
 */
export function gripAt(
  things: readonly Thing[],
  selected: string | null,
  at: { x: number; y: number },
  reach: number,
): { thing: Thing; grip: ThingGrip } | null {
  const chosen = things.find((t) => thingKey(t) === selected);
  if (chosen && isEditable(chosen)) {
    const handle = { x: chosen.x + Math.max(radiusOf(chosen), reach * 1.5), y: chosen.y };
    if (Math.hypot(handle.x - at.x, handle.y - at.y) <= reach) return { thing: chosen, grip: "edge" };
  }
  let best: Thing | null = null;
  for (const thing of things) {
    const distance = Math.hypot(thing.x - at.x, thing.y - at.y);
    if (distance > Math.max(radiusOf(thing), reach)) continue;
    if (!best || radiusOf(thing) < radiusOf(best)) best = thing;
  }
  return best ? { thing: best, grip: "body" } : null;
}

/** What undo is called: `move obstacle 3`, `move 2 things`. */
export function editName(verb: string, things: readonly Thing[]): string {
  return things.length === 1 ? `${verb} ${thingName(things[0] as Thing)}` : `${verb} ${things.length} things`;
}
