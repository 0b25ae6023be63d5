// The editor of configurations: hover and definitions by the server, undo that is the document's.
import type { Extension } from "@codemirror/state";
import { EditorView, hoverTooltip, type Tooltip } from "@codemirror/view";
import { bytesOf, unitsOf } from "../../ui/text/bytes.ts";
import { cdl } from "../../ui/text/cdl.ts";
import { nameKeys, wordAtCursor } from "../../ui/text/name_keys.ts";
import { textEditorParts } from "../../ui/text/parts.ts";
import { showUses } from "../names/uses.ts";
import type { Designer } from "../session/designer.ts";
import { redo, undo } from "../session/documents.ts";
import { AskLanguage_What } from "../session/protocol.ts";
import { helpElement } from "./help.ts";
import type { LiveText } from "./live_text.ts";

export function editorParts(designer: Designer, live: LiveText, document: string): Extension[] {
  return [
    textEditorParts({
      language: cdl(),
      letter: /\w/,
      complete: async (_, cursor) => {
        await live.flush();
        const value = { document, what: AskLanguage_What.COMPLETE, cursor };
        const { result } = await designer.link.ask({ case: "askLanguage", value });
        return result.case === "completions" ? result.value : undefined;
      },
      keys: [
        // Undo is the document's: it takes back what was drawn and what was typed in the order in which it was done.
        { key: "Mod-z", run: () => unlessAhead(live, () => undo(designer)) },
        { key: "Mod-y", run: () => unlessAhead(live, () => redo(designer)) },
        { key: "Mod-Shift-z", run: () => unlessAhead(live, () => redo(designer)) },
      ],
    }),
    nameKeys({
      toDefinition: (view) => void toDefinition(designer, live, document, view),
      uses: (view) => void usesAt(designer, live, document, view),
      rename: (view) => void renameAt(designer, live, document, view),
    }),
    EditorView.lineWrapping,
    EditorView.contentAttributes.of({ "aria-label": "Text of the configuration", tabindex: "0" }),
    hoverTooltip((view, at) => hover(designer, live, document, view, at), { hoverTime: 400 }),
  ];
}

function unlessAhead(live: LiveText, act: () => void): boolean {
  void live.flush().then(act);
  return true;
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

async function renameAt(designer: Designer, live: LiveText, document: string, view: EditorView): Promise<void> {
  const { head } = view.state.selection.main;
  const { word: first } = wordAtCursor(view);
  if (first === "") return;
  await live.flush();
  const cursor = bytesOf(view.state.doc.toString(), head);
  designer.store.setState({ dialog: "rename-name", renaming: { at: { document, cursor }, first } });
}

async function usesAt(designer: Designer, live: LiveText, document: string, view: EditorView): Promise<void> {
  await live.flush();
  const cursor = bytesOf(view.state.doc.toString(), view.state.selection.main.head);
  await showUses(designer, { document, cursor });
}

async function toDefinition(designer: Designer, live: LiveText, document: string, view: EditorView): Promise<void> {
  await live.flush();
  const cursor = bytesOf(view.state.doc.toString(), view.state.selection.main.head);
  const answer = await designer.link.ask({
    case: "askLanguage",
    value: { document, what: AskLanguage_What.DEFINITION, cursor },
  });
  if (answer.result.case !== "location") return;
  const place = answer.result.value;
  designer.navigation.goTo(place.document || document, place.page, place.node);
  designer.store.setState({ reveal: { begin: place.begin, end: place.end, focus: true } });
}
