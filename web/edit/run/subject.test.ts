import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { DeclarationSchema } from "../../designer/session/protocol.ts";
import { subjectOf, subjectsOf } from "./subject.ts";

const of = (...pairs: [string, string][]) => pairs.map(([kind, name]) => create(DeclarationSchema, { kind, name }));
const forager = of(["assemblage", "Wander"], ["assemblage", "Forage"], ["class", "Body"], ["robot", "Forager"]);
const team = [...forager, ...of(["society", "Foragers"])];

test("robots come first, and classes don't run", () => {
  expect(subjectsOf(team).map(({ name }) => name)).toEqual(["Forager", "Foragers", "Wander", "Forage"]);
});

test("the complete robot runs, whichever part of it is drawn", () => {
  expect(subjectOf(forager, "", "Wander")?.name).toBe("Forager");
  expect(subjectOf(team, "", "Foragers")?.name).toBe("Foragers");
});

test("without a robot the assemblage that is drawn runs", () => {
  const only = forager.filter(({ kind }) => kind === "assemblage");
  expect(subjectOf(only, "", "Wander.cooperate")?.name).toBe("Wander");
  expect(subjectOf(only, "", "")?.name).toBe("Forage");
});

test("what was chosen runs, while it is there", () => {
  expect(subjectOf(team, "Wander", "")?.name).toBe("Wander");
  expect(subjectOf(team, "Gone", "")?.name).toBe("Forager");
  expect(subjectOf([], "", "")).toBeUndefined();
});
