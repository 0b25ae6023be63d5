import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { FixSchema } from "../session/protocol.ts";
import { fixTitle, mergeSplices } from "./apply_fix.ts";

test("several splices become one", () => {
  const merged = mergeSplices("// é\nNosie() + Nosie();", [
    { begin: 17, end: 22, text: "Noise" },
    { begin: 6, end: 11, text: "Noise" },
  ]);
  expect(merged).toMatchObject({ begin: 6, end: 22 });
  const bytes = new TextEncoder().encode("// é\nNosie() + Nosie();");
  const decode = (from: number, to?: number) => new TextDecoder().decode(bytes.subarray(from, to));
  const result = decode(0, merged.begin) + merged.text + decode(merged.end);
  expect(result.startsWith("// é\nNoise() +")).toBe(true);
});

test("a mend is called as a person would write it", () => {
  const title = (text: string) => fixTitle(create(FixSchema, { title: text }));
  expect(title("write `Noise`")).toBe("Write “Noise”");
  expect(title("remove `let near`")).toBe("Remove “let near”");
  expect(title("")).toBe("Mend it");
});
