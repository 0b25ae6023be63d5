// How the map and the console look. Everything here can be undone.

import { useState } from "react";
import { kLayers, type MapSettings, withLayer } from "../../core/map_settings.ts";
import { kPlaceNotations, type PlaceNotation } from "../../core/place_notation.ts";
import { Choice } from "../../ui/controls/choice.tsx";
import { RangeSlider, Segments, Switch } from "../../ui/controls/controls.tsx";
import type { ThemeChoice } from "../../ui/controls/theme.ts";
import { askForCalls } from "../calls/calls.ts";
import { usePart, useSession, useUi } from "../session/session.ts";

type Edit = (name: string, change: Partial<MapSettings>) => void;

interface MapProps {
  map: MapSettings;
  edit: Edit;
}

export function ViewPanel() {
  const { ui } = useSession();
  const map = usePart("map");
  const edit: Edit = (name, change) => ui.editMap(name, change);
  return (
    <div className="rows tab-body">
      <Colours />
      <MapLook map={map} edit={edit} />
      <Places map={map} edit={edit} />
      <RobotScale />
      <CallsSwitch />
      <Layers map={map} edit={edit} />
      <Marks map={map} edit={edit} />
    </div>
  );
}

function Colours() {
  const { ui } = useSession();
  const theme = useUi("theme");
  return (
    <Row label="Colours">
      <Segments<ThemeChoice>
        label="Colours"
        value={theme}
        onChange={(value) => ui.set("theme", value)}
        choices={[
          ["auto", "System"],
          ["light", "Light"],
          ["dark", "Dark"],
        ]}
      />
    </Row>
  );
}

function MapLook({ map, edit }: MapProps) {
  return (
    <>
      <Row label="Symbols">
        <Segments
          label="Symbols"
          value={map.military ? "military" : "plain"}
          onChange={(value) => edit(`${value} symbols`, { military: value === "military" })}
          choices={[
            ["plain", "Plain"],
            ["military", "Military"],
          ]}
        />
      </Row>
      <Row label="Trails">
        <Segments
          label="Trails"
          value={map.layers.trails ? map.trails : "off"}
          onChange={(value) =>
            edit(`trails: ${value}`, {
              layers: withLayer(map, "trails", value !== "off").layers,
              ...(value === "off" ? {} : { trails: value }),
            })
          }
          choices={[
            ["fade", "Fade"],
            ["stay", "Stay"],
            ["off", "Off"],
          ]}
        />
      </Row>
      <Row label="Names of robots">
        <Segments
          label="Names of robots"
          value={map.robotLabels}
          onChange={(robotLabels) => edit("names of robots", { robotLabels })}
          choices={[
            ["none", "None"],
            ["selected", "Selected"],
            ["all", "All"],
          ]}
        />
      </Row>
    </>
  );
}

function Places({ map, edit }: MapProps) {
  const hasProjection = usePart("scene")?.projection !== undefined;
  return (
    <>
      <Choice
        label="Places"
        value={map.notation}
        choices={kPlaceNotations}
        isDisabled={!hasProjection}
        onChange={(notation) => edit("notation of places", { notation: notation as PlaceNotation })}
      />
      {!hasProjection && <p className="small muted">The overlay does not say where it lies (ORIGIN GEO).</p>}
    </>
  );
}

function Layers({ map, edit }: MapProps) {
  const hasTiles = usePart("welcome")?.tiles !== undefined;
  return (
    <section aria-label="Layers">
      <h3>Layers</h3>
      {kLayers
        .filter(([layer]) => layer !== "trails" && (layer !== "tiles" || hasTiles))
        .map(([layer, name]) => (
          <Switch
            key={layer}
            label={name}
            value={map.layers[layer]}
            onChange={(shown) =>
              edit(`${shown ? "show" : "hide"} ${name.toLowerCase()}`, {
                layers: withLayer(map, layer, shown).layers,
              })
            }
          />
        ))}
    </section>
  );
}

function Marks({ map, edit }: MapProps) {
  return (
    <section aria-label="Marks">
      <h3>Marks</h3>
      <Switch
        label="Rings round robots"
        value={map.circleRobots}
        onChange={(circleRobots) => edit("rings round robots", { circleRobots })}
      />
      <Switch
        label="Highlight obstacles that repel"
        value={map.highlightObstacles}
        onChange={(highlightObstacles) => edit("highlighted obstacles", { highlightObstacles })}
      />
      <Switch
        label="What each schema contributes"
        value={map.contributions}
        onChange={(contributions) => edit("contributions", { contributions })}
      />
    </section>
  );
}

function CallsSwitch() {
  const { ui } = useSession();
  const isOn = useUi("calls");
  const change = (wanted: boolean) => {
    ui.set("calls", wanted);
    if (wanted) void askForCalls().then((hint) => hint && ui.tell(hint, "hold"));
  };
  return (
    <section aria-label="Questions and alerts">
      <h3>Questions and alerts</h3>
      <Switch label="Sound and desktop notification" value={isOn} onChange={change} />
    </section>
  );
}

function RobotScale() {
  const { ui } = useSession();
  const { robotScale } = usePart("map");
  const [dragged, setDragged] = useState<number | null>(null);
  const value = dragged ?? robotScale;
  return (
    <RangeSlider
      label="Size of robots"
      shown={`×${value}`}
      value={value}
      min={1}
      max={20}
      step={1}
      onChange={setDragged}
      onCommit={(next) => {
        setDragged(null);
        ui.editMap("size of robots", { robotScale: next });
      }}
    />
  );
}

function Row({ label, children }: { label: string; children: React.ReactNode }) {
  return (
    <div className="columns spread">
      <span className="label">{label}</span>
      {children}
    </div>
  );
}
