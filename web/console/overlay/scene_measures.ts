// Control measures of the Scene as the drawing tools see them, and the changes that bring them about.

import { kindInfo, kindOfWire, type MeasureKind } from "../../core/measure_kinds.ts";
import type { Measure } from "../../core/protocol.ts";
import type { MapChangeInit } from "../map_editing/edit_map.ts";
import { type Draft, hallwayPoints, measurePoints } from "./draft.ts";
import type { MeasureText } from "./odl_text.ts";
import type { Geometry } from "./vertices.ts";

export interface EditedMeasure extends MeasureText {
  /** Of a boundary: weather, no-fly, no-communication; empty: none. */
  readonly zone: string;
}

/** null: of a kind that this console doesn't know. */
export function editedMeasure(measure: Measure): EditedMeasure | null {
  const info = kindOfWire(measure.kind);
  if (!info) return null;
  return {
    kind: info.kind,
    name: measure.name,
    showsLabel: measure.showsLabel,
    points: measure.points.map(({ x, y }) => ({ x, y })),
    centerline: measure.centerline.map(({ x, y }) => ({ x, y })),
    size: measure.size,
    zone: measure.zone,
  };
}

export function measureOfDraft(draft: Draft, name: string): EditedMeasure {
  const { points, centerline } = measurePoints(draft);
  const size = draft.size > 0 ? draft.size : draft.kind === "hallway" ? kindInfo("hallway").defaultSize : 0;
  return { kind: draft.kind, name, showsLabel: true, points, centerline, size, zone: "" };
}

/** What its handles change: of a hallway the centre line, of all others the points. */
export function geometryOf(measure: EditedMeasure): Geometry {
  const points = measure.kind === "hallway" ? measure.centerline : measure.points;
  return { points, size: measure.size };
}

/** With these points. A hallway's corners follow its centre line and width. */
export function withGeometry(measure: EditedMeasure, geometry: Geometry): EditedMeasure {
  const { points, size } = geometry;
  if (measure.kind !== "hallway") return { ...measure, points, size };
  const width = size > 0 ? size : kindInfo("hallway").defaultSize;
  return { ...measure, ...hallwayPoints(points, width), size: width };
}

export function addMeasure(measure: EditedMeasure): MapChangeInit {
  return { change: { case: "addMeasure", value: wireOf(measure) } };
}

export function replaceMeasure(index: number, measure: EditedMeasure): MapChangeInit {
  return { change: { case: "replaceMeasure", value: { index, measure: wireOf(measure) } } };
}

/** `AA-1`, or `assembly area` where it has no name: for undo. */
export function titleOf(measure: { kind: MeasureKind; name: string }): string {
  return measure.name === "" ? kindInfo(measure.kind).label.toLowerCase() : measure.name;
}

function wireOf({ kind, name, showsLabel, points, centerline, size, zone }: EditedMeasure) {
  return {
    kind: kindInfo(kind).wire,
    name,
    showsLabel,
    points: points.map(({ x, y }) => ({ x, y })),
    centerline: centerline.map(({ x, y }) => ({ x, y })),
    size,
    zone,
  };
}
