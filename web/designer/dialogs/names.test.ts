import { expect, test } from "vitest";
import { cdlName } from "./names.ts";

test("names are those of CDL", () => {
  for (const name of ["Wander", "_x", "a1", "keep_clear"]) expect(cdlName(name)).toBeUndefined();
  for (const name of ["", "1a", "a b", "é", "a-b", "a.b"]) expect(cdlName(name)).toBeTypeOf("string");
});
