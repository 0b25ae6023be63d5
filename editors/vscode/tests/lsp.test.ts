import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import * as path from "node:path";
import { pathToFileURL } from "node:url";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { CancellationTokenSource, type MessageConnection, type ResponseError } from "vscode-jsonrpc/node";
import {
  CodeActionRequest,
  CompletionRequest,
  DefinitionRequest,
  type Diagnostic,
  DidChangeTextDocumentNotification,
  DidOpenTextDocumentNotification,
  DocumentFormattingRequest,
  DocumentSymbolRequest,
  ExitNotification,
  FoldingRangeRequest,
  HoverRequest,
  InitializedNotification,
  InitializeRequest,
  InlayHintRequest,
  LSPErrorCodes,
  PublishDiagnosticsNotification,
  ReferencesRequest,
  RenameRequest,
  SemanticTokensRequest,
  ShutdownRequest,
  WorkspaceSymbolRequest,
} from "vscode-languageserver-protocol";
import { root, startServer } from "./server";

// The protocol's own client library against the real server.
describe("mlab lsp, asked by an independent client", () => {
  const folder = mkdtempSync(path.join(tmpdir(), "mlab-lsp-"));
  const uri = (file: string) => pathToFileURL(path.join(folder, file)).href;
  const told = new Map<string, Diagnostic[]>();
  let waiting: (() => void)[] = [];
  let connection: MessageConnection;
  let exit: Promise<number | null>;

  async function diagnostics(file: string, fits: (list: Diagnostic[]) => boolean): Promise<Diagnostic[]> {
    for (;;) {
      const list = told.get(uri(file));
      if (list !== undefined && fits(list)) return list;
      await new Promise<void>((resolve) => waiting.push(resolve));
    }
  }
  async function open(file: string, text: string, languageId = path.extname(file).slice(1)): Promise<void> {
    await connection.sendNotification(DidOpenTextDocumentNotification.type, {
      textDocument: { uri: uri(file), languageId, version: 1, text },
    });
  }
  const at = (file: string, line: number, character: number) => ({
    textDocument: { uri: uri(file) },
    position: { line, character },
  });

  beforeAll(async () => {
    const started = startServer();
    connection = started.connection;
    exit = started.exit;
    connection.onNotification(PublishDiagnosticsNotification.type, (params) => {
      told.set(params.uri, params.diagnostics);
      const now = waiting;
      waiting = [];
      for (const one of now) one();
    });
    const result = await connection.sendRequest(InitializeRequest.type, {
      processId: process.pid,
      rootUri: pathToFileURL(folder).href,
      capabilities: { textDocument: { completion: { completionItem: { snippetSupport: true } } } },
    });
    expect(result.capabilities.positionEncoding).toBe("utf-16");
    expect(result.capabilities.renameProvider).toEqual({ prepareProvider: true });
    await connection.sendNotification(InitializedNotification.type, {});
  });

  afterAll(async () => {
    await connection.sendRequest(ShutdownRequest.type);
    await connection.sendNotification(ExitNotification.type);
    expect(await exit).toBe(0);
    connection.dispose();
    rmSync(folder, { recursive: true });
  });

  it("finds nothing wrong with a configuration of the examples", async () => {
    await open("forager.cdl", readFileSync(path.join(root, "missions/forage/forager.cdl"), "utf8"));
    expect(await diagnostics("forager.cdl", () => true)).toEqual([]);
    const symbols = await connection.sendRequest(DocumentSymbolRequest.type, {
      textDocument: { uri: uri("forager.cdl") },
    });
    expect(symbols?.map((symbol) => symbol.name)).toContain("Forage");
    const tokens = await connection.sendRequest(SemanticTokensRequest.type, {
      textDocument: { uri: uri("forager.cdl") },
    });
    expect((tokens?.data.length ?? 0) % 5).toBe(0);
    expect(tokens?.data.length).toBeGreaterThan(1000);
  });

  it("completes, tells and mends while somebody types", async () => {
    await open("a.cdl", "/* 🙂 */ assemblage A() {\n  cooperate {\n    1: \n  }\n}\n");
    const list = await connection.sendRequest(CompletionRequest.type, at("a.cdl", 2, 7));
    const items = Array.isArray(list) ? list : (list?.items ?? []);
    const noise = items.find((item) => item.label === "Noise");
    expect(noise).toMatchObject({ textEdit: { newText: "Noise($0)" }, insertTextFormat: 2 });
    expect(noise?.detail).toContain("persistence");
    await connection.sendNotification(DidChangeTextDocumentNotification.type, {
      textDocument: { uri: uri("a.cdl"), version: 2 },
      contentChanges: [
        {
          range: { start: { line: 2, character: 7 }, end: { line: 2, character: 7 } },
          text: "Noisee(persistence = 2 s);",
        },
        { range: { start: { line: 0, character: 3 }, end: { line: 0, character: 5 } }, text: "é" },
      ],
    });
    const wrong = await diagnostics("a.cdl", (found) => found[0]?.code === "unknown-call");
    expect(wrong[0]?.range.start).toEqual({ line: 2, character: 7 });
    const actions = await connection.sendRequest(CodeActionRequest.type, {
      textDocument: { uri: uri("a.cdl") },
      range: wrong[0]!.range,
      context: { diagnostics: wrong },
    });
    expect(actions?.map((action) => action.title)).toEqual(["write `Noise`"]);
    await connection.sendNotification(DidChangeTextDocumentNotification.type, {
      textDocument: { uri: uri("a.cdl"), version: 3 },
      contentChanges: [{ range: wrong[0]!.range, text: "Noise" }],
    });
    await diagnostics("a.cdl", (found) => found.length === 0);
    const hover = await connection.sendRequest(HoverRequest.type, at("a.cdl", 2, 15));
    expect(hover?.contents).toMatchObject({ value: expect.stringContaining("unit s") });
    const edits = await connection.sendRequest(DocumentFormattingRequest.type, {
      textDocument: { uri: uri("a.cdl") },
      options: { tabSize: 2, insertSpaces: true },
    });
    expect(edits?.length).toBeLessThanOrEqual(1);
  });

  it("renames and finds in files that are not open, folds, hints, and lets go of what is cancelled", async () => {
    writeFileSync(path.join(folder, "robots.cdl"), "robot Scout(urge: gain = 0.5) {\n  movement = Noise(6);\n}\n");
    writeFileSync(path.join(folder, "s.mdl"), 'NEW-ROBOT scout "robots.cdl" (urge = 0.7)\nUNIT <b> scout\n');
    await open("robots.cdl", readFileSync(path.join(folder, "robots.cdl"), "utf8"));
    const textDocument = { uri: uri("robots.cdl") };
    const uses = await connection.sendRequest(ReferencesRequest.type, {
      ...at("robots.cdl", 0, 13),
      context: { includeDeclaration: false },
    });
    expect(uses?.map((one) => one.uri)).toEqual([uri("s.mdl")]);
    const edit = await connection.sendRequest(RenameRequest.type, { ...at("robots.cdl", 0, 13), newName: "need" });
    expect(Object.keys(edit?.changes ?? {}).sort()).toEqual([uri("robots.cdl"), uri("s.mdl")]);
    const found = await connection.sendRequest(WorkspaceSymbolRequest.type, { query: "scout" });
    expect(found?.map((one) => one.name)).toEqual(expect.arrayContaining(["Scout", "scout"]));
    const folds = await connection.sendRequest(FoldingRangeRequest.type, { textDocument });
    expect(folds).toEqual([{ startLine: 0, endLine: 1 }]);
    const range = { start: { line: 0, character: 0 }, end: { line: 3, character: 0 } };
    const hints = await connection.sendRequest(InlayHintRequest.type, { textDocument, range });
    expect(hints?.map((one) => one.label)).toEqual(["persistence:", "s"]);
    // It is answered, by what was found or by the refusal that the protocol has for it.
    const stop = new CancellationTokenSource();
    const asked = connection.sendRequest(WorkspaceSymbolRequest.type, { query: "a" }, stop.token);
    stop.cancel();
    const answer = await asked.catch((error: ResponseError<void>) => error.code);
    expect(answer === LSPErrorCodes.RequestCancelled || Array.isArray(answer)).toBe(true);
  });

  it("renames a place in the overlay and in all missions, open or not", async () => {
    writeFileSync(path.join(folder, "map.odl"), "CONTROL MEASURES:\nPP Charlie 10 10\nPP Delta 20 20\n");
    const mission = "OVERLAY map.odl\nUNIT <a> ROBOT\nCOMMAND LIST:\n1. UNIT a START PP-Charlie\n";
    writeFileSync(path.join(folder, "other.mdl"), mission);
    await open("m.mdl", mission);
    expect(await diagnostics("m.mdl", () => true)).toEqual([]);
    const place = await connection.sendRequest(DefinitionRequest.type, at("m.mdl", 3, 22));
    expect(place).toMatchObject({ uri: uri("map.odl"), range: { start: { line: 1, character: 3 } } });
    const uses = await connection.sendRequest(ReferencesRequest.type, {
      ...at("m.mdl", 3, 22),
      context: { includeDeclaration: true },
    });
    expect(uses?.map((use) => use.uri).sort()).toEqual([uri("m.mdl"), uri("map.odl"), uri("other.mdl")].sort());
    const edit = await connection.sendRequest(RenameRequest.type, { ...at("m.mdl", 3, 22), newName: "Bridge" });
    expect(Object.keys(edit?.changes ?? {}).sort()).toEqual([uri("m.mdl"), uri("map.odl"), uri("other.mdl")].sort());
    await expect(
      connection.sendRequest(RenameRequest.type, { ...at("m.mdl", 3, 22), newName: "Delta" }),
    ).rejects.toThrow("stands for something else");
  });

  it("uses the unsaved texts of other files", async () => {
    await open("skills.cdl", "assemblage Mine() {\n  Noise()\n}\n");
    await open("b.cdl", 'use "skills.cdl";\nassemblage B() {\n  Mine()\n}\n');
    expect(await diagnostics("b.cdl", (list) => list.length === 0)).toEqual([]);
    await connection.sendNotification(DidChangeTextDocumentNotification.type, {
      textDocument: { uri: uri("skills.cdl"), version: 2 },
      contentChanges: [{ text: "assemblage Ours() {\n  Noise()\n}\n" }],
    });
    const wrong = await diagnostics("b.cdl", (list) => list.length > 0);
    expect(wrong[0]?.code).toBe("unknown-call");
  });

  it("answers unknown methods as the protocol says", async () => {
    await expect(connection.sendRequest("textDocument/madeUp", {})).rejects.toMatchObject({ code: -32601 });
    await expect(connection.sendRequest("textDocument/hover", at("nowhere.cdl", 0, 0))).rejects.toMatchObject({
      code: -32602,
    });
  });
});
