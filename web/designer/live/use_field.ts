// The movement field of what is selected: read anew while time stands still, whenever what it depends on changes.
import { useEffect } from "react";
import { usePart as useSessionPart } from "../../console/session.ts";
import { type Drawing, kResult } from "../protocol.ts";
import { useDrawing, usePart } from "../use.ts";
import { drawField } from "./field_layer.ts";
import { isMoving } from "./run_button.ts";
import { useLivePage, useLiveState } from "./use_live_part.ts";

const kPause = 250; // ms after the last change

/** The selected node, where it is one that gives a movement; else empty: the page's result. */
export function fieldNode(drawing: Drawing | undefined, selection: readonly string[]): string {
  const only = selection.length === 1 ? selection[0] : undefined;
  if (only === undefined || only === kResult) return "";
  return drawing?.nodes.some((node) => node.name === only && node.type === "Vector") ? only : "";
}

/** Reads it now, over what the map shows. */
export function useReadField(): () => void {
  const live = useLivePage();
  const drawing = useDrawing();
  const selection = usePart((state) => state.selection);
  const node = fieldNode(drawing, selection);
  return () => {
    const { map } = live.store.getState();
    if (map) void live.readField(node, map.camera.visible(), map.camera.scale);
  };
}

export function useField(): void {
  const live = useLivePage();
  const drawing = useDrawing();
  const map = useLiveState((state) => state.map);
  const shows = useLiveState((state) => state.showsField);
  const field = useLiveState((state) => state.field);
  const node = fieldNode(
    drawing,
    usePart((state) => state.selection),
  );
  const page = usePart((state) => `${state.document}#${state.page}`);
  const robot = useSessionPart("selection").robots[0] ?? 0;
  const status = useSessionPart("status");
  const isStill = status !== null && !isMoving(status.mode);
  const cycle = isStill ? status.cycle : -1n;
  useEffect(() => {
    if (!shows || !map || !isStill) return;
    let timer = setTimeout(read, kPause);
    function read() {
      if (map) void live.readField(node, map.camera.visible(), map.camera.scale);
    }
    const end = map.subscribe(() => {
      clearTimeout(timer);
      timer = setTimeout(read, kPause);
    });
    return () => {
      clearTimeout(timer);
      end();
    };
  }, [live, shows, map, isStill, cycle, node, page, robot, drawing?.revision]);
  useEffect(() => {
    if (shows && map && field) return map.addLayer((pen) => drawField(pen, field));
    return undefined;
  }, [shows, map, field]);
}
