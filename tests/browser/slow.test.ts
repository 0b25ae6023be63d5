// A client that never says it has drawn a frame, as one on a very slow line or a stuck computer.
import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { decodeToBrowser, encodeToServer, HelloSchema, kProtocol, WatchSchema } from "../../web/core/protocol.ts";
import { begin, look } from "./begin.ts";
import type { Console } from "./console.ts";

/** Opens a second session in the page, by bare messages. What comes is counted by kind. */
async function openDeafClient(console: Console): Promise<() => Promise<Record<string, number>>> {
  const hello = encodeToServer(0, {
    case: "hello",
    value: create(HelloSchema, { protocol: kProtocol, name: "slow", clientKey: "slow" }),
  });
  const watch = encodeToServer(0, { case: "watch", value: create(WatchSchema, { rate: 60, withVectors: true }) });
  await console.page.evaluate(
    ([first, second]) => {
      const socket = new WebSocket(`${location.origin.replace("http", "ws")}/session${location.search}`);
      socket.binaryType = "arraybuffer";
      const got: number[][] = [];
      Object.assign(window, { deaf: { socket, got } });
      socket.onmessage = (event) => got.push([...new Uint8Array(event.data as ArrayBuffer)]);
      return new Promise<void>((resolve) => {
        socket.onopen = () => {
          socket.send(new Uint8Array(first as number[]));
          socket.send(new Uint8Array(second as number[]));
          resolve();
        };
      });
    },
    [[...hello], [...watch]],
  );
  return async () => {
    const got = await console.page.evaluate(() => (window as unknown as { deaf: { got: number[][] } }).deaf.got);
    const counts: Record<string, number> = {};
    for (const bytes of got) {
      const { body } = decodeToBrowser(Uint8Array.from(bytes));
      const kind = body.case ?? "nothing";
      counts[kind] = (counts[kind] ?? 0) + 1;
      if (body.case === "questions" && body.value.questions.length > 0) counts.asked = (counts.asked ?? 0) + 1;
    }
    return counts;
  };
}

test("who never acknowledges gets two frames and every question, and slows nobody", async () => {
  const { console, mlab } = await begin({ mission: "demo_c" });
  const other = await look(mlab);
  const heard = await openDeafClient(other);
  await console.setSpeed("×10");
  await console.main.click();
  await console.reaches("Running");
  await console.passes(20);
  // The speed that was asked for is kept.
  await expect
    .poll(() => console.page.evaluate(() => document.querySelector("[aria-label^='Speed ']")?.textContent ?? ""))
    .not.toContain("reached");
  await console.questions
    .getByRole("button", { name: /^PROCEED/ })
    .first()
    .waitFor({ timeout: 120_000 });
  await expect.poll(async () => (await heard()).asked ?? 0).toBeGreaterThan(0);
  const counts = await heard();
  expect(counts.frame).toBeLessThanOrEqual(2);
  expect(counts.status).toBeGreaterThan(2);
});

// Ten times slower than a machine that may itself be slow.
test("a browser with a tenth of its speed follows, is asked, and slows nobody", async () => {
  const { console, mlab } = await begin({ mission: "demo_c" });
  const slow = await look(mlab);
  await slow.reaches("Ready");
  const session = await slow.page.context().newCDPSession(slow.page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: 10 });
  await console.main.click();
  const proceed = { name: /^PROCEED/ };
  await console.questions.getByRole("button", proceed).first().waitFor({ timeout: 250_000 });
  await slow.questions.getByRole("button", proceed).first().waitFor({ timeout: 250_000 });
  await console.questions.getByRole("button", proceed).first().click();
  await console.reaches("Running");
  await console.passes(20);
  // It has not fallen behind: when time stands still it soon shows the same.
  await console.button("Pause").click();
  await console.reaches("Paused");
  const time = await console.time();
  await expect.poll(() => slow.time(), { timeout: 30_000 }).toBe(time);
}, 360_000);
