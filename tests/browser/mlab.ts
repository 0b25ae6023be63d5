import { type ChildProcess, spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));

/** The missions that come with mlab. */
export const missions = process.env.MLAB_MISSIONS ?? join(here, "..", "..", "missions");

/** A running `mlab run`, `mlab edit` or `mlab replay`, with a folder of its own for what it remembers. */
export class Mlab {
  private readonly process: ChildProcess;
  private readonly ended: Promise<number | null>;
  output = "";

  private constructor(
    what: "run" | "edit" | "replay",
    options: string[],
    private readonly state = mkdtempSync(join(tmpdir(), "mlab-state-")),
  ) {
    const command = process.env.MLAB_COMMAND ?? "mlab";
    const port = options.includes("--port") ? [] : ["--port", "0"];
    this.process = spawn(command, [what, "--no-browser", ...port, ...options], {
      stdio: ["ignore", "pipe", "pipe"],
      env: { ...process.env, XDG_STATE_HOME: this.state },
    });
    this.ended = new Promise((resolve) => this.process.on("exit", resolve));
    for (const stream of [this.process.stdout, this.process.stderr]) {
      stream?.on("data", (bytes: Buffer) => {
        this.output += bytes.toString();
      });
    }
  }

  /** Starts it, as `mlab run OPTIONS`, and waits for its address. */
  static start(...options: string[]): Promise<Mlab> {
    return Mlab.answering(new Mlab("run", options));
  }

  /** As `start`, with the folder of what one before it remembered. */
  static startAgain(state: string, ...options: string[]): Promise<Mlab> {
    return Mlab.answering(new Mlab("run", options, state));
  }

  /** As `mlab replay OPTIONS`. */
  static replay(...options: string[]): Promise<Mlab> {
    return Mlab.answering(new Mlab("replay", options));
  }

  /** As `mlab edit OPTIONS`. `state`: the folder of what one before it remembered. */
  static edit(options: string[], state?: string): Promise<Mlab> {
    return Mlab.answering(new Mlab("edit", options, state));
  }

  private static async answering(mlab: Mlab): Promise<Mlab> {
    for (let tries = 0; mlab.url === ""; tries++) {
      if (tries > 1000 || mlab.process.exitCode !== null) throw new Error(`mlab did not start:\n${mlab.output}`);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    return mlab;
  }

  /** With its token. */
  get url(): string {
    return /https?:\/\/\S+/.exec(this.output)?.[0] ?? "";
  }

  /** It is there, and does nothing, until `thaw`. */
  freeze(): void {
    this.process.kill("SIGSTOP");
  }

  thaw(): void {
    this.process.kill("SIGCONT");
  }

  /** As when the machine is switched off: nothing is said to it. @returns the folder of what it remembers */
  async kill(): Promise<string> {
    this.process.kill("SIGKILL");
    await this.ended;
    return this.state;
  }

  /** As `stop`, but what it remembers stays: for one that is started again. */
  async end(): Promise<void> {
    if (this.process.exitCode === null) this.process.kill("SIGINT");
    await this.ended;
  }

  /** As Ctrl-C. @returns the exit status. @throws where it had crashed, with what it printed */
  async stop(): Promise<number | null> {
    const crash = this.process.signalCode;
    this.thaw();
    if (this.process.exitCode === null) this.process.kill("SIGINT");
    const status = await this.ended;
    rmSync(this.state, { recursive: true, force: true });
    if (crash && crash !== "SIGKILL") throw new Error(`mlab ended by ${crash}:\n${this.output}`);
    return status;
  }
}
