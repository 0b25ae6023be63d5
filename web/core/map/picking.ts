// Finds robots and the overlay's things under the pointer or in a box.
import type { Camera } from "../camera.ts";
import { type Box, boundsOf, distance, type Point, union } from "../geometry.ts";
import type { MapSettings } from "../map_settings.ts";
import type { Model } from "../model.ts";
import type { Scene } from "../protocol.ts";
import type { MapItem } from "../selection.ts";
import { SpatialIndex } from "../spatial_index.ts";
import { boxOfMeasure, distanceTo } from "./measure_shape.ts";
import type { MapPick } from "./tool.ts";

interface Hit {
  readonly item: MapItem;
  readonly edge: number;
  readonly area: number;
}

/** Of one Scene. Objects are where the Scene says, not where they have been carried. */
export class SceneIndex {
  private readonly index: SpatialIndex<MapItem>;

  constructor(private readonly scene: Scene | null) {
    const entries: { box: Box; item: MapItem }[] = [];
    const add = (kind: MapItem["kind"], index: number, box: Box | null): void => {
      if (box) entries.push({ box, item: { kind, index } });
    };
    scene?.measures.forEach((measure, i) => {
      add("measure", i, boxOfMeasure(measure));
    });
    scene?.obstacles.forEach(({ x, y, radius }, i) => {
      add("obstacle", i, around(x, y, radius));
    });
    scene?.objects.forEach(({ x, y, diameter }, i) => {
      add("object", i, around(x, y, diameter / 2));
    });
    this.index = new SpatialIndex(entries);
  }

  boxOf(item: MapItem): Box | null {
    if (!this.scene) return null;
    if (item.kind === "measure") {
      const measure = this.scene.measures[item.index];
      return measure ? boxOfMeasure(measure) : null;
    }
    const disc = this.discOf(item);
    return disc && around(disc.x, disc.y, disc.radius);
  }

  /** Within `reach` [m], what is drawn on top first: discs, then lines, then areas, the smaller before the larger. */
  near(place: Point, reach: number, settings: MapSettings): MapItem[] {
    const box = around(place.x, place.y, reach * 8);
    const hits = this.index
      .within(box)
      .filter((item) => settings.layers[`${item.kind}s`])
      .flatMap((item) => this.hit(item, place, reach) ?? []);
    hits.sort((a, b) => Number(a.edge > reach) - Number(b.edge > reach) || a.area - b.area || a.edge - b.edge);
    return hits.map(({ item }) => item);
  }

  /** Wholly in the box. */
  inside(box: Box, settings: MapSettings): MapItem[] {
    return this.index.within(box).filter((item) => {
      const own = this.boxOf(item);
      return (
        own !== null &&
        settings.layers[`${item.kind}s`] &&
        own.xMin >= box.xMin &&
        own.xMax <= box.xMax &&
        own.yMin >= box.yMin &&
        own.yMax <= box.yMax
      );
    });
  }

  private hit(item: MapItem, place: Point, reach: number): Hit | null {
    if (item.kind === "measure") {
      const measure = this.scene!.measures[item.index]!;
      const { edge, isInside } = distanceTo(measure, place, reach);
      if (edge > reach && !isInside) return null;
      const box = boxOfMeasure(measure)!;
      return { item, edge, area: 1 + (box.xMax - box.xMin) * (box.yMax - box.yMin) };
    }
    const disc = this.discOf(item)!;
    const away = distance(disc, place) - disc.radius;
    return away > reach ? null : { item, edge: Math.max(0, away), area: 0 };
  }

  private discOf(item: MapItem): { x: number; y: number; radius: number } | null {
    if (item.kind === "obstacle") return this.scene?.obstacles[item.index] ?? null;
    const object = this.scene?.objects[item.index];
    return object ? { x: object.x, y: object.y, radius: object.diameter / 2 } : null;
  }
}

/** With their bodies within `reach` [px] of a place on the screen, the nearest first. */
export function robotsNear(model: Model, camera: Camera, screen: Point, reach: number): MapPick[] {
  const world = camera.toWorld(screen);
  const found: { id: number; distance: number }[] = [];
  const { robotScale } = model.get("map");
  const roster = model.get("roster");
  const coarse = (reach + 60) / camera.scale + 2 * robotScale;
  for (const robots of [model.robots, model.get("starts")]) {
    for (let row = 0; row < robots.count; ++row) {
      const dx = robots.x(row) - world.x;
      const dy = robots.y(row) - world.y;
      if (Math.abs(dx) > coarse || Math.abs(dy) > coarse) continue;
      const id = robots.id(row);
      const body = (roster.robot(id)?.radius ?? 0.2) * robotScale * camera.scale;
      const distance = Math.hypot(dx, dy) * camera.scale;
      if (distance <= Math.max(body, 6) + reach) found.push({ id, distance });
    }
  }
  found.sort((a, b) => a.distance - b.distance);
  return found.map(({ id }) => ({ kind: "robot", id }));
}

/** With their middles in the box. */
export function robotsIn(model: Model, box: Box): number[] {
  const found: number[] = [];
  for (const robots of [model.robots, model.get("starts")]) {
    for (let row = 0; row < robots.count; ++row) {
      const x = robots.x(row);
      const y = robots.y(row);
      if (x >= box.xMin && x <= box.xMax && y >= box.yMin && y <= box.yMax) found.push(robots.id(row));
    }
  }
  return found;
}

/** Round all selected robots and things; null: nothing is selected that stands anywhere. */
export function selectionBox(model: Model, index: SceneIndex): Box | null {
  const { robots, items } = model.get("selection");
  let box = boundsOf(robots.flatMap((id) => model.placeOf(id) ?? []));
  for (const item of items) {
    const own = index.boxOf(item);
    if (own) box = box ? union(box, own) : own;
  }
  return box;
}

function around(x: number, y: number, radius: number): Box {
  return { xMin: x - radius, yMin: y - radius, xMax: x + radius, yMax: y + radius };
}
