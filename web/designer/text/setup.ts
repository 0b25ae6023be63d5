// The editor's parts: colours, completion, hover and definitions by the server, keys.
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
  hoverTooltip,
  keymap,
  lineNumbers,
  type Tooltip,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { bytesOf, unitsOf } from "../../console/editor/bytes.ts";
import type { Designer } from "../designer.ts";
import { AskLanguage_What } from "../protocol.ts";
import { cdl } from "./cdl.ts";
import { helpElement } from "./help.ts";
import type { LiveText } from "./live_text.ts";

const highlighting = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--accent-text)", fontWeight: "600" },
  { tag: tags.typeName, color: "var(--go-text)" },
  { tag: tags.propertyName, color: "var(--text-2)" },
  { tag: tags.atom, color: "var(--hold-text)" },
  { tag: tags.string, color: "var(--hold-text)" },
  { tag: tags.number, color: "var(--danger-text)" },
  { tag: tags.comment, color: "var(--text-3)", fontStyle: "italic" },
  { tag: tags.bracket, color: "var(--text-2)" },
]);

const looks = EditorView.theme({
  "&": { height: "100%", color: "var(--text)", backgroundColor: "var(--surface)", fontSize: "12.5px" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.55" },
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

export function editorParts(designer: Designer, live: LiveText, document: string): Extension[] {
  return [
    lineNumbers(),
    highlightActiveLine(),
    highlightActiveLineGutter(),
    drawSelection(),
    EditorView.lineWrapping,
    bracketMatching(),
    closeBrackets(),
    highlightSelectionMatches(),
    search({ top: true }),
    lintGutter(),
    cdl(),
    syntaxHighlighting(highlighting),
    looks,
    EditorState.lineSeparator.of("\n"),
    EditorState.tabSize.of(2),
    EditorView.contentAttributes.of({ "aria-label": "Text of the configuration", tabindex: "0" }),
    autocompletion({ override: [(context) => complete(designer, live, document, context)], icons: false }),
    hoverTooltip((view, at) => hover(designer, live, document, view, at), { hoverTime: 400 }),
    keymap.of([
      { key: "Mod-/", run: toggleComment },
      { key: "F12", run: (view) => toDefinition(designer, live, document, view) },
      // Undo is the document's: it takes back what was drawn and what was typed in the order in which it was done.
      { key: "Mod-z", run: () => unlessAhead(live, () => designer.undo()) },
      { key: "Mod-y", run: () => unlessAhead(live, () => designer.redo()) },
      { key: "Mod-Shift-z", run: () => unlessAhead(live, () => designer.redo()) },
      ...completionKeymap,
      ...searchKeymap,
      ...lintKeymap,
      ...defaultKeymap,
      indentWithTab,
    ]),
  ];
}

function unlessAhead(live: LiveText, act: () => void): boolean {
  void live.flush().then(act);
  return true;
}

async function complete(
  designer: Designer,
  live: LiveText,
  document: string,
  context: CompletionContext,
): Promise<CompletionResult | null> {
  if (!context.explicit && !context.matchBefore(/[\w"]+$/)) return null;
  await live.flush();
  const text = context.state.doc.toString();
  const answer = await designer.link.ask({
    case: "askLanguage",
    value: { document, what: AskLanguage_What.COMPLETE, cursor: bytesOf(text, context.pos) },
  });
  if (answer.result.case !== "completions" || context.aborted) return null;
  const { begin, items } = answer.result.value;
  return {
    from: unitsOf(text, begin),
    options: items.map((item) => ({ label: item.text, type: item.kind, detail: item.kind, info: item.help })),
    validFor: /^\w*$/,
  };
}

async function hover(
  designer: Designer,
  live: LiveText,
  document: string,
  view: EditorView,
  at: number,
): Promise<Tooltip | null> {
  if (live.isAhead) return null;
  const text = view.state.doc.toString();
  const answer = await designer.link.ask({
    case: "askLanguage",
    value: { document, what: AskLanguage_What.HOVER, cursor: bytesOf(text, at) },
  });
  if (answer.result.case !== "hover" || answer.result.value.markdown === "") return null;
  const { markdown, begin, end } = answer.result.value;
  return {
    pos: unitsOf(text, begin),
    end: unitsOf(text, end),
    above: true,
    create: () => {
      const dom = helpElement(markdown, window.document);
      dom.className = "cm-hover";
      return { dom };
    },
  };
}

function toDefinition(designer: Designer, live: LiveText, document: string, view: EditorView): boolean {
  void live.flush().then(async () => {
    const cursor = bytesOf(view.state.doc.toString(), view.state.selection.main.head);
    const answer = await designer.link.ask({
      case: "askLanguage",
      value: { document, what: AskLanguage_What.DEFINITION, cursor },
    });
    if (answer.result.case !== "location") return;
    const place = answer.result.value;
    designer.goTo(place.document || document, place.page, place.node);
    designer.store.setState({ reveal: { begin: place.begin, end: place.end, focus: true } });
  });
  return true;
}
