// What each message of the server changes in what the page knows.
import { pageKey } from "./pages.ts";
import type { FromDesigner } from "./protocol.ts";
import { type State, withoutChangedFile, withRenamedDocument } from "./state.ts";

/** Answers and beats are the link's own. */
export type Received = Exclude<FromDesigner["body"], { case: "answer" | "beat" | undefined }>;
type Value<Case> = Extract<Received, { case: Case }>["value"];

/** A message without a row does not compile. */
const kChanges: { readonly [Case in Received["case"]]: (state: State, value: Value<Case>) => Partial<State> } = {
  hello: (_, hello) => ({ hello, notKept: "", differences: {}, pageDifferences: {} }),
  renamed: (state, { from, to }) => withRenamedDocument(state, from, to),
  lists: ({ hello }, { recent, files, onlyKept }) => ({ hello: hello && { ...hello, recent, files, onlyKept } }),
  document: ({ documents }, document) => ({ documents: { ...documents, [document.path]: document } }),
  drawing: ({ drawings }, drawing) => ({ drawings: { ...drawings, [keyOf(drawing)]: drawing } }),
  palette: ({ palettes }, palette) => ({ palettes: { ...palettes, [palette.document]: palette } }),
  fileChanged: ({ changed }, file) => ({
    changed: file.isSameAgain ? withoutChangedFile(changed, file.document) : { ...changed, [file.document]: file },
  }),
  keeping: (_, { notKept }) => ({ notKept }),
  differences: ({ differences }, all) => ({ differences: { ...differences, [all.document]: all } }),
  pageDifference: ({ pageDifferences }, page) => ({ pageDifferences: { ...pageDifferences, [keyOf(page)]: page } }),
  tests: ({ tests }, list) => ({ tests: { ...tests, [list.document]: list } }),
  marks: (state, { document, marks }) => ({ marks: { ...state.marks, [document]: marks } }),
};

export function stateAfter<Case extends Received["case"]>(
  state: State,
  kind: Case,
  value: Value<Case>,
): Partial<State> {
  return kChanges[kind](state, value);
}

function keyOf({ page }: Pick<Value<"drawing" | "pageDifference">, "page">): string {
  return pageKey(page?.document ?? "", page?.path ?? "");
}
