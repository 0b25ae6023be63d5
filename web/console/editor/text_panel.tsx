// The mission's texts: edited in place, checked by the server as you type, saved.
import { setDiagnostics } from "@codemirror/lint";
import { Compartment, EditorState } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { useEffect, useRef, useState } from "react";
import { Tab, TabList, TabPanel, Tabs } from "react-aria-components";
import { Control_Action, type Documents_Document } from "../../core/protocol.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { nameOf } from "../../ui/files/paths.ts";
import { kFromServer } from "../../ui/text/live_editor.ts";
import { count } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { order, save } from "../session/orders.ts";
import { useMayOrder, usePart, useSession, useUi } from "../session/session.ts";
import { type LiveDocument, liveDocuments } from "./live_document.ts";
import { LookedText, LookedTools } from "./looked_text.tsx";
import { NameMenu } from "./name_menu.tsx";
import { tellCursor } from "./names.ts";
import { cursorOf, editorParts, nameParts, show } from "./setup.ts";
import { stepAtLine } from "./step_at.ts";
import { UsesBelow } from "./uses_below.tsx";
import "../../ui/text/editor.css";

export default function TextPanel() {
  const { ui } = useSession();
  const documents = usePart("documents")?.documents ?? [];
  const looked = useUi("looked").filter(({ path }) => !documents.some((one) => one.path === path));
  const chosen = useUi("document");
  const [line, setLine] = useState(1);
  const read = looked.find((one) => one.path === chosen);
  const document = documents.find((one) => one.path === chosen) ?? documents[0];
  if (!document) return <p className="empty">No mission is open.</p>;
  const shown = read?.path ?? document.path;
  return (
    <Tabs className="editor" selectedKey={shown} onSelectionChange={(key) => ui.set("document", String(key))}>
      <div className="editor-bar">
        <TabList className="editor-tabs" aria-label="Texts of the mission">
          {documents.map((one) => (
            <Tab key={one.path} id={one.path} className="tab editor-tab">
              {nameOf(one.path)}
              {one.isDirty && <span className="unsaved" role="img" aria-label="not saved" />}
              <ErrorCount document={one} />
            </Tab>
          ))}
          {looked.map(({ path }) => (
            <Tab key={path} id={path} className="tab editor-tab">
              <Icon name="lock" />
              {nameOf(path)}
            </Tab>
          ))}
        </TabList>
        <span className="grow" />
        {read ? <LookedTools path={read.path} /> : <Tools document={document} line={line} />}
      </div>
      <TabPanel id={shown} className="editor-panel">
        {read ? (
          <LookedText key={read.path} {...read} />
        ) : (
          <>
            <Problems document={document} />
            <Editor key={document.path} document={document} onLine={setLine} />
          </>
        )}
        <UsesBelow />
      </TabPanel>
    </Tabs>
  );
}

function ErrorCount({ document }: { document: Documents_Document }) {
  const errors = document.diagnostics.filter((diagnostic) => !diagnostic.isWarning).length;
  if (errors === 0) return null;
  return (
    <span className="badge" role="img" aria-label={count(errors, "error")}>
      {errors}
    </span>
  );
}

function Tools({ document, line }: { document: Documents_Document; line: number }) {
  const session = useSession();
  const mayOrder = useMayOrder();
  const plan = usePart("plan");
  const edits = usePart("edits");
  const step = stepAtLine(plan, document.path, line);
  const label = step === undefined ? "" : (plan?.steps[step]?.label ?? "");
  return (
    <div className="columns" style={{ flexWrap: "nowrap" }}>
      {step !== undefined && (
        <Button icon="play" isDisabled={!mayOrder} onPress={() => void continueFrom(session, step)}>
          Continue from step {label}
        </Button>
      )}
      {document.isReadOnly && <span className="pill">Example: saved as a copy</span>}
      <NameMenu />
      <Button icon="save" isDisabled={!mayOrder || !edits?.isDirty} onPress={() => save(session)}>
        Save
      </Button>
      <Button
        isDisabled={!mayOrder}
        onPress={() => {
          session.ui.set("document", document.path);
          session.ui.set("dialog", "save-as");
        }}
      >
        Save as…
      </Button>
    </div>
  );
}

async function continueFrom(session: ReturnType<typeof useSession>, step: number): Promise<void> {
  const jumped = await order(session, { case: "control", value: { action: Control_Action.JUMP, step } });
  if (jumped.ok) void order(session, { case: "control", value: { action: Control_Action.EXECUTE } });
}

function Problems({ document }: { document: Documents_Document }) {
  const { ui } = useSession();
  if (document.diagnostics.length === 0) return null;
  const shown = [...document.diagnostics].sort((a, b) => Number(a.isWarning) - Number(b.isWarning)).slice(0, 50);
  return (
    <ul className="problems" aria-label="Problems">
      {shown.map((diagnostic) => (
        <li key={`${diagnostic.begin} ${diagnostic.message}`} className={diagnostic.isWarning ? "warning" : "error"}>
          <Icon name="warning" />
          <Button tone="link" onPress={() => ui.set("reveal", { document: document.path, line: diagnostic.line })}>
            <span className="number">{diagnostic.line > 0 ? `Line ${diagnostic.line}: ` : ""}</span>
            {sentence(diagnostic.message)}
          </Button>
          <span className="muted small">{diagnostic.hints.map((hint) => sentence(hint)).join(" ")}</span>
        </li>
      ))}
    </ul>
  );
}

function Editor({ document, onLine }: { document: Documents_Document; onLine: (line: number) => void }) {
  const session = useSession();
  const mayOrder = useMayOrder();
  const reveal = useUi("reveal");
  const host = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const readOnly = useRef(new Compartment());
  const live = liveDocuments(session).of(document);
  useEffect(() => {
    const editor = new EditorView({
      parent: host.current as HTMLElement,
      state: EditorState.create({
        doc: live.text,
        extensions: [
          ...editorParts(session, document.language),
          nameParts(session, document.path, () => live.flush()),
          readOnly.current.of(EditorState.readOnly.of(!mayOrder)),
          EditorView.contentAttributes.of({ "aria-label": `Text of ${document.path}`, tabindex: "0" }),
          EditorView.updateListener.of((update) => {
            const isOwn = !update.transactions.some((transaction) => transaction.annotation(kFromServer));
            if (update.docChanged && isOwn) live.typed(update.changes);
            if (update.selectionSet || update.docChanged)
              onLine(update.state.doc.lineAt(update.state.selection.main.head).number);
          }),
        ],
      }),
    });
    view.current = editor;
    live.view = editor;
    mark(editor, live);
    const forget = tellCursor(
      session,
      cursorOf(document.path, editor, () => live.flush()),
    );
    return () => {
      forget();
      void live.flush();
      live.view = null;
      view.current = null;
      editor.destroy();
    };
  }, [live, session]);
  useEffect(() => {
    view.current?.dispatch({ effects: readOnly.current.reconfigure(EditorState.readOnly.of(!mayOrder)) });
  }, [mayOrder]);
  useEffect(() => {
    if (view.current) mark(view.current, live);
  }, [document, live]);
  useEffect(() => {
    const editor = view.current;
    if (!editor || !reveal || reveal.document !== document.path || reveal.line < 1) return;
    if (reveal.span) return show(editor, live.placeOf(reveal.span.begin), live.placeOf(reveal.span.end));
    const { from } = editor.state.doc.line(Math.min(reveal.line, editor.state.doc.lines));
    editor.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: "center" }) });
    editor.focus();
  }, [reveal, document.path, live]);
  return <div ref={host} className="editor-text" />;
}

function mark(editor: EditorView, live: LiveDocument): void {
  const length = editor.state.doc.length;
  const diagnostics = live.marks().map((one) => ({
    from: Math.min(one.from, length),
    to: Math.min(Math.max(one.to, one.from), length),
    severity: one.isWarning ? ("warning" as const) : ("error" as const),
    message: one.message,
  }));
  editor.dispatch(setDiagnostics(editor.state, diagnostics));
}
