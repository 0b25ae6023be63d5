// The map beside the canvas: the console's, with the tools that are needed here.
import { useEffect, useRef } from "react";
import { usePart as useSessionPart } from "../../console/session/session.ts";
import { keepFitted } from "../../core/map/keep_fitted.ts";
import { MapView } from "../../core/map/map_view.ts";
import { IconButton } from "../../ui/controls/controls.tsx";
import { kFieldKey } from "../run/keys.ts";
import { isMoving } from "../run/run_button.ts";
import { situationOf } from "../run/situation.ts";
import { StartsTool } from "./starts_tool.ts";
import { useField } from "./use_field.ts";
import { useLivePage, useLiveState } from "./use_live_part.ts";

export function MapHost() {
  const live = useLivePage();
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = host.current;
    if (!element) return;
    const map = new MapView(element, live.model, { pictureUrl: (path) => live.connection.url(path) });
    live.store.setState({ map });
    const endFitting = keepFitted(map, live.model);
    return () => {
      endFitting();
      live.store.setState({ map: null, isPlacing: false });
      map.dispose();
    };
  }, [live]);
  useTheme();
  useStartsTool();
  useField();
  return (
    <div className="sim-map">
      <div
        ref={host}
        className="map"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: arrow keys move the map
        tabIndex={0}
        role="application"
        aria-label="Map. Arrow keys move it."
        onKeyDown={(event) => event.stopPropagation()}
      />
      <MapTools />
    </div>
  );
}

function MapTools() {
  const live = useLivePage();
  const map = useLiveState((state) => state.map);
  const isPlacing = useLiveState((state) => state.isPlacing);
  const shows = useLiveState((state) => state.showsField);
  const robot = useSessionPart("selection").robots[0];
  return (
    <div className="map-tools" role="toolbar" aria-label="Map tools" aria-orientation="vertical">
      <IconButton
        icon="draw"
        label="Set where robots start"
        pressed={isPlacing}
        onPress={() => live.store.setState({ isPlacing: !isPlacing })}
      />
      <IconButton
        icon="command"
        label="Movement field of the selection"
        shortcut={kFieldKey.toUpperCase()}
        pressed={shows}
        onPress={() => live.store.setState({ showsField: !shows, field: null, fieldError: "" })}
      />
      <hr />
      <IconButton icon="fit" label="Fit the whole map" onPress={() => map?.framing.fit()} />
      <IconButton icon="plus" label="Zoom in on the map" onPress={() => map?.framing.zoom(Math.SQRT2)} />
      <IconButton icon="minus" label="Zoom out of the map" onPress={() => map?.framing.zoom(Math.SQRT1_2)} />
      <IconButton
        icon="follow"
        label="Follow the robot"
        isDisabled={robot === undefined}
        onPress={() => robot !== undefined && map?.framing.follow({ robot })}
      />
    </div>
  );
}

/** As the page has it. */
function useTheme(): void {
  const live = useLivePage();
  useEffect(() => {
    const root = document.documentElement;
    const apply = () => live.model.updateMap({ theme: root.dataset.theme === "dark" ? "dark" : "light" });
    apply();
    const observer = new MutationObserver(apply);
    observer.observe(root, { attributeFilter: ["data-theme"] });
    return () => observer.disconnect();
  }, [live]);
}

/** While places are set; what is set is shown at once by a trial that does not run yet. */
function useStartsTool(): void {
  const live = useLivePage();
  const map = useLiveState((state) => state.map);
  const isPlacing = useLiveState((state) => state.isPlacing);
  useEffect(() => {
    if (!map) return;
    if (!isPlacing) {
      map.useTool(null);
      return;
    }
    map.useTool(
      new StartsTool({
        get: () => live.store.getState().starts,
        set: (starts) => {
          const robots = Math.max(live.store.getState().robots, Math.min(starts.length, 100));
          live.store.setState({ starts, robots });
        },
        done: () => {
          if (!isMoving(situationOf(live).mode)) void live.trials.tryOut(false);
        },
      }),
    );
    return map.subscribe(() => {
      if (map.tool.name !== "starts") live.store.setState({ isPlacing: false });
    });
  }, [map, isPlacing, live]);
}
