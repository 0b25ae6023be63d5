// The editor of missions and overlays, and of texts that are only read.
import { EditorState, type Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { Complete_Language } from "../../core/protocol.ts";
import { bytesOf } from "../../ui/text/bytes.ts";
import { cdl } from "../../ui/text/cdl.ts";
import { nameKeys, wordAtCursor } from "../../ui/text/name_keys.ts";
import { textEditorParts } from "../../ui/text/parts.ts";
import type { Session } from "../session/session.ts";
import { mdl, odl } from "./languages.ts";
import { askForName, showUses, type TextCursor, toDefinition } from "./names.ts";

export function editorParts(session: Session, language: Complete_Language): Extension[] {
  return textEditorParts({
    language: language === Complete_Language.OVERLAY ? odl() : mdl(),
    letter: /[\w-]/,
    complete: async (text, cursor) => {
      const { result } = await session.connection.ask({ case: "complete", value: { language, text, cursor } });
      return result.case === "completions" ? result.value : undefined;
    },
  });
}

/** @param settle  sends what was typed */
export function cursorOf(document: string, view: EditorView, settle: () => Promise<void>): TextCursor {
  return {
    document,
    settle,
    place: () => {
      // Of `PP-Far` the name is what stands behind.
      const { word, end } = wordAtCursor(view);
      return { cursor: bytesOf(view.state.doc.toString(), end), word };
    },
  };
}

/** Keys for the name at the cursor. */
export function nameParts(session: Session, document: string, settle: () => Promise<void>): Extension {
  const ask = (question: typeof toDefinition) => (view: EditorView) =>
    void question(session, cursorOf(document, view, settle));
  return nameKeys({ toDefinition: ask(toDefinition), uses: ask(showUses), rename: ask(askForName) });
}

export function readOnlyParts(session: Session, path: string): Extension[] {
  const isMission = path.endsWith(".mdl");
  const isOverlay = path.endsWith(".odl") || path.endsWith(".ovl");
  return [
    ...textEditorParts({
      language: isMission ? mdl() : isOverlay ? odl() : cdl(),
      letter: /\w/,
      complete: async () => undefined,
    }),
    nameParts(session, path, async () => {}),
    EditorState.readOnly.of(true),
    EditorView.contentAttributes.of({ "aria-label": `Text of ${path}, read only`, tabindex: "0" }),
  ];
}

/** Selects a stretch, in the middle of what is seen, and goes there. */
export function show(view: EditorView, from: number, to: number): void {
  const { length } = view.state.doc;
  const anchor = Math.min(from, length);
  view.dispatch({
    selection: { anchor, head: Math.min(to, length) },
    effects: EditorView.scrollIntoView(anchor, { y: "center" }),
  });
  view.focus();
}
