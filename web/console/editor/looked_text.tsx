// A text that is none of the mission's: a configuration that it names, another mission, one of the library. To be read.
import { EditorState } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { useEffect, useRef } from "react";
import { Button } from "../../ui/controls/controls.tsx";
import { unitsOf } from "../../ui/text/bytes.ts";
import { usePart, useSession, useUi } from "../session/session.ts";
import type { LookedText as Looked } from "../session/ui.ts";
import { NameMenu } from "./name_menu.tsx";
import { look, tellCursor } from "./names.ts";
import { cursorOf, readOnlyParts, show } from "./setup.ts";

export function LookedTools({ path }: { path: string }) {
  const { ui } = useSession();
  const isLibrary = path.startsWith("library:");
  return (
    <div className="columns" style={{ flexWrap: "nowrap" }}>
      <span className="pill">{isLibrary ? "Of the library: read only" : "Not of this mission: read only"}</span>
      <NameMenu />
      <Button
        onPress={() =>
          ui.set(
            "looked",
            ui.get("looked").filter((one) => one.path !== path),
          )
        }
      >
        Close
      </Button>
    </div>
  );
}

export function LookedText({ path, text }: Looked) {
  const session = useSession();
  const host = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const reveal = useUi("reveal");
  const edits = usePart("edits");
  useEffect(() => {
    const editor = new EditorView({
      parent: host.current as HTMLElement,
      state: EditorState.create({ doc: text, extensions: readOnlyParts(session, path) }),
    });
    view.current = editor;
    const forget = tellCursor(
      session,
      cursorOf(path, editor, async () => {}),
    );
    return () => {
      forget();
      view.current = null;
      editor.destroy();
    };
  }, [path, text, session]);
  useEffect(() => {
    if (!view.current || reveal?.document !== path || !reveal.span) return;
    show(view.current, unitsOf(text, reveal.span.begin), unitsOf(text, reveal.span.end));
  }, [reveal, path, text]);
  // A renaming changes it, and so does taking that back.
  const newest = `${edits?.undoNumber ?? 0} ${edits?.redoNumber ?? 0}`;
  useEffect(() => {
    if (newest) void look(session, path);
  }, [newest, session, path]);
  return <div ref={host} className="editor-text" />;
}
