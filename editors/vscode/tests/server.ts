import { type ChildProcess, spawn } from "node:child_process";
import { existsSync } from "node:fs";
import * as path from "node:path";
import {
  createMessageConnection,
  type MessageConnection,
  StreamMessageReader,
  StreamMessageWriter,
} from "vscode-jsonrpc/node";

/** The real command. The test suite says where it is; by hand it is that of the build folder. */
export const root = path.resolve(process.env.MLAB_ROOT ?? path.join(__dirname, "..", "..", ".."));
export const mlab = process.env.MLAB_COMMAND ?? path.join(root, "build", "test", "bin", "mlab");

export function requireMlab(): void {
  if (!existsSync(mlab)) throw new Error(`${mlab} is not there: build mlab first, or say MLAB_COMMAND`);
}

/** `mlab lsp` with an independent client beside it. */
export function startServer(): { process: ChildProcess; connection: MessageConnection; exit: Promise<number | null> } {
  requireMlab();
  const child = spawn(mlab, ["lsp"], { stdio: ["pipe", "pipe", "inherit"] });
  const connection = createMessageConnection(
    new StreamMessageReader(child.stdout),
    new StreamMessageWriter(child.stdin),
  );
  const exit = new Promise<number | null>((resolve) => child.on("exit", resolve));
  connection.listen();
  return { process: child, connection, exit };
}
