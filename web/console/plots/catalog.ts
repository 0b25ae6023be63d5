// What the chooser offers: subjects (quantities, and the number ports of programs) and who they could be of.

import { kQuantities, type QuantityName, type SeriesSpec, seriesKey } from "./series.ts";

export interface CatalogPort {
  readonly path: string;
  readonly unit: string;
  readonly help: string;
  readonly isNumber: boolean;
}

/** What is needed of the Roster. */
export interface CatalogRoster {
  readonly robots: readonly { id: number; type: string; unit: string; program: number }[];
  readonly units: readonly { name: string; members: readonly number[] }[];
  readonly programs: readonly { name: string; ports: readonly CatalogPort[] }[];
}

export interface Subject {
  readonly key: string;
  readonly quantity: QuantityName;
  readonly port: string;
  readonly label: string;
  readonly unit: string;
  readonly help: string;
}

export interface PlotSubject {
  readonly key: string;
  readonly robot: number;
  readonly unit: string;
  readonly label: string;
  readonly detail: string;
}

/** Quantities first, then the ports of all programs by path. A port that several programs have is there once. */
export function subjectsOf(roster: CatalogRoster): Subject[] {
  const quantities = kQuantities.map((q) => ({
    key: q.name,
    quantity: q.name,
    port: "",
    label: q.label,
    unit: q.unit,
    help: q.help,
  }));
  const ports = new Map<string, Subject>();
  for (const program of roster.programs) {
    for (const p of program.ports) {
      if (!p.isNumber || ports.has(p.path)) continue;
      const key = `port/${p.path}`;
      ports.set(p.path, { key, quantity: "port", port: p.path, label: p.path, unit: p.unit, help: p.help });
    }
  }
  return [...quantities, ...[...ports.values()].sort((a, b) => (a.port < b.port ? -1 : 1))];
}

/** Units first, then robots by number. */
export function whoOf(roster: CatalogRoster): PlotSubject[] {
  const units = roster.units.map((u) => ({
    key: `u:${u.name}`,
    robot: 0,
    unit: u.name,
    label: u.name,
    detail: u.members.length === 1 ? "unit, 1 robot" : `unit, ${u.members.length} robots`,
  }));
  const robots = [...roster.robots]
    .sort((a, b) => a.id - b.id)
    .map((r) => ({
      key: `r${r.id}`,
      robot: r.id,
      unit: "",
      label: `Robot ${r.id}`,
      detail: r.unit === "" ? r.type : `${r.type}, ${r.unit}`,
    }));
  return [...units, ...robots];
}

/** Entries that have all words of the query somewhere in their texts, in any letter case; the order stays. */
export function searchEntries<T>(entries: readonly T[], query: string, texts: (entry: T) => readonly string[]): T[] {
  const words = query
    .toLowerCase()
    .split(/\s+/)
    .filter((w) => w !== "");
  if (words.length === 0) return [...entries];
  return entries.filter((e) => {
    const hay = texts(e).join(" ").toLowerCase();
    return words.every((w) => hay.includes(w));
  });
}

/**
 * The series of all chosen subjects for all who were chosen. A port of a unit means that port of each of its robots.
 * Robots whose program does not have the port are left out, and so is what is there already.
 */
export function seriesFor(
  roster: CatalogRoster,
  subjects: readonly Subject[],
  who: readonly PlotSubject[],
  present: readonly SeriesSpec[],
): SeriesSpec[] {
  const seen = new Set(present.map(seriesKey));
  const hasPort = portFinder(roster);
  const result: SeriesSpec[] = [];
  const add = (s: SeriesSpec) => {
    if (seen.has(seriesKey(s))) return;
    seen.add(seriesKey(s));
    result.push(s);
  };
  for (const subject of subjects) {
    for (const w of who) {
      if (subject.quantity !== "port") {
        add({ quantity: subject.quantity, robot: w.robot, unit: w.unit, port: "" });
        continue;
      }
      for (const robot of robotsOf(roster, w)) {
        if (hasPort(robot, subject.port)) add({ quantity: "port", robot, unit: "", port: subject.port });
      }
    }
  }
  return result;
}

function robotsOf(roster: CatalogRoster, who: PlotSubject): readonly number[] {
  return who.robot !== 0 ? [who.robot] : (roster.units.find((u) => u.name === who.unit)?.members ?? []);
}

function portFinder(roster: CatalogRoster): (robot: number, port: string) => boolean {
  const programOf = new Map(roster.robots.map((r) => [r.id, r.program]));
  const ports = roster.programs.map((p) => new Set(p.ports.filter((port) => port.isNumber).map((port) => port.path)));
  return (robot, port) => ports[programOf.get(robot) ?? -1]?.has(port) ?? false;
}
