// A reload comes back to the same place on the map and the same selection. Kept for one browser tab.
import type { MapView } from "../../core/map/map_view.ts";
import type { Session } from "../session/session.ts";

interface View {
  mission: string;
  camera: { x: number; y: number; scale: number };
  robots: number[];
  unit: string;
}

const kKey = "mlab.view";
const endings = new WeakMap<MapView, () => void>();

/** Puts the map where it was once the same mission is there, and keeps note of where it goes. */
export function restoreView({ model }: Session, map: MapView, storage: Storage): void {
  const stored = readView(storage.getItem(kKey));
  let settled = false;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const settle = () => {
    const mission = model.get("project")?.mission ?? "";
    if (settled || !model.get("scene") || model.get("roster").robots.length === 0 || mission === "") return;
    settled = true;
    if (stored?.mission !== mission) return;
    map.camera.scale = stored.camera.scale;
    map.camera.lookAt(stored.camera);
    const roster = model.get("roster");
    const robots = stored.robots.filter((id) => roster.robot(id));
    if (robots.length > 0 && model.get("selection").robots.length === 0) {
      model.select({ robots, unit: roster.unit(stored.unit) ? stored.unit : "", items: [] });
    }
    map.redraw();
  };
  const keep = () => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (!settled) return;
      const { x, y, scale } = map.camera;
      const { robots, unit } = model.get("selection");
      const view: View = {
        mission: model.get("project")?.mission ?? "",
        camera: { x, y, scale },
        robots: robots.slice(0, 200),
        unit,
      };
      storage.setItem(kKey, JSON.stringify(view));
    }, 200);
  };
  const ends = [
    model.subscribe("scene", settle),
    model.subscribe("roster", settle),
    model.subscribe("project", settle),
    model.subscribe("selection", keep),
    map.subscribe(keep),
  ];
  settle();
  endings.set(map, () => {
    clearTimeout(timer);
    for (const end of ends) end();
  });
}

export function forgetView(map: MapView): void {
  endings.get(map)?.();
  endings.delete(map);
}

/** Nothing where what is stored is no view. */
export function readView(text: string | null): View | undefined {
  try {
    const view = JSON.parse(text ?? "null") as View;
    const { x, y, scale } = view.camera;
    const isView =
      typeof view.mission === "string" &&
      [x, y, scale].every(Number.isFinite) &&
      scale > 0 &&
      Array.isArray(view.robots) &&
      view.robots.every(Number.isInteger) &&
      typeof view.unit === "string";
    return isView ? view : undefined;
  } catch {
    return undefined;
  }
}
