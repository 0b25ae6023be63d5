import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import * as path from "node:path";
import { beforeAll, describe, expect, it } from "vitest";
import * as oniguruma from "vscode-oniguruma";
import { type IGrammar, INITIAL, parseRawGrammar, Registry } from "vscode-textmate";
import { root } from "./server";

const here = path.resolve(__dirname, "..");
const grammars: Record<string, IGrammar> = {};

/** What VS Code itself brings: C++ inside of networks. Its grammar is not part of this extension. */
const cpp = '{"scopeName":"source.cpp","patterns":[]}';

beforeAll(async () => {
  const wasm = createRequire(__filename).resolve("vscode-oniguruma/release/onig.wasm");
  await oniguruma.loadWASM(readFileSync(wasm));
  const registry = new Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async (scope) => {
      if (scope === "source.cpp") return parseRawGrammar(cpp, "cpp.json");
      const file = path.join(here, "syntaxes", `${scope.slice("source.".length)}.tmLanguage.json`);
      return parseRawGrammar(readFileSync(file, "utf8"), file);
    },
  });
  for (const language of ["cdl", "cnl", "mdl", "odl"])
    grammars[language] = (await registry.loadGrammar(`source.${language}`))!;
});

/** The scopes of each piece of a text, the innermost of each: `[piece, scope]`. */
function scopes(language: string, text: string): [string, string][] {
  const out: [string, string][] = [];
  let stack = INITIAL;
  for (const line of text.split("\n")) {
    const result = grammars[language]!.tokenizeLine(line, stack);
    expect(result.stoppedEarly).toBe(false);
    stack = result.ruleStack;
    for (const token of result.tokens) {
      const piece = line.slice(token.startIndex, token.endIndex);
      if (piece.trim() !== "") out.push([piece.trim(), token.scopes[token.scopes.length - 1]!]);
    }
  }
  return out;
}

function files(folder: string, ending: string): string[] {
  return readdirSync(path.join(root, folder), { recursive: true, encoding: "utf8" })
    .filter((file) => file.endsWith(ending))
    .map((file) => path.join(root, folder, file));
}

describe("the grammars", () => {
  it("know the words of a configuration", () => {
    const found = scopes(
      "cdl",
      `/// Drifts about.
assemblage Wander(curious: gain = 0.8 in 0 .. 1, goal: Vector [m]) -> Vector {
  let drift = Noise(persistence = 10 s);
  sequence {
    start Searching: cooperate { curious: drift; };
      when not IsHalted() goto Resting restart;
    final Resting: Stand();
  }
}
use "skills.cdl";`,
    );
    const expected: [string, string][] = [
      ["/// Drifts about.", "comment.line.documentation.cdl"],
      ["assemblage", "keyword.declaration.cdl"],
      ["Wander", "entity.name.function.cdl"],
      ["curious", "variable.parameter.cdl"],
      ["gain", "support.type.cdl"],
      ["0.8", "constant.numeric.cdl"],
      ["m", "constant.other.unit.cdl"],
      ["drift", "variable.other.cdl"],
      ["Noise", "entity.name.function.cdl"],
      ["persistence", "variable.parameter.cdl"],
      ["s", "constant.other.unit.cdl"],
      ["sequence", "keyword.control.cdl"],
      ["start", "storage.modifier.cdl"],
      ["Searching", "entity.name.label.cdl"],
      ["not", "keyword.operator.word.cdl"],
      ["goto", "keyword.control.cdl"],
      ["Resting", "entity.name.label.cdl"],
      ["restart", "keyword.control.cdl"],
      ['"skills.cdl"', "string.quoted.double.cdl"],
    ];
    for (const one of expected) expect(found).toContainEqual(one);
  });

  it("tell C++ from the network around it", () => {
    const found = scopes(
      "cnl",
      `procedure Vector [m] Weave with
  double [rad] width = 0.8 in 0 .. 3;  ///< how far
header
body
  const double node = 1;
pend
node a is Weave |the first| with width = 0.5; nend`,
    );
    expect(found).toContainEqual(["Weave", "entity.name.function.cnl"]);
    expect(found).toContainEqual(["width", "variable.parameter.cnl"]);
    expect(found).toContainEqual(["const double node = 1;", "meta.embedded.cpp"]);
    expect(found).toContainEqual(["pend", "keyword.declaration.cnl"]);
    expect(found).toContainEqual(["a", "variable.other.cnl"]);
    expect(found).toContainEqual(["|the first|", "string.quoted.other.description.cnl"]);
  });

  it("know the words of a mission", () => {
    const found = scopes(
      "mdl",
      `MISSION NAME "two -- and one"  -- a title
NEW-ROBOT scout "robot" (speed = 2)
UNIT <pair> (<left> scout) (<right> ROBOT)
COMMAND LIST:
 1a. UNIT pair MOVETO PP-Charlie FORMATION Wedge-Left SPEED 2.5 AND SET SHOW-TRAILS ON
 2. UNIT pair OCCUPY Far UNTIL 12:30`,
    );
    const expected: [string, string][] = [
      ['"two -- and one"', "string.quoted.double.mdl"],
      ["-- a title", "comment.line.double-dash.mdl"],
      ["scout", "entity.name.type.robot.mdl"],
      ["pair", "entity.name.type.unit.mdl"],
      ["COMMAND LIST:", "keyword.control.section.mdl"],
      ["1a.", "entity.name.section.mdl"],
      ["MOVETO", "keyword.control.action.mdl"],
      ["PP-Charlie", "variable.other.place.mdl"],
      ["Wedge-Left", "constant.language.mdl"],
      ["2.5", "constant.numeric.mdl"],
      ["SHOW-TRAILS", "support.constant.option.mdl"],
      ["12:30", "constant.numeric.time.mdl"],
    ];
    for (const one of expected) expect(found).toContainEqual(one);
  });

  it("know the words of an overlay", () => {
    const found = scopes(
      "odl",
      'SITE x\nMISSION-AREA 10 20\nCONTROL MEASURES:\nAA Alpha-1* 10 -2.5 -- here\nGAP "the door" 1 2 3 4',
    );
    const expected: [string, string][] = [
      ["MISSION-AREA", "keyword.declaration.odl"],
      ["CONTROL MEASURES:", "keyword.control.section.odl"],
      ["AA", "keyword.other.feature.odl"],
      ["Alpha-1*", "variable.other.place.odl"],
      ["-2.5", "constant.numeric.odl"],
      ["-- here", "comment.line.double-dash.odl"],
      ["GAP", "keyword.other.feature.odl"],
      ['"the door"', "string.quoted.double.odl"],
    ];
    for (const one of expected) expect(found).toContainEqual(one);
  });

  it("leave no word of the language without a colour in the examples", () => {
    const all = [
      ...files("missions", ".cdl").map((file) => ["cdl", file] as const),
      ...files("library", ".cdl").map((file) => ["cdl", file] as const),
      ...files("library", ".cnl").map((file) => ["cnl", file] as const),
      ...files("missions", ".mdl").map((file) => ["mdl", file] as const),
      ...files("missions", ".odl").map((file) => ["odl", file] as const),
    ];
    expect(all.length).toBeGreaterThan(40);
    const words: Record<string, RegExp> = {
      cdl: /(?<![\w.])(?:assemblage|cooperate|sequence|goto|when|otherwise|actuator|sensor)(?!\w)/,
      cnl: /(?<![\w.])(?:procedure|nend|pend)(?!\w)/,
      mdl: /(?<![\w-])(?:OVERLAY|MOVETO|OCCUPY|NEW-ROBOT)(?![\w-])/,
      odl: /(?<![\w-])(?:MISSION-AREA|OBSTACLE|ATTRACTOR)(?![\w-])/,
    };
    for (const [language, file] of all) {
      for (const [piece, scope] of scopes(language, readFileSync(file, "utf8")))
        if (words[language]!.test(piece)) expect(scope, `${file}: ${piece}`).not.toBe(`source.${language}`);
    }
  });
});
