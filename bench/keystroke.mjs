// How long a configuration takes to be checked, and how long after a keystroke an editor knows what is wrong with it, for
// copies of missions/forage/forager.cdl as large as is asked for. Several builds are measured in turns.
//
// usage: node bench/keystroke.mjs MLAB [MLAB...]
import { spawn, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const kSizes = { "3,000 lines": (text) => text.split("\n").length >= 3000, "1 MB": (text) => text.length >= 1_000_000 };
const kRounds = 15;
const kPause = 400; // between two keystrokes [ms]

/** The assemblages of the foragers again and again, each time by other names, and one robot of the first. */
function configuration(isEnough) {
  const forager = readFileSync(join(root, "missions/forage/forager.cdl"), "utf8");
  const robot = forager.indexOf("/// What the foragers are");
  const assemblages = forager.slice(0, robot);
  const names = [...assemblages.matchAll(/^assemblage (\w+)/gm)].map((found) => found[1]);
  const named = new RegExp(`\\b(${names.join("|")})\\(`, "g");
  let text = forager;
  for (let copy = 2; !isEnough(text); ++copy) text += assemblages.replace(named, (_, name) => `${name}${copy}(`);
  return text;
}

/** @returns {number} processor time of `mlab check` [ms] */
function checkTime(mlab, file) {
  const timed = 'TIMEFORMAT="%3U %3S"; time "$0" check "$1" >/dev/null 2>&1';
  const said = spawnSync("bash", ["-c", timed, mlab, file], { encoding: "utf8" }).stderr.trim().split("\n").at(-1);
  return said.split(" ").reduce((sum, seconds) => sum + 1000 * Number(seconds), 0);
}

/** Talks to `mlab lsp`. */
class Server {
  constructor(mlab) {
    this.process = spawn(mlab, ["lsp"], { stdio: ["pipe", "pipe", "inherit"] });
    this.got = Buffer.alloc(0);
    this.waiting = [];
    this.process.stdout.on("data", (bytes) => this.take(bytes));
  }

  take(bytes) {
    this.got = Buffer.concat([this.got, bytes]);
    for (;;) {
      const head = this.got.indexOf("\r\n\r\n");
      if (head < 0) return;
      const begin = head + 4;
      const end = begin + Number(/Content-Length: (\d+)/.exec(this.got.toString("latin1", 0, head))[1]);
      if (this.got.length < end) return;
      const message = JSON.parse(this.got.toString("utf8", begin, end));
      this.got = this.got.subarray(end);
      this.waiting = this.waiting.filter(({ is, tell }) => !is(message) || tell(message));
    }
  }

  next(is) {
    return new Promise((tell) => this.waiting.push({ is, tell }));
  }

  send(message) {
    const text = JSON.stringify({ jsonrpc: "2.0", ...message });
    this.process.stdin.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
  }

  async ask(id, method, params) {
    const answer = this.next((message) => message.id === id);
    this.send({ id, method, params });
    return answer;
  }

  diagnostics(version) {
    return this.next((message) => message.method === "textDocument/publishDiagnostics" && message.params.version === version);
  }
}

const pause = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

async function opened(mlab, file, text) {
  const server = new Server(mlab);
  await server.ask(0, "initialize", { capabilities: {} });
  const told = server.diagnostics(0);
  const uri = `file://${file}`;
  server.send({ method: "textDocument/didOpen", params: { textDocument: { uri, version: 0, languageId: "cdl", text } } });
  await told;
  return { server, uri };
}

/** A digit is typed or taken away in the middle of the text; while that is checked somebody hovers. */
async function keystroke({ server, uri }, version, line) {
  const at = { line, character: "    1".length };
  const range = version % 2 === 1 ? { start: at, end: at } : { start: at, end: { ...at, character: at.character + 1 } };
  const change = { textDocument: { uri, version }, contentChanges: [{ range, text: version % 2 === 1 ? "0" : "" }] };
  const begin = performance.now();
  const told = server.diagnostics(version);
  server.send({ method: "textDocument/didChange", params: change });
  await told;
  return performance.now() - begin;
}

/** How long an answer takes that is asked for a moment after a keystroke. */
async function hoverWhileTyping(open, version, line) {
  const told = keystroke(open, version, line);
  await pause(60);
  const begin = performance.now();
  const position = { line, character: "    1: K".length };
  await open.server.ask(version, "textDocument/hover", { textDocument: { uri: open.uri }, position });
  const out = performance.now() - begin;
  await told;
  return out;
}

const builds = process.argv.slice(2);
if (builds.length === 0) throw new Error("usage: node bench/keystroke.mjs MLAB [MLAB...]");
const folder = mkdtempSync(join(tmpdir(), "keystroke-"));
for (const [size, isEnough] of Object.entries(kSizes)) {
  const text = configuration(isEnough);
  const lines = text.split("\n");
  const file = join(folder, "many.cdl");
  writeFileSync(file, text);
  const middle = lines.findIndex((line, at) => at > lines.length / 2 && line.startsWith("    1: K"));
  const opens = await Promise.all(builds.map((mlab) => opened(mlab, file, text)));
  const times = builds.map(() => ({ check: [], keystroke: [], hover: [] }));
  for (let round = 0; round < kRounds; ++round) {
    for (const [at, mlab] of builds.entries()) {
      times[at].check.push(checkTime(mlab, file));
      times[at].keystroke.push(await keystroke(opens[at], 2 * round + 1, middle));
      await pause(kPause);
      times[at].hover.push(await hoverWhileTyping(opens[at], 2 * round + 2, middle));
      await pause(kPause);
    }
  }
  for (const [at, mlab] of builds.entries()) {
    const said = Object.entries(times[at]).map(([what, all]) => {
      all.sort((a, b) => a - b);
      return `${what} ${all[0].toFixed(1)} at best, ${all[kRounds >> 1].toFixed(1)} in the middle`;
    });
    console.log(`${size} (${lines.length} lines, ${text.length} bytes), ${mlab} [ms]: ${said.join("; ")}`);
    opens[at].server.process.kill();
  }
}
rmSync(folder, { recursive: true });
