// What the drawing tool waits for, over the map while it is held.
import { useStore } from "zustand";
import { kindInfo } from "../../core/measure_kinds.ts";
import { editStore } from "../map_editing/edit_store.ts";
import { emptyDraft, guidance } from "./draft.ts";
import { drawingStore } from "./drawing_store.ts";

export function DrawOptions() {
  const { kind } = useStore(editStore);
  const { draft } = useStore(drawingStore);
  if (!kind) {
    return (
      <span className="small">
        Choose what to draw in the panel, or click what stands to change it; a double click takes a corner out.
      </span>
    );
  }
  return (
    <span className="small">
      <b>{kindInfo(kind).label}.</b> {guidance(draft ?? emptyDraft(kind))}
    </span>
  );
}
