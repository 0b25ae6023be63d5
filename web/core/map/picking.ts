// Finds the overlay's things under the pointer or in a box.
import { type Box, distance, type Point } from "../geometry.ts";
import type { MapSettings } from "../map_settings.ts";
import type { Scene } from "../protocol.ts";
import type { MapItem } from "../selection.ts";
import { SpatialIndex } from "../spatial_index.ts";
import { boxOfMeasure, distanceTo } from "./measure_shape.ts";

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

function around(x: number, y: number, radius: number): Box {
  return { xMin: x - radius, yMin: y - radius, xMax: x + radius, yMax: y + radius };
}
