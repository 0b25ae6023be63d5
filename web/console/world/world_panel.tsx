// Obstacles and objects: add them, list them, change the selected one by numbers.
import { useMemo, useState } from "react";
import { useStore } from "zustand";
import { Button, Switch } from "../../ui/controls/controls.tsx";
import { NumberEntry } from "../../ui/controls/number_entry.tsx";
import { SelectEntry } from "../../ui/controls/select_entry.tsx";
import { count } from "../../ui/words/format.ts";
import { editMap, removeItems } from "../map_editing/edit_map.ts";
import { changeEditing, editStore } from "../map_editing/edit_store.ts";
import { nudgeOf, toolGrid } from "../map_editing/snap.ts";
import { type ListedThing, ThingList } from "../map_editing/thing_list.tsx";
import { editName, isEditable, movedTo, type ObjectStyle, type Thing, thingKey } from "../map_editing/things.ts";
import { useMayOrder, usePart, useSession, useUi } from "../session/session.ts";
import { RandomObstaclesDialog } from "./random_dialog.tsx";
import { replaceThing, thingsOf } from "./scene_things.ts";
import "../map_editing/world.css";

export const kStyleNames: readonly (readonly [ObjectStyle, string])[] = [
  ["fixed", "fixed"],
  ["movable", "movable"],
  ["container", "container"],
];

export function WorldPanel() {
  const session = useSession();
  const scene = usePart("scene");
  const selection = usePart("selection");
  const mayOrder = useMayOrder();
  const [isRandom, setRandom] = useState(false);
  const things = useMemo(() => thingsOf(scene, session.model.movedObjects), [scene, session]);
  const chosen = useMemo(() => {
    const keys = new Set(selection.items.map((item) => `${item.kind}/${item.index}`));
    return things.filter((t) => keys.has(thingKey(t)));
  }, [things, selection]);

  if (!scene) return <p className="empty">There is no map yet: open or create a mission.</p>;
  const nudge = (event: React.KeyboardEvent): boolean => {
    const { grid } = editStore.getState();
    const scale = session.ui.get("map")?.camera.scale ?? 1;
    const step = nudgeOf(event.key, event.shiftKey, grid ? toolGrid(scale) : 0, 1 / scale);
    const movable = chosen.filter(isEditable);
    if (!step || movable.length === 0 || !mayOrder) return false;
    const moved = movable.map((t) => movedTo(t, t.x + step.dx, t.y + step.dy));
    void editMap(session, editName("move", moved), moved.map(replaceThing));
    return true;
  };
  return (
    <div className="world">
      <WorldTools mayOrder={mayOrder} onRandom={() => setRandom(true)} />
      {chosen.length > 0 && <ChosenThings chosen={chosen} mayOrder={mayOrder} />}
      <section aria-label="All obstacles and objects" className="world-all">
        <h3>{summary(things)}</h3>
        <ThingList label="Obstacles and objects" things={listed(things)} onNudge={nudge} />
        <p className="help">
          Delete removes, <kbd>Alt</kbd> with arrow keys moves, Enter shows it on the map.
        </p>
      </section>
      {isRandom && <RandomObstaclesDialog onClose={() => setRandom(false)} />}
    </div>
  );
}

function WorldTools({ mayOrder, onRandom }: { mayOrder: boolean; onRandom: () => void }) {
  const { ui } = useSession();
  const tool = useUi("tool");
  const { world, grid } = useStore(editStore);
  const take = (what: "change" | "obstacle" | "object") => {
    const isHeld = tool === "world" && world === what;
    changeEditing({ world: isHeld ? "change" : what });
    ui.set("tool", isHeld && what === "change" ? "" : "world");
  };
  const choices = [
    ["change", "Move and resize", "pointer"],
    ["obstacle", "Add obstacle", "plus"],
    ["object", "Add object", "plus"],
  ] as const;
  return (
    <section aria-label="Change the world" className="rows">
      <div className="columns">
        {choices.map(([what, label, icon]) => (
          <Button
            key={what}
            icon={icon}
            tone={tool === "world" && world === what ? "primary" : "plain"}
            aria-pressed={tool === "world" && world === what}
            isDisabled={!mayOrder}
            onPress={() => take(what)}
          >
            {label}
          </Button>
        ))}
        <Button isDisabled={!mayOrder} onPress={onRandom}>
          Random obstacles…
        </Button>
      </div>
      <Switch label="Snap to the grid" value={grid} onChange={(on) => changeEditing({ grid: on })} />
      {tool === "world" && world !== "change" && <NewThing what={world} />}
    </section>
  );
}

/** What the next click adds. */
function NewThing({ what }: { what: "obstacle" | "object" }) {
  const session = useSession();
  const { radius, style, color } = useStore(editStore);
  return (
    <div className="world-fields">
      <NumberEntry
        label={what === "obstacle" ? "Radius [m]" : "Diameter [m]"}
        value={what === "obstacle" ? radius : radius * 2}
        min={0}
        whenZero="by dragging"
        onCommit={(value) => changeEditing({ radius: what === "obstacle" ? value : value / 2 })}
      />
      {what === "object" && (
        <>
          <SelectEntry
            label="Style"
            value={style}
            choices={kStyleNames}
            onChange={(s) => changeEditing({ style: s })}
          />
          <ColorEntry value={color} onCommit={(name) => changeEditing({ color: name })} />
        </>
      )}
      <Button className="wide" onPress={() => addInMiddle(session, what)}>
        Add in the middle of the map
      </Button>
      <p className="help">Click on the map to add one; drag to set its size.</p>
    </div>
  );
}

function addInMiddle(session: ReturnType<typeof useSession>, what: "obstacle" | "object"): void {
  const map = session.ui.get("map");
  const { radius, style, color, document } = editStore.getState();
  const x = Math.round(map?.camera.x ?? 0);
  const y = Math.round(map?.camera.y ?? 0);
  const size = radius > 0 ? radius : 1;
  const styles: readonly ObjectStyle[] = ["fixed", "movable", "container"];
  void editMap(
    session,
    `add ${what}`,
    [
      what === "obstacle"
        ? { change: { case: "addObstacle", value: { x, y, radius: size } } }
        : { change: { case: "addObject", value: { x, y, diameter: 2 * size, style: styles.indexOf(style), color } } },
    ],
    document,
  );
}

function ChosenThings({ chosen, mayOrder }: { chosen: readonly Thing[]; mayOrder: boolean }) {
  const session = useSession();
  const [only] = chosen;
  const remove = (
    <Button
      className="danger-quiet"
      isDisabled={!mayOrder || !chosen.some(isEditable)}
      onPress={() =>
        void removeItems(
          session,
          chosen.map((t) => ({ kind: t.type, index: t.index })),
        )
      }
    >
      Remove
    </Button>
  );
  if (chosen.length > 1 || !only) {
    return (
      <section aria-label="Selected things" className="world-chosen">
        <h3>{count(chosen.length, "thing")} selected</h3>
        {remove}
      </section>
    );
  }
  const isLocked = !mayOrder || !isEditable(only);
  const set = (verb: string, thing: Thing) => void editMap(session, editName(verb, [thing]), [replaceThing(thing)]);
  return (
    <section aria-label="Selected thing" className="world-chosen">
      <h3>
        {only.type === "obstacle" ? "Obstacle" : "Object"} {only.index + 1}
      </h3>
      {!isEditable(only) && (
        <p className="notice">It comes from CREATE-OBSTACLES or the environment, not from an overlay.</p>
      )}
      <div className="world-fields">
        <NumberEntry label="x [m]" value={only.x} isDisabled={isLocked} onCommit={(x) => set("move", { ...only, x })} />
        <NumberEntry label="y [m]" value={only.y} isDisabled={isLocked} onCommit={(y) => set("move", { ...only, y })} />
        {only.type === "obstacle" ? (
          <NumberEntry
            label="Radius [m]"
            value={only.radius}
            min={0.001}
            isDisabled={isLocked}
            onCommit={(radius) => set("resize", { ...only, radius })}
          />
        ) : (
          <>
            <NumberEntry
              label="Diameter [m]"
              value={only.diameter}
              min={0.001}
              isDisabled={isLocked}
              onCommit={(diameter) => set("resize", { ...only, diameter })}
            />
            <SelectEntry
              label="Style"
              value={only.style}
              choices={kStyleNames}
              isDisabled={isLocked}
              onChange={(style) => set("change", { ...only, style })}
            />
            <ColorEntry
              value={only.color}
              isDisabled={isLocked}
              onCommit={(color) => set("paint", { ...only, color })}
            />
          </>
        )}
      </div>
      {remove}
    </section>
  );
}

const kColors = [
  "orange",
  "green",
  "purple",
  "red",
  "blue",
  "yellow",
  "white",
  "black",
  "brown",
  "gray",
  "cyan",
  "pink",
];

function ColorEntry(props: { value: string; onCommit: (color: string) => void; isDisabled?: boolean }) {
  const { value, onCommit, isDisabled = false } = props;
  const known = kColors.includes(value.toLowerCase()) ? kColors : [value, ...kColors];
  return (
    <SelectEntry
      label="Colour"
      value={kColors.find((c) => c === value.toLowerCase()) ?? value}
      choices={known.map((c) => [c, c] as const)}
      isDisabled={isDisabled}
      onChange={onCommit}
    />
  );
}

function listed(things: readonly Thing[]): ListedThing[] {
  return things.map((t) => ({
    item: { kind: t.type, index: t.index },
    title: t.type === "obstacle" ? `Obstacle ${t.index + 1}` : `Object ${t.index + 1}, ${t.color}`,
    detail: `${round(t.x)}, ${round(t.y)}; ${t.type === "obstacle" ? `r ${round(t.radius)} m` : `⌀ ${round(t.diameter)} m`}${isEditable(t) ? "" : "; fixed"}`,
    isEditable: isEditable(t),
  }));
}

function summary(things: readonly Thing[]): string {
  const obstacles = things.filter((t) => t.type === "obstacle").length;
  return `${count(obstacles, "obstacle")}, ${count(things.length - obstacles, "object")}`;
}

function round(value: number): number {
  return Math.round(value * 10) / 10;
}
