// What is plotted and how: kept over reloads, and there whether or not the panel is open.
import { createStore } from "zustand/vanilla";
import { readRecord } from "../../core/stored.ts";
import { type SeriesSpec, seriesFromJson } from "./series.ts";
import type { TimeView } from "./strips.ts";

export interface PlotState {
  readonly specs: readonly SeriesSpec[];
  /** Lines of one unit of measure share a strip. */
  readonly together: boolean;
  /** The last so many seconds while live; 0: everything. */
  readonly window: number;
  readonly view: TimeView;
}

export const kPlotsKey = "mlab.plots";

export function initialPlots(stored: string | null): PlotState {
  const kept = readRecord(stored);
  const window = typeof kept.window === "number" && kept.window >= 0 && Number.isFinite(kept.window) ? kept.window : 60;
  return { specs: seriesFromJson(kept.specs), together: kept.together === true, window, view: { live: true, window } };
}

export function plotsToKeep({ specs, together, window }: PlotState): string {
  return JSON.stringify({ specs, together, window });
}

export const plotStore = createStore<PlotState>(() => initialPlots(stored()));

plotStore.subscribe((state, before) => {
  const text = plotsToKeep(state);
  if (text !== plotsToKeep(before)) globalThis.localStorage?.setItem(kPlotsKey, text);
});

function stored(): string | null {
  return globalThis.localStorage?.getItem(kPlotsKey) ?? null;
}
