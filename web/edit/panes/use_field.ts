// The movement field of what is selected: read when it is switched on, and anew whenever what it depends on changes; while
// robots move, again and again.
import { useEffect } from "react";
import { usePart as useSessionPart } from "../../console/session/session.ts";
import { type Drawing, kResult } from "../../designer/session/protocol.ts";
import { useDrawing, usePart } from "../../designer/session/use.ts";
import { isMoving } from "../run/run_button.ts";
import { drawField } from "./field_layer.ts";
import { useLivePage, useLiveState } from "./use_live_part.ts";

const kPause = 250; // ms after the last change
const kRepeat = 1000; // ms between two readings while robots move

/** The selected node, where it is one that gives a movement; else empty: the page's result. */
export function fieldNode(drawing: Drawing | undefined, selection: readonly string[]): string {
  const only = selection.length === 1 ? selection[0] : undefined;
  if (only === undefined || only === kResult) return "";
  return drawing?.nodes.some((node) => node.name === only && node.type === "Vector") ? only : "";
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
  const isStill = status === null || !isMoving(status.mode);
  const cycle = isStill ? (status?.cycle ?? -1n) : -1n;
  const hasRun = useSessionPart("scene") !== null;
  useEffect(() => {
    if (!shows || !map || !hasRun) return;
    let timer: ReturnType<typeof setTimeout> | undefined;
    let isLeft = false;
    // One at a time: the next is asked for when this one is there.
    const read = async () => {
      await live.field.read(node, map.camera.visible(), map.camera.scale);
      if (isStill || isLeft) return;
      clearTimeout(timer);
      timer = setTimeout(read, kRepeat);
    };
    void read();
    const end = map.subscribe(() => {
      clearTimeout(timer);
      timer = setTimeout(read, kPause);
    });
    return () => {
      isLeft = true;
      clearTimeout(timer);
      end();
    };
  }, [live, shows, map, hasRun, isStill, cycle, node, page, robot, drawing?.revision]);
  useEffect(() => {
    if (shows && map && field) return map.addLayer((pen) => drawField(pen, field));
    return undefined;
  }, [shows, map, field]);
}
