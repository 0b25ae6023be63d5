import { StringStream } from "@codemirror/language";
import { expect, test } from "vitest";
import { kCdlParser } from "./cdl.ts";

function tokens(text: string): string[] {
  const state = kCdlParser.startState!(2);
  return text.split("\n").flatMap((line) => {
    const stream = new StringStream(line, 2, 2);
    const found: string[] = [];
    while (!stream.eol()) {
      const kind = kCdlParser.token(stream, state);
      if (kind) found.push(`${stream.current()}:${kind}`);
      stream.start = stream.pos;
    }
    return found;
  });
}

test("words, names, numbers and comments are told apart", () => {
  expect(tokens("start Searching: Noise(persistence = 10 s); // drifts")).toEqual([
    "start:keyword",
    "Searching:typeName",
    "Noise:typeName",
    "(:bracket",
    "persistence:propertyName",
    "10:number",
    "s:variableName",
    "):bracket",
    "// drifts:comment",
  ]);
});

test("a comment of several lines ends where it ends", () => {
  expect(tokens("/* a\nb */ true")).toEqual(["/* a:comment", "b */:comment", "true:atom"]);
});
