import * as os from "node:os";
import * as vscode from "vscode";
import { LanguageClient, type LanguageClientOptions, type ServerOptions } from "vscode-languageclient/node";
import { commandOf } from "./command";

const languages = ["cdl", "cnl", "mdl", "odl"];

let client: LanguageClient | undefined;

function serverOptions(): ServerOptions {
  const setting = vscode.workspace.getConfiguration("missionlab").get<string>("path", "mlab");
  const folder = vscode.workspace.workspaceFolders?.[0]?.uri.fsPath;
  const command = commandOf(setting, folder, os.homedir());
  return { command, args: ["lsp"], options: folder === undefined ? {} : { cwd: folder } };
}

function clientOptions(): LanguageClientOptions {
  return {
    // C++ in a folder that is not trusted is not given to the compiler.
    initializationOptions: { trusted: vscode.workspace.isTrusted },
    documentSelector: languages.map((language) => ({ language })),
    synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/*.{cdl,cnl,mdl,odl,ovl}") },
  };
}

async function start(): Promise<void> {
  client = new LanguageClient("missionlab", "missionlab", serverOptions(), clientOptions());
  try {
    await client.start();
  } catch (error) {
    client = undefined;
    const why = error instanceof Error ? error.message : String(error);
    const choice = await vscode.window.showErrorMessage(`mlab could not be started: ${why}`, "Settings");
    if (choice === "Settings") await vscode.commands.executeCommand("workbench.action.openSettings", "missionlab.path");
  }
}

async function stop(): Promise<void> {
  const running = client;
  client = undefined;
  await running?.stop();
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  context.subscriptions.push(
    vscode.commands.registerCommand("missionlab.restart", async () => {
      await stop();
      await start();
    }),
    vscode.workspace.onDidGrantWorkspaceTrust(async () => {
      await stop();
      await start();
    }),
    vscode.workspace.onDidChangeConfiguration(async (change) => {
      if (!change.affectsConfiguration("missionlab.path")) return;
      await stop();
      await start();
    }),
  );
  await start();
}

export function deactivate(): Promise<void> {
  return stop();
}
