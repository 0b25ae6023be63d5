import { type ChildProcess, spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { onTestFinished } from "vitest";

/** A running `mlab agent`, or the process of a vehicle, which ends with the test. */
export class Agent {
  private readonly process: ChildProcess;
  private readonly state = mkdtempSync(join(tmpdir(), "mlab-agent-"));
  output = "";

  private constructor(fleet: string, name: string, words: readonly string[]) {
    this.process = spawn(process.env.MLAB_COMMAND ?? "mlab", [...words, "--fleet", fleet, "--name", name], {
      stdio: ["ignore", "pipe", "pipe"],
      env: { ...process.env, XDG_STATE_HOME: this.state },
    });
    for (const stream of [this.process.stdout, this.process.stderr]) {
      stream?.on("data", (bytes: Buffer) => {
        this.output += bytes.toString();
      });
    }
  }

  static start(fleet: string, name: string): Promise<Agent> {
    return Agent.begun(new Agent(fleet, name, ["agent"]), "waits for runs");
  }

  /** A vehicle that is simulated, in its process. `at`: `8,12,0`. */
  static vehicle(fleet: string, name: string, at: string): Promise<Agent> {
    const words = ["robot", "--binding", "simulated", "--at", at];
    return Agent.begun(new Agent(fleet, name, words), "waits for a run to drive it");
  }

  private static async begun(agent: Agent, said: string): Promise<Agent> {
    onTestFinished(() => agent.stop());
    await agent.says(said);
    return agent;
  }

  async says(text: string): Promise<void> {
    for (let tries = 0; !this.output.includes(text); tries++) {
      if (tries > 1500 || this.process.exitCode !== null) throw new Error(`not said: ${text}\n${this.output}`);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  /** It is there, and does nothing, until `thaw`. */
  freeze(): void {
    this.process.kill("SIGSTOP");
  }

  thaw(): void {
    this.process.kill("SIGCONT");
  }

  /** As when the machine is switched off: nothing is said to anybody. */
  async kill(): Promise<void> {
    const ended = new Promise((resolve) => this.process.on("exit", resolve));
    this.process.kill("SIGKILL");
    await ended;
  }

  private async stop(): Promise<void> {
    const ended = new Promise((resolve) => this.process.on("exit", resolve));
    this.thaw();
    const runs = this.process.exitCode === null && this.process.signalCode === null;
    if (runs && this.process.kill("SIGINT")) await ended;
    rmSync(this.state, { recursive: true, force: true });
  }
}
