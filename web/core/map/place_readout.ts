// Where the pointer is in the world, in the map's lower right corner.
import type { Point } from "../geometry.ts";
import { placeText, projectionOf } from "../place_notation.ts";
import type { MapView } from "./map_view.ts";
import { fade, paletteOf } from "./palette.ts";
import { kSans } from "./strokes.ts";

const kEarthRadius = 6_371_000; // m

export class PlaceReadout {
  private readonly element = document.createElement("div");
  private readonly abort = new AbortController();
  /** The newest place under the pointer, also after that has left the map. */
  place: Point | null = null;

  constructor(private readonly map: MapView) {
    this.element.className = "map-place";
    this.element.setAttribute("aria-hidden", "true"); // follows a pointer: of no use to who has none
    map.host.append(this.element);
    const { signal } = this.abort;
    map.host.addEventListener("pointermove", (event) => this.show(event), { signal, passive: true });
    map.host.addEventListener("pointerleave", () => this.hide(), { signal, passive: true });
    this.hide();
  }

  dispose(): void {
    this.abort.abort();
    this.element.remove();
  }

  private hide(): void {
    this.element.style.display = "none";
  }

  private show(event: PointerEvent): void {
    const { layers, theme, notation } = this.map.model.get("map");
    if (!layers.decorations || event.pointerType === "touch") {
      this.hide();
      return;
    }
    const { camera, host, model } = this.map;
    const box = host.getBoundingClientRect();
    const world = camera.toWorld({ x: event.clientX - box.left, y: event.clientY - box.top });
    this.place = world;
    const scene = model.get("scene");
    // Historic maps say no more than where they are about.
    const reference = projectionOf(scene) ? undefined : scene?.globalReference;
    const degrees = reference ? ` · ${formatDegrees(toDegrees(world, reference))}` : "";
    const { ground, ink, areaEdge } = paletteOf(theme);
    this.element.style.cssText =
      `position:absolute;z-index:3;right:10px;bottom:10px;padding:4px 9px;border-radius:8px;pointer-events:none;` +
      `font:500 11.5px ${kSans};font-variant-numeric:tabular-nums;white-space:nowrap;` +
      `color:${ink};background:${fade(ground, 0.92)};border:1px solid ${areaEdge}`;
    this.element.textContent = `${placeText(scene, world, notation, camera.scale)}${degrees}`;
  }
}

/** Latitude and longitude; the overlay is small against the earth, so that a plane touching it is near enough. */
export function toDegrees({ x, y }: Point, reference: Point): { latitude: number; longitude: number } {
  const share = 180 / Math.PI / kEarthRadius;
  return {
    latitude: reference.x + y * share,
    longitude: reference.y + (x * share) / Math.cos((reference.x * Math.PI) / 180),
  };
}

function formatDegrees({ latitude, longitude }: { latitude: number; longitude: number }): string {
  const part = (value: number, positive: string, negative: string): string =>
    `${Math.abs(value).toFixed(5)}° ${value < 0 ? negative : positive}`;
  return `${part(latitude, "N", "S")}, ${part(longitude, "E", "W")}`;
}
