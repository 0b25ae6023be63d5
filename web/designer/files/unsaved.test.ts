import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { type Document, DocumentSchema } from "../session/protocol.ts";
import { recentEntries, shownPlace } from "./unsaved.ts";

const documents = (...all: { path: string; title?: string; isDirty?: boolean }[]): Record<string, Document> =>
  Object.fromEntries(all.map((one) => [one.path, create(DocumentSchema, one)]));

test("what has no file yet comes first, also of this page", () => {
  const recent = [
    { path: "new:1", title: "Old", about: "" },
    { path: "a.cdl", title: "a", about: "" },
  ];
  const open = documents({ path: "new:2", title: "Drift", isDirty: true }, { path: "b.cdl", isDirty: true });
  expect(recentEntries(recent, open).map(({ title }) => title)).toEqual(["Old", "Drift", "a"]);
});

test("it is called by what it holds now, and an empty one is not listed", () => {
  const recent = [
    { path: "new:1", title: "Old", about: "" },
    { path: "new:2", title: "Emptied", about: "" },
  ];
  const open = documents({ path: "new:1", title: "Better", isDirty: true }, { path: "new:2" }, { path: "new:3" });
  expect(recentEntries(recent, open)).toEqual([{ path: "new:1", title: "Better", about: "" }]);
});

test("a file says that this page has changes of it", () => {
  const open = documents({ path: "b/b.cdl", isDirty: true });
  expect(shownPlace({ path: "b/b.cdl", title: "b", about: "" }, open)).toBe("b/b.cdl, with changes that are not saved");
  expect(shownPlace({ path: "examples:a.cdl", title: "a", about: "" }, open)).toBe("a.cdl");
});
