// What all editors of text have: how it looks, completion by the server, marks, keys.
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
  type KeyBinding,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";
import type { Completions } from "../../core/protocol.ts";
import { bytesOf, unitsOf } from "./bytes.ts";

const highlighting = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--accent-text)", fontWeight: "600" },
  { tag: tags.typeName, color: "var(--go-text)" },
  { tag: tags.propertyName, color: "var(--text-2)" },
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
  ".cm-selectionMatch": { backgroundColor: "color-mix(in srgb, var(--accent) 16%, transparent)" },
  ".cm-searchMatch": { backgroundColor: "var(--hold-soft)", outline: "1px solid var(--hold)" },
  ".cm-searchMatch-selected": { backgroundColor: "var(--accent-soft)" },
  ".cm-hover": {
    maxWidth: "460px",
    maxHeight: "50vh",
    padding: "6px 10px",
    overflow: "auto",
    fontFamily: "var(--font)",
  },
  ".cm-hover > *": { margin: "4px 0", whiteSpace: "pre-wrap" },
  ".cm-hover pre": { fontFamily: "var(--mono)" },
  ".cm-hover table": { borderCollapse: "collapse" },
  ".cm-hover th, .cm-hover td": {
    padding: "2px 10px 2px 0",
    borderBottom: "1px solid var(--line)",
    textAlign: "left",
    verticalAlign: "top",
  },
});

interface EditorParts {
  language: Extension;
  /** What may stand at a byte of the text; undefined: the server does not say. */
  complete: (text: string, cursor: number) => Promise<Completions | undefined>;
  /** A character of the words that are completed. */
  letter: RegExp;
  /** Come before the usual ones. */
  keys?: readonly KeyBinding[];
}

export function textEditorParts({ language, complete, letter, keys = [] }: EditorParts): Extension[] {
  const word = new RegExp(`^${letter.source}*$`);
  const begun = new RegExp(`(${letter.source}|")+$`);
  const find = async (context: CompletionContext): Promise<CompletionResult | null> => {
    if (!context.explicit && !context.matchBefore(begun)) return null;
    const text = context.state.doc.toString();
    const found = await complete(text, bytesOf(text, context.pos));
    if (!found || context.aborted) return null;
    return {
      from: unitsOf(text, found.begin),
      options: found.items.map((item) => ({ label: item.text, type: item.kind, detail: item.kind, info: item.help })),
      validFor: word,
    };
  };
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
    language,
    syntaxHighlighting(highlighting),
    looks,
    EditorState.lineSeparator.of("\n"),
    EditorState.tabSize.of(2),
    autocompletion({ override: [find], icons: false }),
    keymap.of([
      { key: "Mod-/", run: toggleComment },
      ...keys,
      ...completionKeymap,
      ...searchKeymap,
      ...lintKeymap,
      ...defaultKeymap,
      indentWithTab,
    ]),
  ];
}
