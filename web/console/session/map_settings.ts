// How the map looked the last time, read back with care: what was stored may be of another version.

import type { LayerName, MapSettings } from "../../core/map_settings.ts";
import { kPlaceNotations } from "../../core/place_notation.ts";
import { isRecord } from "../../core/stored.ts";

/** What is stored and fits, over `fallback`. The theme is the shell's business. */
export function readMapSettings(stored: unknown, fallback: MapSettings): MapSettings {
  if (!isRecord(stored)) return fallback;
  const kept = Object.keys(fallback).filter(
    (name) => name !== "theme" && name !== "layers" && fits(name as keyof MapSettings, stored[name], fallback),
  );
  const read = Object.fromEntries(kept.map((name) => [name, stored[name]]));
  return { ...fallback, ...read, layers: readLayers(stored.layers, fallback.layers) };
}

const kChoices: Partial<Record<keyof MapSettings, readonly unknown[]>> = {
  trails: ["fade", "stay"],
  robotLabels: ["none", "selected", "all"],
  notation: kPlaceNotations.map(([notation]) => notation),
  renderer: ["auto", "webgl", "canvas"],
};

function fits(name: keyof MapSettings, value: unknown, fallback: MapSettings): boolean {
  if (typeof value !== typeof fallback[name]) return false;
  const allowed = kChoices[name];
  if (allowed) return allowed.includes(value);
  return typeof value !== "number" || (value >= 0.1 && value <= 1000);
}

function readLayers(stored: unknown, fallback: MapSettings["layers"]): MapSettings["layers"] {
  const layers = { ...fallback };
  if (!isRecord(stored)) return layers;
  for (const name of Object.keys(layers) as LayerName[]) {
    const shown = stored[name];
    if (typeof shown === "boolean") layers[name] = shown;
  }
  return layers;
}
