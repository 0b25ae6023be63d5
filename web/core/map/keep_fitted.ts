// While the whole mission area is fitted to the map, it stays fitted when panels open and close.
import { Camera } from "../camera.ts";
import type { Box } from "../geometry.ts";
import type { Model } from "../model.ts";
import type { MapView } from "./map_view.ts";

interface Place {
  x: number;
  y: number;
  scale: number;
}

/** Whether a map of this size shows just the area, as after fitting it. */
export function isFitted(
  place: Place,
  size: { width: number; height: number },
  area: { width: number; height: number },
  covered: readonly Box[] = [],
): boolean {
  const fitted = new Camera();
  fitted.resize(size.width, size.height);
  fitted.fit({ xMin: 0, yMin: 0, xMax: Math.max(1, area.width), yMax: Math.max(1, area.height) }, undefined, covered);
  const near = (a: number, b: number) => Math.abs(a - b) * fitted.scale < 1.5;
  return near(place.x, fitted.x) && near(place.y, fitted.y) && Math.abs(place.scale / fitted.scale - 1) < 0.002;
}

/** The tools and questions over the map, which what is fitted keeps clear of [CSS pixels of the map]. */
export function coveredPlaces(map: HTMLElement): Box[] {
  const { left, top } = map.getBoundingClientRect();
  const over = map.parentElement?.querySelectorAll(".map-tools, .tool-options, .questions, .banner") ?? [];
  return [...over].map((element) => {
    const box = element.getBoundingClientRect();
    return { xMin: box.left - left, yMin: box.top - top, xMax: box.right - left, yMax: box.bottom - top };
  });
}

/** Returns how to end it. */
export function keepFitted(map: MapView, model: Model): () => void {
  let size = { width: map.camera.width, height: map.camera.height };
  const observer = new ResizeObserver(() => {
    const before = size;
    size = { width: map.camera.width, height: map.camera.height };
    const scene = model.get("scene");
    if (!scene || (before.width === size.width && before.height === size.height)) return;
    if (isFitted(map.camera, before, scene, map.framing.coveredAtFit)) map.framing.fit();
  });
  observer.observe(map.host);
  return () => observer.disconnect();
}
