import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import Module, { createRequire } from "node:module";
import { tmpdir } from "node:os";
import * as path from "node:path";
import { unzipSync } from "fflate";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { mlab, requireMlab } from "./server";
import { Position, type StandIn, standIn } from "./vscode";

const here = path.resolve(__dirname, "..");

interface Extension {
  activate(context: { subscriptions: unknown[] }): Promise<void>;
  deactivate(): Promise<void>;
}

/** Loads what is in the package, with the stand-in where it asks for `vscode`. */
function load(file: string, vscode: StandIn): Extension {
  const modules = Module as unknown as { _load: (name: string, ...rest: unknown[]) => unknown };
  const original = modules._load;
  modules._load = (name, ...rest) => (name === "vscode" ? vscode.module : original(name, ...rest));
  try {
    const require = createRequire(__filename);
    delete require.cache[file];
    return require(file) as Extension;
  } finally {
    modules._load = original;
  }
}

async function until<T>(ask: () => T | undefined): Promise<T> {
  for (;;) {
    const answer = ask();
    if (answer !== undefined) return answer;
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}

describe("the package", () => {
  const files = unzipSync(readFileSync(path.join(here, "dist/missionlab.vsix")));
  const about = JSON.parse(Buffer.from(files["extension/package.json"]!).toString());

  it("holds all that its description names", () => {
    expect(Object.keys(files)).toContain("extension.vsixmanifest");
    expect(Object.keys(files)).toContain("[Content_Types].xml");
    const named: string[] = [
      about.main,
      ...about.contributes.languages.map((one: { configuration: string }) => one.configuration),
      ...about.contributes.grammars.map((one: { path: string }) => one.path),
    ];
    for (const file of named) expect(Object.keys(files)).toContain(path.posix.join("extension", file));
    expect(about.contributes.languages.map((one: { id: string }) => one.id)).toEqual(["cdl", "cnl", "mdl", "odl"]);
  });

  it("needs nothing but VS Code and Node", () => {
    const code = Buffer.from(files["extension/dist/extension.js"]!).toString();
    const needed = [...code.matchAll(/\brequire\("([^"]+)"\)/g)].map((match) => match[1]!.replace(/^node:/, ""));
    const builtin = new Set([...Module.builtinModules, "vscode"]);
    expect([...new Set(needed)].filter((name) => !builtin.has(name))).toEqual([]);
  });

  it("has language settings that are JSON with brackets and comments that are whole", () => {
    for (const one of about.contributes.languages) {
      const settings = JSON.parse(readFileSync(path.join(here, one.configuration), "utf8"));
      expect(settings.comments.lineComment).toMatch(/^(\/\/|--)$/);
      for (const pattern of Object.values(settings.indentationRules ?? {}))
        expect(() => new RegExp(pattern as string)).not.toThrow();
    }
  });
});

describe("the extension", () => {
  const folder = mkdtempSync(path.join(tmpdir(), "mlab-vscode-"));
  const uri = `file://${folder}/x.cdl`;
  let vscode: StandIn;
  let extension: Extension;
  const context = { subscriptions: [] as { dispose(): void }[] };

  beforeAll(async () => {
    requireMlab();
    vscode = standIn({ "missionlab.path": mlab }, folder);
    extension = load(path.join(here, "dist/extension.js"), vscode);
    await extension.activate(context);
  });
  afterAll(async () => {
    await extension.deactivate();
    rmSync(folder, { recursive: true });
  });

  it("starts the server and registers what it offers", () => {
    expect(vscode.errors).toEqual([]);
    for (const name of [
      "registerCompletionItemProvider",
      "registerHoverProvider",
      "registerSignatureHelpProvider",
      "registerDefinitionProvider",
      "registerReferenceProvider",
      "registerRenameProvider",
      "registerDocumentSymbolProvider",
      "registerDocumentFormattingEditProvider",
      "registerCodeActionsProvider",
      "registerDocumentSemanticTokensProvider",
      "registerWorkspaceSymbolProvider",
      "registerFoldingRangeProvider",
      "registerInlayHintsProvider",
    ])
      expect([...vscode.providers.keys()]).toContain(name);
  });

  it("shows what is wrong with a text, and completes it", async () => {
    const document = await vscode.open(uri, "cdl", "assemblage A() {\n  Noisee()\n}\n");
    const wrong = await until(() => (vscode.diagnostics.get(uri)?.length ? vscode.diagnostics.get(uri) : undefined));
    expect(wrong[0]?.message).toContain("unknown assemblage or procedure `Noisee`");
    const [, provider] = vscode.providers.get("registerCompletionItemProvider")![0] as [
      unknown,
      { provideCompletionItems(...all: unknown[]): Promise<{ items: { label: string }[] }> },
    ];
    const token = { isCancellationRequested: false, onCancellationRequested: () => ({ dispose: () => undefined }) };
    const list = await provider.provideCompletionItems(document, new Position(1, 4), token, { triggerKind: 0 });
    expect(list.items.map((item) => item.label)).toContain("Noise");
  });

  it("starts it anew when it is told to", async () => {
    vscode.diagnostics.clear();
    await vscode.command("missionlab.restart");
    expect(vscode.errors).toEqual([]);
    await until(() => (vscode.diagnostics.get(uri)?.length ? true : undefined));
  });

  it("says so where there is no mlab", async () => {
    const alone = standIn({ "missionlab.path": path.join(folder, "nothing") }, folder);
    const other = load(path.join(here, "dist/extension.js"), alone);
    await other.activate({ subscriptions: [] });
    expect(alone.errors.join("\n")).toContain("mlab could not be started");
    expect(existsSync(path.join(folder, "nothing"))).toBe(false);
  });
});
