// A line between page and server that can begin to swallow what goes through it, while every socket stays open.

import type { AddressInfo } from "node:net";
import { connect as connectTo, createServer, type Socket } from "node:net";

export class SwallowingLine {
  private readonly pairs: { near: Socket; far: Socket; isSwallowed: boolean }[] = [];
  private readonly server = createServer((near) => this.join(near));
  /** What is swallowed from now on: of lines that are there, and of those that come. */
  private isSwallowing = false;

  private constructor(private readonly target: URL) {}

  static async to(url: string): Promise<SwallowingLine> {
    const line = new SwallowingLine(new URL(url));
    await new Promise<void>((resolve) => line.server.listen(0, "127.0.0.1", resolve));
    return line;
  }

  /** The target's address, by this line. */
  get url(): string {
    const url = new URL(this.target);
    url.hostname = "127.0.0.1";
    url.port = String((this.server.address() as AddressInfo).port);
    return url.href;
  }

  /** What is on its way is gone for good: lines that are there stay deaf. */
  swallow(): void {
    this.isSwallowing = true;
    for (const pair of this.pairs) pair.isSwallowed = true;
  }

  /** Lines that come from now on are whole. */
  heal(): void {
    this.isSwallowing = false;
  }

  async close(): Promise<void> {
    for (const { near, far } of this.pairs) for (const socket of [near, far]) socket.destroy();
    await new Promise((resolve) => this.server.close(resolve));
  }

  private join(near: Socket): void {
    const far = connectTo(Number(this.target.port), this.target.hostname);
    const pair = { near, far, isSwallowed: this.isSwallowing };
    this.pairs.push(pair);
    const own = new URL(this.url).host;
    // The server answers to its own name alone.
    const renamed = (bytes: Buffer) => {
      const text = bytes.toString("latin1");
      return text.includes(own) ? Buffer.from(text.replaceAll(own, this.target.host), "latin1") : bytes;
    };
    near.on("data", (bytes) => pair.isSwallowed || far.write(renamed(bytes)));
    far.on("data", (bytes) => pair.isSwallowed || near.write(bytes));
    for (const [one, other] of [
      [near, far],
      [far, near],
    ] as const) {
      one.on("error", () => other.destroy());
      one.on("close", () => pair.isSwallowed || other.destroy());
    }
  }
}
