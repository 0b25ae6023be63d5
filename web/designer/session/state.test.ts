import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { pageKey } from "./pages.ts";
import { DocumentSchema, DrawingSchema, HelloSchema, MarkSchema, PaletteSchema, TestListSchema } from "./protocol.ts";
import {
  besideSimulator,
  createState,
  firstShown,
  readShown,
  type State,
  shownAfter,
  withoutDocument,
  withRenamedDocument,
} from "./state.ts";

test("what is shown is kept over a reload", () => {
  localStorage.clear();
  const store = createState(localStorage, 1280);
  store.setState(({ shown }) => ({ shown: { ...shown, text: true, textWidth: 500 }, theme: "dark" }));
  const again = createState(localStorage, 1280).getState();
  expect(again.shown).toMatchObject({ text: true, textWidth: 500, palette: true });
  expect(again.theme).toBe("dark");
});

test("what was stored may be anything", () => {
  const first = firstShown(1280);
  for (const stored of [null, 3, "x", [], { text: "yes", textWidth: "wide" }])
    expect(readShown(stored, first)).toEqual(first);
  expect(readShown({ textWidth: 99_999, live: true }, first)).toMatchObject({ textWidth: 1200, live: true });
});

test("the palette makes room for the simulator in a narrow window, and comes back with its end", () => {
  const first = firstShown(1280);
  const beside = shownAfter(first, besideSimulator(first, true));
  expect(beside).toMatchObject({ live: true, palette: false });
  expect(shownAfter(beside, { details: false })).toMatchObject({ live: true, palette: false });
  expect(shownAfter(beside, { live: false })).toMatchObject({ live: false, palette: true, paletteWaits: false });
  expect(shownAfter(first, besideSimulator(first, false))).toMatchObject({ live: true, palette: true });
});

test("in a narrow window the palette makes room for the text, and comes back with its end", () => {
  const first = firstShown(1280);
  const beside = shownAfter(first, { text: true }, true);
  expect(beside).toMatchObject({ text: true, palette: false, details: true });
  expect(shownAfter(beside, { detailsWidth: 300 }, true)).toMatchObject({ palette: false });
  expect(shownAfter(beside, { text: false }, true)).toMatchObject({ text: false, palette: true, paletteWaits: false });
  expect(shownAfter(beside, { palette: true }, true)).toMatchObject({ text: true, palette: true });
  expect(shownAfter(first, { text: true }, false)).toMatchObject({ text: true, palette: true });
  expect(shownAfter(first, { live: true }, true)).toMatchObject({ live: true, palette: false });
  expect(shownAfter({ ...first, details: false }, { text: true }, true)).toMatchObject({ text: true, palette: true });
});

test("a palette that somebody hid stays hidden when the simulator is closed", () => {
  const hidden = shownAfter(firstShown(1280), { palette: false });
  const beside = shownAfter(hidden, besideSimulator(hidden, true));
  expect(shownAfter(beside, { live: false }).palette).toBe(false);
  const first = firstShown(1280);
  const reopened = shownAfter(shownAfter(first, besideSimulator(first, true)), { palette: true });
  expect(shownAfter(shownAfter(reopened, { palette: false }), { live: false }).palette).toBe(false);
});

test("a document that has gone is not listed any more", () => {
  const store = createState(localStorage, 1280);
  const hello = create(HelloSchema, { recent: [{ path: "new:1" }, { path: "a.cdl" }] });
  store.setState({ hello, documents: { "new:1": create(DocumentSchema), "a.cdl": create(DocumentSchema) } });
  const left = withoutDocument(store.getState(), "new:1");
  expect(Object.keys(left.documents ?? {})).toEqual(["a.cdl"]);
  expect(left.hello?.recent.map(({ path }) => path)).toEqual(["a.cdl"]);
});

test("what is known of a document is known under its new name", () => {
  const first = createState(localStorage, 1600).getState();
  const page = (document: string) => create(DrawingSchema, { page: { document, path: "Wander" } });
  const before = {
    ...first,
    documents: { "new:1": create(DocumentSchema, { path: "new:1", text: "x" }) },
    drawings: { [pageKey("new:1", "Wander")]: page("new:1"), [pageKey("b.cdl", "Wander")]: page("b.cdl") },
    document: "new:1",
    page: "Wander",
    trail: [{ document: "new:1", page: "", title: "" }],
    palettes: { "new:1": create(PaletteSchema, { document: "new:1" }) },
    tests: { "new:1": create(TestListSchema, { document: "new:1" }) },
    marks: { "new:1": [create(MarkSchema, { id: 7 })] },
  };
  const after: State = { ...before, ...withRenamedDocument(before, "new:1", "a.cdl") };
  expect(Object.keys(after.documents)).toEqual(["a.cdl"]);
  expect(after.documents["a.cdl"]).toMatchObject({ path: "a.cdl", text: "x" });
  expect(Object.keys(after.drawings).sort()).toEqual([pageKey("a.cdl", "Wander"), pageKey("b.cdl", "Wander")]);
  expect(after.drawings[pageKey("a.cdl", "Wander")]!.page!.document).toBe("a.cdl");
  expect(after).toMatchObject({ document: "a.cdl", page: "Wander", trail: [{ document: "a.cdl" }] });
  for (const known of [after.palettes, after.tests, after.marks]) expect(Object.keys(known)).toEqual(["a.cdl"]);
});
