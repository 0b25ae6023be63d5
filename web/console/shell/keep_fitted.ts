// While the whole mission area is fitted to the map, it stays fitted when panels open and close.
import { Camera } from "../../core/camera.ts";
import type { MapView } from "../../core/map/map_view.ts";
import type { Model } from "../../core/model.ts";

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
): boolean {
  const fitted = new Camera();
  fitted.resize(size.width, size.height);
  fitted.fit({ xMin: 0, yMin: 0, xMax: Math.max(1, area.width), yMax: Math.max(1, area.height) });
  const near = (a: number, b: number) => Math.abs(a - b) * fitted.scale < 1.5;
  return near(place.x, fitted.x) && near(place.y, fitted.y) && Math.abs(place.scale / fitted.scale - 1) < 0.002;
}

/** Returns how to end it. */
export function keepFitted(map: MapView, model: Model): () => void {
  let size = { width: map.camera.width, height: map.camera.height };
  const observer = new ResizeObserver(() => {
    const before = size;
    size = { width: map.camera.width, height: map.camera.height };
    const scene = model.get("scene");
    if (scene && (before.width !== size.width || before.height !== size.height) && isFitted(map.camera, before, scene))
      map.fit();
  });
  observer.observe(map.host);
  return () => observer.disconnect();
}
