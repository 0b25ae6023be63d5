import type { Drawing, Note } from "../session/protocol.ts";
import { useDesigner } from "../session/use.ts";
import { Heading, SentText } from "./parts.tsx";

export function NoteDetails({ drawing, note }: { drawing: Drawing; note: Note }) {
  const designer = useDesigner();
  const { id, x, y, width, height, isFrame } = note;
  const page = drawing.page?.path ?? "";
  return (
    <div className="details">
      <Heading name={isFrame ? "Frame" : "Comment"} kind="on the canvas only" />
      <SentText
        label="Text"
        value={note.text}
        rows={5}
        send={(text) =>
          void designer.edit(isFrame ? "change a frame" : "change a comment", {
            case: "setNote",
            value: { page, id, text, x, y, width, height, isFrame },
          })
        }
      />
    </div>
  );
}
