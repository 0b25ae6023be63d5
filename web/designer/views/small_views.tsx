// What stands on the canvas beside nodes: where the page's value goes, comments, frames.
import { Handle, type NodeProps, NodeResizer, Position } from "@xyflow/react";
import { memo, useEffect, useRef, useState } from "react";
import { flowOf } from "../../core/value_types.ts";
import type { CanvasNode } from "../drawing/flow.ts";
import { kResult } from "../session/protocol.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { canvasStore, useCanvas } from "../sight/canvas_store.ts";

type ResultProps = NodeProps<Extract<CanvasNode, { type?: "result" }>>;
type NoteProps = NodeProps<Extract<CanvasNode, { type?: "note" }>>;

export const ResultView = memo(function ResultView({ data }: ResultProps) {
  const fit = useCanvas((state) => state.fits?.get(kResult));
  const state = fit === undefined ? "" : fit === "" ? "fits" : "refused";
  return (
    <div className={`result ${state} ${data.isFed ? "" : "open"}`}>
      <Handle type="target" id="value" position={Position.Left} className={`port flow-${flowOf(data.type)}`} />
      <span className="result-name">Result</span>
      <span className="node-kind">{data.type || "any type"}</span>
    </div>
  );
});

export const NoteView = memo(function NoteView({ id, data, selected }: NoteProps) {
  const { note, isReadOnly } = data;
  const designer = useDesigner();
  const page = usePart((state) => state.page);
  const [typed, setTyped] = useState<string | null>(null);
  const isNew = useCanvas((state) => state.writing === id);
  useEffect(() => {
    if (!isNew) return;
    canvasStore.setState({ writing: "" });
    setTyped(note.text);
  }, [isNew, note.text]);
  const send = (change: { text?: string; x?: number; y?: number; width?: number; height?: number }) =>
    void designer.edit(note.isFrame ? "change a frame" : "change a comment", {
      case: "setNote",
      value: {
        page,
        id,
        text: note.text,
        x: note.x,
        y: note.y,
        width: note.width,
        height: note.height,
        isFrame: note.isFrame,
        ...change,
      },
    });
  const isTaken = useRef(false); // by Escape; a field that goes is left as well
  const commit = () => {
    if (typed !== null && typed !== note.text && !isTaken.current) send({ text: typed });
    setTyped(null);
  };
  return (
    <div className={`${note.isFrame ? "frame" : "note"} ${selected ? "selected" : ""}`}>
      <NodeResizer
        isVisible={(selected ?? false) && !isReadOnly}
        minWidth={96}
        minHeight={48}
        onResizeEnd={(_, { x, y, width, height }) => send({ x, y, width, height })}
      />
      {typed === null ? (
        // biome-ignore lint/a11y/noStaticElementInteractions: F2 does the same on the selected note
        <div className="note-text" onDoubleClick={() => !isReadOnly && setTyped(note.text)}>
          {note.text || (note.isFrame ? "Frame" : "Comment")}
        </div>
      ) : (
        <textarea
          className="note-text nodrag nowheel"
          aria-label="Text of the comment"
          // biome-ignore lint/a11y/noAutofocus: somebody has just asked to type in it
          autoFocus
          value={typed}
          onFocus={(event) => {
            isTaken.current = false;
            event.currentTarget.select();
          }}
          onChange={(event) => setTyped(event.target.value)}
          onBlur={commit}
          onKeyDown={(event) => {
            if (event.key === "Escape") {
              isTaken.current = true;
              setTyped(null);
            }
            if (event.key === "Enter" && (event.ctrlKey || note.isFrame)) commit();
            event.stopPropagation();
          }}
        />
      )}
    </div>
  );
});
