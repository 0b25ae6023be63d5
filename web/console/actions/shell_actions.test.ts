import { create } from "@bufbuild/protobuf";
import { beforeEach, expect, test, vi } from "vitest";
import type { Connection } from "../../core/connection.ts";
import { Model } from "../../core/model.ts";
import { MomentSchema } from "../../core/protocol.ts";
import type { Action } from "../session/registry.ts";
import type { Session } from "../session/session.ts";
import { Ui } from "../session/ui.ts";
import { allActions } from "./shell_actions.ts";

let session: Session;
const ask = vi.fn(() => Promise.resolve({ ok: true }));

beforeEach(() => {
  ask.mockClear();
  const model = new Model();
  const ui = new Ui(model, window.localStorage, { width: 1600, height: 1000 });
  session = { model, ui, connection: { ask } as unknown as Connection };
});

function action(id: string): Action {
  return allActions(session).find((one) => one.id === id)!;
}

test("each action has an id and a key of its own", () => {
  const actions = allActions(session);
  const keys = actions.flatMap(({ shortcut }) => shortcut ?? []);
  expect(actions.length).toBeGreaterThan(50);
  expect(new Set(actions.map(({ id }) => id)).size).toBe(actions.length);
  expect(new Set(keys).size).toBe(keys.length);
});

test("who only watches is told so first, and may always stop the robots", () => {
  const why = "Only the operator can do this: take control first.";
  for (const id of ["step", "skip", "restart", "abort", "faster", "open", "save", "proceed"])
    expect(action(id).blocked, id).toBe(why);
  expect(action("stop").blocked).toBeUndefined();
});

test("the operator is told what is missing", () => {
  vi.spyOn(session.model, "isOperator").mockReturnValue(true);
  expect(action("step").blocked).toBe("No mission is loaded.");
  expect(action("save").blocked).toBe("No mission is open.");
  expect(action("proceed").blocked).toBe("Nothing is asked.");
  expect(action("take-control").blocked).toBe("You are the operator.");
  expect(action("fit").blocked).toBe("The map is not shown.");
  expect(action("undo")).toMatchObject({ label: "Undo", blocked: "There is nothing to undo." });
});

test("at another moment nothing is ordered, also by the operator, who is told why", () => {
  vi.spyOn(session.model, "isOperator").mockReturnValue(true);
  session.model.set("moment", create(MomentSchema, { time: 3 }));
  for (const id of ["step", "skip", "restart", "open", "save", "proceed", "tool-command", "remove-things", "rename"])
    expect(action(id).blocked, id).toBe("You are looking at another moment: go back to now first.");
  expect(action("stop").blocked).toBeUndefined();
});

test("a layer is hidden, which is undone by its name, and shown again", () => {
  expect(action("layer-trails")).toMatchObject({ label: "Hide trails", shortcut: "t" });
  action("layer-trails").run();
  expect(session.model.get("map").layers.trails).toBe(false);
  expect(action("layer-trails").label).toBe("Show trails");
  expect(action("undo")).toMatchObject({ label: "Undo hide trails", blocked: undefined });
});

test("nobody asks for the operator's place: nothing is offered to be given", () => {
  expect(allActions(session).some(({ id }) => id === "give-control")).toBe(false);
});
