// Which lines share a panel, how they are told apart, and which span of time is shown.

import { quantityInfo, type SeriesSpec, seriesKey, subjectLabel, whoLabel } from "./series.ts";

export interface StripLine {
  readonly spec: SeriesSpec;
  readonly key: string;
  /** In the strip's legend: who, and with several subjects what. */
  readonly label: string;
  readonly color: number;
  readonly dash: readonly number[];
}

/** Lines over one vertical axis, in one unit. */
export interface Strip {
  readonly key: string;
  readonly title: string;
  readonly unit: string;
  readonly lines: readonly StripLine[];
}

/** Colours of the palette that are told apart, also by who sees colours differently. */
export const kColors = 8;
const kDashes: readonly (readonly number[])[] = [[], [8, 4], [2, 3], [8, 3, 2, 3]];

/** The unit in which values of a series are shown. `portUnit` knows those of ports. */
export function unitOf(spec: SeriesSpec, portUnit: (robot: number, port: string) => string): string {
  return spec.quantity === "port" ? portUnit(spec.robot, spec.port) : (quantityInfo(spec.quantity)?.unit ?? "");
}

/**
 * A strip for each subject, in the order in which they were chosen; with `together` one for each unit. The same robot or
 * unit has the same colour in all strips; beyond eight, and for a second subject in a strip, lines are dashed.
 */
export function stripsOf(
  specs: readonly SeriesSpec[],
  together: boolean,
  portUnit: (robot: number, port: string) => string,
): Strip[] {
  const people = [...new Set(specs.map(whoLabel))];
  const groups = new Map<string, SeriesSpec[]>();
  for (const spec of specs) {
    const unit = unitOf(spec, portUnit);
    const key = together ? `unit:${unit}` : `${subjectLabel(spec)}|${unit}`;
    groups.set(key, [...(groups.get(key) ?? []), spec]);
  }
  return [...groups].map(([key, members]) => {
    const subjects = [...new Set(members.map(subjectLabel))];
    return {
      key,
      title: subjects.join(", "),
      unit: unitOf(members[0] as SeriesSpec, portUnit),
      lines: members.map((spec) => {
        const person = people.indexOf(whoLabel(spec));
        const round = Math.floor(person / kColors) + subjects.indexOf(subjectLabel(spec));
        return {
          spec,
          key: seriesKey(spec),
          label: subjects.length > 1 ? `${whoLabel(spec)}: ${subjectLabel(spec)}` : whoLabel(spec),
          color: person % kColors,
          dash: kDashes[round % kDashes.length] as readonly number[],
        };
      }),
    };
  });
}

/** Live: the last `window` seconds (0: everything). A span: zoomed in, or held by pausing. */
export type TimeView =
  | { readonly live: true; readonly window: number }
  | { readonly live: false; readonly from: number; readonly to: number };

export const kWindows: readonly { readonly seconds: number; readonly label: string }[] = [
  { seconds: 10, label: "10 s" },
  { seconds: 60, label: "1 min" },
  { seconds: 300, label: "5 min" },
  { seconds: 0, label: "All" },
];

/** The span that is shown when samples reach from `first` to `last`; at least a second, so that there is something to see. */
export function spanOf(view: TimeView, first: number, last: number): { from: number; to: number } {
  if (!view.live) return { from: view.from, to: view.to };
  if (!Number.isFinite(last)) return { from: 0, to: Math.max(view.window, 1) };
  const from = view.window > 0 ? Math.max(last - view.window, Math.min(first, last - 1)) : first;
  return { from, to: Math.max(last, from + 1) };
}

/** While another moment is shown, as much time as was shown live, with that moment in it: the whole run where that was. */
export function spanRound(view: TimeView, time: number, end: number): { from: number; to: number } {
  if (!view.live) return { from: view.from, to: view.to };
  const last = Math.max(end, 1);
  if (view.window <= 0 || view.window >= last) return { from: 0, to: last };
  const from = Math.min(Math.max(0, time - view.window / 2), last - view.window);
  return { from, to: from + view.window };
}

/** The middle stays; never less than a tenth of a second. */
export function zoomSpan(span: { from: number; to: number }, factor: number): { from: number; to: number } {
  const middle = (span.from + span.to) / 2;
  const half = Math.max(((span.to - span.from) / 2) * factor, 0.05);
  return { from: middle - half, to: middle + half };
}

/** By a share of its length, to the right if positive. */
export function panSpan(span: { from: number; to: number }, share: number): { from: number; to: number } {
  const by = (span.to - span.from) * share;
  return { from: span.from + by, to: span.to + by };
}
