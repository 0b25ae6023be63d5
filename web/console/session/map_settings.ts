// How the map looked the last time, read back with care: what was stored may be of another version.
import type { LayerName, MapSettings } from "../../core/map_settings.ts";

/** What is stored and fits, over `fallback`. The theme is the shell's business. */
export function readMapSettings(stored: unknown, fallback: MapSettings): MapSettings {
  if (typeof stored !== "object" || stored === null) return fallback;
  const from = stored as Record<string, unknown>;
  const result: Record<string, unknown> = { ...fallback };
  const choices: Partial<Record<keyof MapSettings, readonly unknown[]>> = {
    trails: ["fade", "stay"],
    robotLabels: ["none", "selected", "all"],
    renderer: ["auto", "webgl", "canvas"],
  };
  for (const [name, before] of Object.entries(fallback)) {
    if (name === "theme" || name === "layers") continue;
    const value = from[name];
    if (typeof value !== typeof before) continue;
    const allowed = choices[name as keyof MapSettings];
    if (allowed ? allowed.includes(value) : typeof value !== "number" || (value >= 0.1 && value <= 1000)) {
      result[name] = value;
    }
  }
  const layers = { ...fallback.layers };
  if (typeof from.layers === "object" && from.layers !== null) {
    for (const name of Object.keys(layers) as LayerName[]) {
      const shown = (from.layers as Record<string, unknown>)[name];
      if (typeof shown === "boolean") layers[name] = shown;
    }
  }
  return { ...(result as unknown as MapSettings), layers };
}
