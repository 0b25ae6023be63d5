// Colours for CDL: enough to read by; what is right or wrong, the server says.
import { LanguageSupport, StreamLanguage, type StreamParser } from "@codemirror/language";
import { kQuantityNames } from "../../core/value_types.ts";

const kDeclarations = words(
  "use architecture assemblage binding class robot operator society layout alias let body sensor actuator binds is for",
);
const kOperators = words(
  "cooperate compete coordinate fuse sequence select delay by priority strength active as when goto restart start final case otherwise team of caste in not and or initial",
);
const kTypes: ReadonlySet<string> = new Set(kQuantityNames);
const kValues = words("true false");

interface Reading {
  isComment: boolean;
}

export const kCdlParser: StreamParser<Reading> = {
  name: "cdl",
  languageData: {
    commentTokens: { line: "//", block: { open: "/*", close: "*/" } },
    closeBrackets: { brackets: ["(", "[", "{", '"'] },
  },
  startState: () => ({ isComment: false }),
  token(stream, reading) {
    if (reading.isComment || stream.match("/*")) {
      reading.isComment = !stream.match(/^.*?\*\//);
      if (reading.isComment) stream.skipToEnd();
      return "comment";
    }
    if (stream.eatSpace()) return null;
    if (stream.match(/^\/\/.*/)) return "comment";
    if (stream.match(/^"[^"]*"?/)) return "string";
    if (stream.match(/^(\d+\.?\d*|\.\d+)(e[-+]?\d+)?/i)) return "number";
    if (!stream.match(/^[A-Za-z_]\w*/)) {
      stream.next();
      return /[(){}[\]]/.test(stream.current()) ? "bracket" : null;
    }
    const word = stream.current();
    if (stream.match(/^\s*=(?!=)/, false)) return "propertyName";
    if (kDeclarations.has(word)) return "keyword";
    if (kOperators.has(word)) return "keyword";
    if (kTypes.has(word)) return "typeName";
    if (kValues.has(word)) return "atom";
    return /^[A-Z]/.test(word) ? "typeName" : "variableName";
  },
};

export function cdl(): LanguageSupport {
  return new LanguageSupport(StreamLanguage.define(kCdlParser));
}

function words(text: string): ReadonlySet<string> {
  return new Set(text.split(/\s+/));
}
