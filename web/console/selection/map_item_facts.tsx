import type { ReactNode } from "react";
import { centreOf } from "../../core/geometry.ts";
import { Measure_Kind, WorldObject_Style } from "../../core/protocol.ts";
import type { MapItem } from "../../core/selection.ts";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { FactList } from "../../ui/controls/fact_list.tsx";
import { distance } from "../../ui/words/format.ts";
import { usePart, useSession } from "../session/session.ts";
import { PlaceValue } from "./place_value.tsx";

/** A control measure, an obstacle or an object. */
export function MapItemFacts({ item, others }: { item: MapItem; others: number }) {
  const { ui } = useSession();
  const scene = usePart("scene");
  const described = scene && describe(scene, item);
  if (!described) return null;
  return (
    <>
      <header className="selection-head">
        <h3 className="grow ellipsis">{described.title}</h3>
        <IconButton
          icon="centre"
          label="Show on the map"
          shortcut="."
          onPress={() => ui.get("map")?.framing.fitSelection()}
        />
      </header>
      <div className="rows tab-body">
        {others > 0 && <p className="small muted">And {others} more.</p>}
        <FactList rows={described.rows} />
        {described.document ? (
          <Button tone="link" onPress={() => ui.set("reveal", { document: described.document, line: described.line })}>
            {described.document}:{described.line}
          </Button>
        ) : (
          <p className="small muted">Not written in an overlay, so it can't be edited.</p>
        )}
      </div>
    </>
  );
}

interface ItemFacts {
  title: string;
  rows: (readonly [string, ReactNode])[];
  document: string;
  line: number;
}

type SceneOf = NonNullable<ReturnType<typeof usePart<"scene">>>;

function describe(scene: SceneOf, item: MapItem): ItemFacts | undefined {
  if (item.kind === "measure") return describeMeasure(scene, item.index);
  if (item.kind === "obstacle") {
    const obstacle = scene.obstacles[item.index];
    if (!obstacle) return undefined;
    return {
      title: "Obstacle",
      rows: [
        ["Place", <PlaceValue key="place" at={obstacle} />],
        ["Radius", distance(obstacle.radius)],
        ...(obstacle.route.length > 0
          ? [["Moves", `at ${obstacle.speed} m/s along ${obstacle.route.length + 1} points`] as const]
          : []),
      ],
      document: obstacle.document,
      line: obstacle.line,
    };
  }
  const object = scene.objects[item.index];
  if (!object) return undefined;
  return {
    title: "Object",
    rows: [
      ["Place", <PlaceValue key="place" at={object} />],
      ["Diameter", distance(object.diameter)],
      ["Kind", words(WorldObject_Style[object.style] ?? "")],
      ["Colour", object.color],
    ],
    document: object.document,
    line: object.line,
  };
}

function describeMeasure(scene: SceneOf, index: number): ItemFacts | undefined {
  const measure = scene.measures[index];
  if (!measure) return undefined;
  const kind = words(Measure_Kind[measure.kind] ?? "");
  const points = measure.points.map((point) => `${Math.round(point.x)}, ${Math.round(point.y)}`);
  return {
    title: measure.name || kind,
    rows: [
      ["Kind", kind],
      ...(measure.points.length > 1
        ? [["Points", points.slice(0, 6).join(" · ") + (points.length > 6 ? " …" : "")] as const]
        : []),
      [measure.points.length > 1 ? "Middle" : "Place", <PlaceValue key="place" at={centreOf(measure.points)} />],
      ["Size", measure.size > 0 ? distance(measure.size) : "–"],
      ...(measure.zone ? [["Zone", measure.zone] as const] : []),
    ],
    document: measure.document,
    line: measure.line,
  };
}

function words(name: string): string {
  const lower = name.toLowerCase().replaceAll("_", " ");
  return lower.charAt(0).toUpperCase() + lower.slice(1);
}
