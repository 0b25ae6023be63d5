// The editor's parts: colours, completion by the server, marks, keys.
import {
  autocompletion,
  type CompletionContext,
  type CompletionResult,
  closeBrackets,
  completionKeymap,
} from "@codemirror/autocomplete";
import { defaultKeymap, indentWithTab, toggleComment } from "@codemirror/commands";
import { bracketMatching, HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import { lintGutter, lintKeymap } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { EditorState, type Extension } from "@codemirror/state";
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { Complete_Language } from "../../core/protocol.ts";
import type { Session } from "../session.ts";
import { bytesOf, unitsOf } from "./bytes.ts";
import { mdl, odl } from "./languages.ts";

const highlighting = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--accent-text)", fontWeight: "600" },
  { tag: tags.typeName, color: "var(--go-text)", fontWeight: "600" },
  { tag: tags.atom, color: "var(--hold-text)" },
  { tag: tags.string, color: "var(--hold-text)" },
  { tag: tags.number, color: "var(--text)" },
  { tag: tags.labelName, color: "var(--danger-text)", fontWeight: "600" },
  { tag: tags.comment, color: "var(--text-3)", fontStyle: "italic" },
  { tag: tags.bracket, color: "var(--text-2)" },
]);

const looks = EditorView.theme({
  "&": { height: "100%", color: "var(--text)", backgroundColor: "var(--surface)", fontSize: "13px" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.5" },
  ".cm-content": { caretColor: "var(--text)" },
  ".cm-cursor": { borderLeftColor: "var(--text)" },
  ".cm-gutters": { backgroundColor: "var(--surface)", color: "var(--text-3)", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--sunken)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": {
    backgroundColor: "var(--accent-soft)",
  },
  ".cm-tooltip": {
    backgroundColor: "var(--raised)",
    color: "var(--text)",
    border: "1px solid var(--line)",
    borderRadius: "6px",
  },
  ".cm-tooltip-autocomplete > ul > li[aria-selected]": {
    backgroundColor: "var(--accent-soft)",
    color: "var(--accent-text)",
  },
  ".cm-completionDetail": { color: "var(--text-3)", fontStyle: "normal" },
  ".cm-panels": { backgroundColor: "var(--sunken)", color: "var(--text)" },
  ".cm-textfield": { backgroundColor: "var(--surface)", border: "1px solid var(--line-strong)" },
  ".cm-button": { backgroundImage: "none", backgroundColor: "var(--raised)", border: "1px solid var(--line)" },
  ".cm-diagnostic": { whiteSpace: "pre-wrap", padding: "4px 8px" },
});

export function editorParts(session: Session, language: Complete_Language): Extension[] {
  return [
    lineNumbers(),
    highlightActiveLine(),
    highlightActiveLineGutter(),
    drawSelection(),
    bracketMatching(),
    closeBrackets(),
    highlightSelectionMatches(),
    search({ top: true }),
    lintGutter(),
    language === Complete_Language.OVERLAY ? odl() : mdl(),
    syntaxHighlighting(highlighting),
    looks,
    EditorState.lineSeparator.of("\n"),
    EditorState.tabSize.of(2),
    autocompletion({ override: [(context) => complete(session, language, context)], icons: false }),
    keymap.of([
      { key: "Mod-/", run: toggleComment },
      ...completionKeymap,
      ...searchKeymap,
      ...lintKeymap,
      ...defaultKeymap,
      indentWithTab,
    ]),
  ];
}

async function complete(
  { connection }: Session,
  language: Complete_Language,
  context: CompletionContext,
): Promise<CompletionResult | null> {
  if (!context.explicit && !context.matchBefore(/[\w"-]+$/)) return null;
  const text = context.state.doc.toString();
  const reply = await connection.ask({
    case: "complete",
    value: { language, text, cursor: bytesOf(text, context.pos) },
  });
  if (reply.result.case !== "completions" || context.aborted) return null;
  const { begin, items } = reply.result.value;
  return {
    from: unitsOf(text, begin),
    options: items.map((item) => ({ label: item.text, type: item.kind, detail: item.kind, info: item.help })),
    validFor: /^[\w-]*$/,
  };
}
