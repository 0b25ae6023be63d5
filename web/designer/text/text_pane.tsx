// The same document as text, beside the drawing: either can be edited, the other follows.
import { type Diagnostic, setDiagnostics } from "@codemirror/lint";
import { Compartment, EditorState } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { useEffect, useRef } from "react";
import { bytesOf } from "../../ui/text/bytes.ts";
import { kFromServer } from "../../ui/text/live_editor.ts";
import { applyFix } from "../problems/apply_fix.ts";
import { AskLanguage_What, type Document } from "../session/protocol.ts";
import { useDesigner, useDocument, usePart } from "../session/use.ts";
import { type LiveText, liveText } from "./live_text.ts";
import { editorParts } from "./setup.ts";
import "../../ui/text/editor.css";

export default function TextPane() {
  const document = useDocument();
  if (!document) return null;
  return <Editor key={document.path} document={document} />;
}

const readOnly = new Compartment();

function Editor({ document }: { document: Document }) {
  const designer = useDesigner();
  const host = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const live = liveText(designer, document);
  const reveal = usePart((state) => state.reveal);
  const isReadOnly = document.isReadOnly;
  useEffect(() => {
    let asking: ReturnType<typeof setTimeout> | undefined;
    const editor = new EditorView({
      parent: host.current!,
      state: EditorState.create({
        doc: live.text,
        extensions: [
          editorParts(designer, live, document.path),
          readOnly.of([EditorState.readOnly.of(isReadOnly)]),
          EditorView.updateListener.of((update) => {
            if (update.docChanged && !update.transactions.some((one) => one.annotation(kFromServer))) {
              for (const one of update.transactions) if (one.docChanged) live.typed(one.changes);
            }
            if (!update.selectionSet || update.docChanged || !update.view.hasFocus) return;
            clearTimeout(asking);
            asking = setTimeout(() => void showNode(designer, live, document.path, update.view), 200);
          }),
        ],
      }),
    });
    view.current = editor;
    live.view = editor;
    return () => {
      clearTimeout(asking);
      live.view = null;
      view.current = null;
      editor.destroy();
    };
  }, [designer, live, document.path, isReadOnly]);
  useEffect(() => {
    if (view.current) mark(designer, view.current, live);
  }, [designer, document, live]);
  useEffect(() => {
    const editor = view.current;
    if (!editor || !reveal) return;
    const anchor = live.placeOf(reveal.begin);
    const head = live.placeOf(reveal.end);
    editor.dispatch({
      selection: { anchor, head },
      effects: EditorView.scrollIntoView(anchor, { y: "center" }),
    });
    if (reveal.focus) editor.focus();
  }, [reveal, live]);
  useSelectionShown(view, live);
  usePageShown(view, live, document.path);
  return <div ref={host} className="editor-text" />;
}

/** What is selected on the canvas is scrolled to in the text. */
function useSelectionShown(view: { current: EditorView | null }, live: LiveText): void {
  const selection = usePart((state) => state.selection);
  const designer = useDesigner();
  useEffect(() => {
    const editor = view.current;
    const { drawing } = designer;
    if (!editor || editor.hasFocus || selection.length !== 1 || !drawing || live.isAhead) return;
    const item =
      drawing.nodes.find((one) => one.name === selection[0]) ??
      drawing.states.find((one) => one.name === selection[0]) ??
      drawing.transitions.find((one) => `${one.from}/${one.index}` === selection[0]);
    if (!item || item.end <= item.begin) return;
    const anchor = live.placeOf(item.begin);
    editor.dispatch({
      selection: { anchor, head: live.placeOf(item.end) },
      effects: EditorView.scrollIntoView(anchor, { y: "center" }),
    });
  }, [selection, designer, view, live]);
}

/** A page that opens brings its declaration to the top, unless somebody writes in the text. */
function usePageShown(view: { current: EditorView | null }, live: LiveText, path: string): void {
  const page = usePart((state) => (state.document === path ? state.page : ""));
  const designer = useDesigner();
  const isKnown = usePart((state) => state.documents[path] !== undefined);
  useEffect(() => {
    const editor = view.current;
    const name = page.split(".")[0];
    const shown = designer.state.documents[path]?.declarations.find((one) => one.name === name);
    if (!editor || !isKnown || editor.hasFocus || !shown || live.isAhead) return;
    editor.dispatch({ effects: EditorView.scrollIntoView(live.placeOf(shown.begin), { y: "start", yMargin: 8 }) });
  }, [page, path, isKnown, designer, view, live]);
}

/** Where the cursor is in the text, the canvas selects. */
async function showNode(
  designer: ReturnType<typeof useDesigner>,
  live: LiveText,
  document: string,
  view: EditorView,
): Promise<void> {
  if (live.isAhead) return;
  const cursor = bytesOf(view.state.doc.toString(), view.state.selection.main.head);
  const answer = await designer.link.ask({
    case: "askLanguage",
    value: { document, what: AskLanguage_What.PAGE, cursor },
  });
  if (answer.result.case !== "location" || !view.hasFocus) return;
  const { page, node } = answer.result.value;
  if (page === designer.state.page) designer.select(node ? [node] : []);
}

function mark(designer: ReturnType<typeof useDesigner>, editor: EditorView, live: LiveText): void {
  const length = editor.state.doc.length;
  const diagnostics = live.marks().map(
    (one): Diagnostic => ({
      from: Math.min(one.from, length),
      to: Math.min(Math.max(one.to, one.from), length),
      severity: one.isWarning ? "warning" : "error",
      message: one.message,
      actions: one.fixes.map((fix) => ({ name: fix.title, apply: () => void applyFix(designer, fix) })),
    }),
  );
  editor.dispatch(setDiagnostics(editor.state, diagnostics));
}
