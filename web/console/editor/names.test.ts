import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { PlanSchema, UseListSchema } from "../../core/names.ts";
import { ClientsSchema, DocumentsSchema, EditStateSchema, type Order, ReplySchema } from "../../core/protocol.ts";
import { Store } from "../../core/store.ts";
import type { Session } from "../session/session.ts";
import type { UiParts } from "../session/ui.ts";
import { askForName, carryOut, goTo, nameActions, planRenaming, showUses, tellCursor, toDefinition } from "./names.ts";

type Result = NonNullable<Parameters<typeof create<typeof ReplySchema>>[1]>;

const kTexts: Partial<UiParts> = {
  looked: [],
  uses: null,
  renaming: null,
  dialog: "",
  reveal: null,
  notice: null,
  document: "",
};

/** A session whose server answers what a test says. */
function sessionOf(answer: (order: Order) => Result | Promise<Result>, isOperator = true) {
  const asked: Order[] = [];
  const ui = new Store<UiParts>({ ...kTexts } as UiParts) as unknown as Session["ui"];
  ui.tell = (text, tone = "danger") => ui.set("notice", { text, tone });
  const undone = { count: 0 };
  ui.undo = () => {
    ++undone.count;
    return "nothing";
  };
  const parts = {
    documents: create(DocumentsSchema, { documents: [{ path: "far.mdl" }, { path: "map.odl" }] }),
    edits: create(EditStateSchema, { undo: "rename Far to Gate" }),
    clients: create(ClientsSchema, {}),
  };
  const session = {
    ui,
    model: {
      get: (name: keyof typeof parts) => parts[name],
      mayOrder: () => isOperator,
      isRecording: () => false,
      isElsewhen: () => false,
    },
    connection: {
      ask: async (order: Order) => {
        asked.push(order);
        return create(ReplySchema, { ok: true, ...(await answer(order)) } as Result);
      },
    },
  } as unknown as Session;
  return { session, ui, asked, undone };
}

const cursorAt = (word: string) => ({
  document: "far.mdl",
  settle: async () => {},
  place: () => ({ cursor: 7, word }),
});
const place = (path: string): Result => ({
  result: { case: "place", value: { path, begin: 4, end: 7, line: 2, canOpen: true } },
});

describe("the definition", () => {
  it("is shown in the text of the mission that has it", async () => {
    const { session, ui } = sessionOf(() => place("map.odl"));
    await toDefinition(session, cursorAt("PP-Far"));
    expect(ui.get("reveal")).toEqual({ document: "map.odl", line: 1, span: { begin: 4, end: 7 } });
    expect(ui.get("looked")).toEqual([]);
  });
  it("is read where it stands in another file, once", async () => {
    const { session, ui, asked } = sessionOf((order) =>
      order.case === "readText"
        ? { result: { case: "text", value: { path: "robots.cdl", text: "robot Scout() {}" } } }
        : place("robots.cdl"),
    );
    await toDefinition(session, cursorAt("scout"));
    await goTo(session, { document: "robots.cdl", begin: 6, end: 11 });
    expect(ui.get("looked")).toEqual([{ path: "robots.cdl", text: "robot Scout() {}" }]);
    expect(ui.get("reveal")?.span).toEqual({ begin: 6, end: 11 });
    expect(asked.map((one) => one.case)).toEqual(["findDefinition", "readText", "readText"]);
  });
  it("is refused with a reason", async () => {
    const { session, ui } = sessionOf(() => ({ ok: false, error: "this is declared in no text that could be shown" }));
    await toDefinition(session, cursorAt("MOVETO"));
    expect(ui.get("notice")?.text).toBe("This is declared in no text that could be shown.");
    expect(ui.get("reveal")).toBeNull();
  });
  it("is not asked for where there is no name", async () => {
    const { session, ui, asked } = sessionOf(() => ({}));
    await toDefinition(session, cursorAt(""));
    expect(asked).toEqual([]);
    expect(ui.get("notice")?.text).toContain("cursor");
  });
  it("of a file that can't be read stays where it is", async () => {
    const { session, ui } = sessionOf((order) =>
      order.case === "readText" ? { ok: false, error: "it is gone" } : place("robots.cdl"),
    );
    await toDefinition(session, cursorAt("scout"));
    expect(ui.get("reveal")).toBeNull();
    expect(ui.get("notice")?.text).toBe("It is gone.");
  });
});

describe("uses", () => {
  const found: Result = { result: { case: "uses", value: create(UseListSchema, { name: "Far", files: [] }) } };
  it("say that they are looked for while the server is silent", async () => {
    let answer: (result: Result) => void = () => {};
    const { session, ui } = sessionOf(() => new Promise((resolve) => (answer = resolve)));
    const shown = showUses(session, cursorAt("PP-Far"));
    await Promise.resolve();
    await Promise.resolve();
    expect(ui.get("uses")).toEqual({ is: "asking", word: "PP-Far" });
    answer(found);
    await shown;
    expect(ui.get("uses")).toMatchObject({ is: "found", places: 0 });
  });
  it("go where the server says no", async () => {
    const { session, ui } = sessionOf(() => ({ ok: false, error: "there is no name here" }));
    await showUses(session, cursorAt("MOVETO"));
    expect(ui.get("uses")).toBeNull();
    expect(ui.get("notice")?.text).toBe("There is no name here.");
  });
  it("that came too late are not shown", async () => {
    let answer: (result: Result) => void = () => {};
    const { session, ui } = sessionOf(() => new Promise((resolve) => (answer = resolve)));
    const shown = showUses(session, cursorAt("PP-Far"));
    await Promise.resolve();
    await Promise.resolve();
    ui.set("uses", null);
    answer(found);
    await shown;
    expect(ui.get("uses")).toBeNull();
  });
});

describe("another name", () => {
  const plan = create(PlanSchema, { from: "Far", to: "Gate", seal: "s", files: [{ path: "far.mdl", uses: [{}] }] });
  it("is asked for where there can be one", async () => {
    const { session, ui } = sessionOf(() => ({ result: { case: "plan", value: plan } }));
    await askForName(session, cursorAt("PP-Far"));
    expect(ui.get("dialog")).toBe("rename");
    expect(ui.get("renaming")).toEqual({ at: { document: "far.mdl", cursor: 7 }, first: "Far" });
  });
  it("is not asked for where there can be none, nor by who watches", async () => {
    const refused = sessionOf(() => ({ ok: false, error: "`Wander` is not declared in this project" }));
    await askForName(refused.session, cursorAt("Wander"));
    expect(refused.ui.get("dialog")).toBe("");
    expect(refused.ui.get("notice")?.text).toContain("not declared in this project");
    const watching = sessionOf(() => ({}), false);
    await askForName(watching.session, cursorAt("PP-Far"));
    expect(watching.asked).toEqual([]);
    expect(watching.ui.get("notice")?.text).toContain("Only the operator");
  });
  it("is refused with the place that is in the way", async () => {
    const { session } = sessionOf(() => ({ ok: false, error: "`Near` is taken", ...place("map.odl") }));
    expect(await planRenaming(session, { document: "far.mdl", cursor: 7 }, "Near")).toEqual({
      is: "refused",
      why: "`Near` is taken",
      place: { document: "map.odl", begin: 4, end: 7 },
    });
  });
  it("is undone as long as nothing else was edited", async () => {
    const { session, ui, asked, undone } = sessionOf(() => ({}));
    expect(await carryOut(session, { document: "far.mdl", cursor: 7 }, plan)).toBe("");
    expect(asked[0]).toMatchObject({ case: "renameEverywhere", value: { name: "Gate", seal: "s" } });
    const notice = ui.get("notice");
    expect(notice?.text).toBe("Renamed Far to Gate: 1 place in 1 file");
    notice?.action?.run();
    expect(undone.count).toBe(1);
    (session.model.get("edits") as { undo: string }).undo = "typing in far.mdl";
    notice?.action?.run();
    expect(undone.count).toBe(1);
    expect(ui.get("notice")?.text).toContain("undo that first");
  });
  it("that the server would not have any more stays in the dialog", async () => {
    const { session, ui } = sessionOf(() => ({ ok: false, error: "the project has changed meanwhile" }));
    expect(await carryOut(session, { document: "far.mdl", cursor: 7 }, plan)).toBe("the project has changed meanwhile");
    expect(ui.get("notice")).toBeNull();
  });
});

describe("the actions", () => {
  it("wait for a cursor, and renaming for the operator", () => {
    const { session } = sessionOf(() => ({}), false);
    expect(nameActions(session).every((one) => one.blocked)).toBe(true);
    const forget = tellCursor(session, cursorAt("Far"));
    expect(nameActions(session).map((one) => one.blocked !== undefined)).toEqual([false, false, true]);
    forget();
    expect(nameActions(session).every((one) => one.blocked)).toBe(true);
  });
});
