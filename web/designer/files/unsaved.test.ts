import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { type Document, DocumentSchema } from "../protocol.ts";
import { recentEntries } from "./unsaved.ts";

const documents = (...all: { path: string; title?: string; isDirty?: boolean }[]): Record<string, Document> =>
  Object.fromEntries(all.map((one) => [one.path, create(DocumentSchema, one)]));

test("what has no file yet comes first, also of this page", () => {
  const recent = [
    { path: "new:1", title: "Old" },
    { path: "a.cdl", title: "a" },
  ];
  const open = documents({ path: "new:2", title: "Drift", isDirty: true }, { path: "b.cdl", isDirty: true });
  expect(recentEntries(recent, open).map(({ title }) => title)).toEqual(["Old", "Drift", "a"]);
});

test("it is called by what it holds now, and an empty one is not listed", () => {
  const recent = [
    { path: "new:1", title: "Old" },
    { path: "new:2", title: "Emptied" },
  ];
  const open = documents({ path: "new:1", title: "Better", isDirty: true }, { path: "new:2" }, { path: "new:3" });
  expect(recentEntries(recent, open)).toEqual([{ path: "new:1", title: "Better" }]);
});
