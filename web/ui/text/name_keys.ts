// What an editor asks about the name at the cursor: by keys, and by a click with Ctrl held.
import { type Extension, Prec } from "@codemirror/state";
import { EditorView, keymap } from "@codemirror/view";

export interface NameQuestions {
  toDefinition: (view: EditorView) => void;
  uses: (view: EditorView) => void;
  rename: (view: EditorView) => void;
}

export function nameKeys({ toDefinition, uses, rename }: NameQuestions): Extension {
  const run = (act: (view: EditorView) => void) => (view: EditorView) => {
    act(view);
    return true;
  };
  return [
    Prec.high(
      keymap.of([
        { key: "F12", run: run(toDefinition) },
        { key: "Shift-F12", run: run(uses) },
        { key: "F2", run: run(rename) },
      ]),
    ),
    EditorView.domEventHandlers({
      mousedown(event, view) {
        const at = event.button === 0 && (event.ctrlKey || event.metaKey) ? view.posAtCoords(event) : null;
        if (at === null) return false;
        event.preventDefault();
        view.dispatch({ selection: { anchor: at } });
        toDefinition(view);
        return true;
      },
    }),
  ];
}

/** The word at the cursor, as the language has words, and where it ends; empty: there is none. */
export function wordAtCursor({ state }: EditorView): { word: string; end: number } {
  const { head } = state.selection.main;
  const word = state.wordAt(head);
  return word ? { word: state.sliceDoc(word.from, word.to), end: word.to } : { word: "", end: head };
}
