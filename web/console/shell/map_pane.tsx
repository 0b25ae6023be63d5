// The map with its tools, and the options of the one that is held.
import { useEffect, useRef, useSyncExternalStore } from "react";
import { coveredPlaces, keepFitted } from "../../core/map/keep_fitted.ts";
import { MapView } from "../../core/map/map_view.ts";
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { tools } from "../extensions/extensions.ts";
import { useIsElsewhen, useMayOrder, usePart, useSession, useUi } from "../session/session.ts";
import { forgetView, restoreView } from "./view_memory.ts";

export function MapPane() {
  return (
    <>
      <MapHost />
      <MapTools />
      <Following />
    </>
  );
}

function MapHost() {
  const session = useSession();
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = host.current;
    if (!element) return;
    const map = new MapView(element, session.model, {
      pictureUrl: (path) => session.connection.url(path),
      covered: () => coveredPlaces(element),
    });
    restoreView(session, map, window.sessionStorage);
    session.ui.set("map", map);
    const endFitting = keepFitted(map, session.model);
    return () => {
      endFitting();
      forgetView(map);
      session.ui.set("map", null);
      map.dispose();
    };
  }, [session]);
  useTool();
  return (
    <div
      ref={host}
      className="map"
      // biome-ignore lint/a11y/noNoninteractiveTabindex: arrow keys move the map
      tabIndex={0}
      role="application"
      aria-label="Map. Arrow keys move it; the Robots panel lists everything that is on it."
    />
  );
}

/** Hands the chosen tool to the map, and takes back what the map gave up. */
function useTool(): void {
  const session = useSession();
  const map = useUi("map");
  const id = useUi("tool");
  const isElsewhen = useIsElsewhen();
  useEffect(() => {
    // Nothing is ordered or changed there.
    if (isElsewhen && tools.some((one) => one.id === id && one.forOperator)) session.ui.set("tool", "");
  }, [isElsewhen, id, session]);
  useEffect(() => {
    if (!map) return;
    const tool = tools.find((one) => one.id === id);
    map.useTool(tool ? tool.make(session) : null);
  }, [map, id, session]);
  useEffect(
    () =>
      map?.subscribe(() => {
        if (map.tool.name === "select" && session.ui.get("tool") !== "") session.ui.set("tool", "");
      }),
    [map, session],
  );
}

function MapTools() {
  const { ui, model } = useSession();
  const map = useUi("map");
  const tool = useUi("tool");
  const mayOrder = useMayOrder();
  const isElsewhen = useIsElsewhen();
  const hasSelection = usePart("selection").robots.length > 0;
  return (
    <div className="map-tools" role="toolbar" aria-label="Map tools" aria-orientation="vertical">
      <IconButton icon="pointer" label="Select" shortcut="S" pressed={tool === ""} onPress={() => ui.set("tool", "")} />
      {tools
        .filter((one) => !one.hidden)
        .map((one) => (
          <IconButton
            key={one.id}
            icon={one.icon}
            label={
              one.forOperator && !mayOrder
                ? `${one.label} (${isElsewhen ? "not while another moment is shown" : "operator only"})`
                : one.label
            }
            {...(one.shortcut ? { shortcut: shownShortcut(one.shortcut) } : {})}
            pressed={tool === one.id}
            isDisabled={one.forOperator === true && !mayOrder}
            onPress={() => ui.set("tool", tool === one.id ? "" : one.id)}
          />
        ))}
      <hr />
      <IconButton icon="fit" label="Fit the whole map" shortcut="F" onPress={() => map?.framing.fit()} />
      <IconButton icon="plus" label="Zoom in" onPress={() => map?.framing.zoom(Math.SQRT2)} />
      <IconButton icon="minus" label="Zoom out" onPress={() => map?.framing.zoom(Math.SQRT1_2)} />
      <IconButton
        icon="follow"
        label="Follow the selection"
        shortcut={shownShortcut("shift+f")}
        isDisabled={!hasSelection}
        onPress={() => {
          const { robots, unit } = model.get("selection");
          if (unit) map?.framing.follow({ unit });
          else if (robots[0] !== undefined) map?.framing.follow({ robot: robots[0] });
        }}
      />
    </div>
  );
}

export function ToolOptions() {
  const { ui } = useSession();
  const held = useUi("tool");
  const tool = tools.find((one) => one.id === held);
  if (!tool) return null;
  const Options = tool.options;
  return (
    <section className="tool-options" aria-label={tool.label}>
      <strong>{tool.label}</strong>
      {Options && <Options />}
      <Button tone="quiet" icon="close" aria-label="Put the tool away" onPress={() => ui.set("tool", "")} />
    </section>
  );
}

function Following() {
  const { model } = useSession();
  const map = useUi("map");
  const followed = useSyncExternalStore(
    (listener) => map?.subscribe(listener) ?? (() => {}),
    () => map?.framing.following ?? null,
  );
  if (!followed) return null;
  const name = "robot" in followed ? model.get("roster").nameOf(followed.robot) : followed.unit;
  return (
    <div className="following">
      <span>Following {name}</span>
      <IconButton icon="close" label="Stop following" onPress={() => map?.framing.follow(null)} />
    </div>
  );
}
