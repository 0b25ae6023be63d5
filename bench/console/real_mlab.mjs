// A real mlab, for what is measured beside it (MLAB_COMMAND=FILE; otherwise the one that was built).
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
export const command =
  process.env.MLAB_COMMAND ??
  ["release", "test"].map((build) => join(root, "build", build, "bin", "mlab")).find(existsSync) ??
  "mlab";
export const size = { width: 1280, height: 800 };

/** `mlab COMMAND --no-browser OPTIONS`, with its address. What it keeps lies in `folder`. */
export async function startMlab(folder, does, ...options) {
  const process_ = spawn(command, [does, "--no-browser", "--port", "0", ...options], {
    env: { ...process.env, XDG_STATE_HOME: join(folder, "state") },
  });
  let output = "";
  for (const stream of [process_.stdout, process_.stderr]) stream.on("data", (bytes) => (output += bytes));
  while (!/https?:\/\/\S+/.test(output)) {
    if (process_.exitCode !== null) throw new Error(`mlab did not start:\n${output}`);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  const stop = () =>
    new Promise((resolve) => {
      process_.on("exit", resolve);
      process_.kill("SIGINT");
    });
  return { url: /https?:\/\/\S+/.exec(output)[0], pid: process_.pid, stop };
}

/** In the page: notes when it sends that a frame is drawn. */
export function watchSocket() {
  const noted = { drawn: [] };
  window.noted = noted;
  const send = WebSocket.prototype.send;
  WebSocket.prototype.send = function (data) {
    // Acknowledge is field 3 of ToServer, and no request number stands before it.
    if (data[0] === 0x1a) noted.drawn.push(Date.now());
    return send.call(this, data);
  };
}

export function round(value) {
  return Math.round(value * 10) / 10;
}
