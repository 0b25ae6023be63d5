// Vehicles that are played by implementations of their protocols that are not ours, each with the `mlab robot` beside it.
import { type ChildProcess, spawn } from "node:child_process";
import { createSocket } from "node:dgram";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { onTestFinished } from "vitest";
import { missions } from "./mlab.ts";

const command = process.env.MLAB_COMMAND ?? "mlab";
/** The source tree. */
export const root = join(missions, "..");
const ros2Robot = join(dirname(command), "mlab_ros2_robot");
const packages = join(dirname(command), "..", "vehicle_peers");

/** Fast DDS and node-mavlink are for tests alone, and not everywhere. */
export const canPlayVehicles = existsSync(ros2Robot) && existsSync(join(packages, "node_modules"));

/** What a run that moves them is told. */
export const movingVehicles = ["--real-time", "--unchecked", "they are played"];

/** A program that ends with the test. */
export class Program {
  private readonly process: ChildProcess;
  private readonly state = mkdtempSync(join(tmpdir(), "mlab-vehicle-"));
  output = "";

  constructor(program: string, words: string[]) {
    // Its standard input stays open: the rover ends where that does.
    this.process = spawn(program, words, { env: { ...process.env, XDG_STATE_HOME: this.state } });
    for (const stream of [this.process.stdout, this.process.stderr]) {
      stream?.on("data", (bytes: Buffer) => {
        this.output += bytes.toString();
      });
    }
    onTestFinished(() => this.stop());
  }

  async says(text: string): Promise<void> {
    for (let tries = 0; !this.output.includes(text); tries++) {
      if (tries > 3000 || this.process.exitCode !== null) throw new Error(`not said: ${text}\n${this.output}`);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  private async stop(): Promise<void> {
    const ended = new Promise((resolve) => this.process.on("exit", resolve));
    const runs = this.process.exitCode === null && this.process.signalCode === null;
    if (runs && this.process.kill("SIGKILL")) await ended;
    rmSync(this.state, { recursive: true, force: true });
  }
}

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const socket = createSocket("udp4");
    socket.bind(0, "127.0.0.1", () => {
      const { port } = socket.address();
      socket.close(() => resolve(port));
    });
  });
}

/** A vehicle, and the `mlab robot` by which runs of the fleet drive it. */
export interface Vehicle {
  played: Program;
  robot: Program;
}

function robotOf(fleet: string, name: string, options: string[]): Program {
  return new Program(command, ["robot", "--fleet", fleet, "--name", name, "--max-speed", "1", ...options]);
}

/** `at`: X,Y,DEGREES. `world`: an overlay of what stands around it. */
export async function startRos2Robot(fleet: string, name: string, at: string, world: string): Promise<Vehicle> {
  const domain = ["--domain", String(1 + (process.pid % 100)), "--namespace", `/${fleet.replaceAll("-", "_")}`];
  const played = new Program(ros2Robot, [...domain, "--at", at, "--world", world, "--log"]);
  await played.says("ready");
  const robot = robotOf(fleet, name, ["--binding", "ros2", ...domain]);
  await robot.says("the vehicle is ready");
  return { played, robot };
}

export async function startMavlinkRover(fleet: string, name: string): Promise<Vehicle> {
  const port = await freePort();
  const robot = robotOf(fleet, name, ["--binding", "mavlink", "--device", `udp:${port}`, "--max-turn-rate", "45"]);
  const script = join(root, "tests", "vehicles", "rover.mjs");
  const played = new Program(process.execPath, [script, packages, String(port), "1", "obstacle=0"]);
  await robot.says("it is not armed");
  return { played, robot };
}
