// What the server and the browser have to agree on, whatever the page shows.
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Mlab, missions } from "./mlab.ts";
import { openPage } from "./open_page.ts";

let mlab: Mlab;

beforeAll(async () => {
  mlab = await Mlab.start(join(missions, "demo_c", "demo_c.mdl"));
});
afterAll(async () => {
  await mlab?.stop();
});

test("the page loads under its content security policy and opens its session", async () => {
  const page = await openPage();
  const troubles: string[] = [];
  page.on("pageerror", (error) => troubles.push(String(error)));
  page.on("console", (message) => message.type() === "error" && troubles.push(message.text()));
  const asked: string[] = [];
  page.on("request", (request) => asked.push(request.url()));
  const socket = page.waitForEvent("websocket");
  await page.goto(mlab.url);
  const session = await socket;
  await session.waitForEvent("framereceived");
  const execute = page.getByRole("button", { name: /execute/i });
  await execute.first().waitFor({ timeout: 100_000 });
  expect(troubles).toEqual([]);
  const origin = new URL(mlab.url).origin;
  expect(asked.filter((url) => !url.startsWith(origin) && !/^(data|blob):/.test(url))).toEqual([]);
  expect(session.url()).toContain(`/session?token=${new URL(mlab.url).searchParams.get("token")}`);
  await page.context().close();
});

test("without its token the page says how to open it", async () => {
  const page = await openPage();
  const response = await page.goto(new URL(mlab.url).origin);
  expect(response?.status()).toBe(403);
  expect(await page.textContent("body")).toContain("address that `mlab run` or `mlab edit` printed");
  await page.context().close();
});

test("a page of another origin reaches neither session, stop nor report", async () => {
  const other = await Mlab.start();
  const page = await openPage();
  await page.goto(other.url);
  const answers = await page.evaluate(async (url) => {
    const { origin, search } = new URL(url);
    const ask = (path: string, method: string) =>
      fetch(origin + path + search, { method, mode: "no-cors" }).then(
        () => "answered",
        () => "refused",
      );
    const socket = await new Promise((resolve) => {
      try {
        const attempt = new WebSocket(`${origin.replace("http", "ws")}/session${search}`);
        attempt.onopen = () => resolve("answered");
        attempt.onerror = () => resolve("refused");
      } catch {
        resolve("refused");
      }
    });
    return [socket, await ask("/report", "GET"), await ask("/stop", "POST")];
  }, mlab.url);
  expect(answers).toEqual(["refused", "refused", "refused"]);
  await page.context().close();
  await other.stop();
});

test("the emergency stop on its own path stops", async () => {
  const url = new URL(mlab.url);
  const response = await fetch(`${url.origin}/stop${url.search}`, { method: "POST" });
  expect(response.status).toBe(200);
  const page = await openPage();
  await page.goto(mlab.url);
  await page.getByText("EMERGENCY STOP: all robots stand and take no orders").waitFor({ timeout: 100_000 });
  await page.context().close();
});

test("the page says so when the server is gone, and offers nothing that could not be done", async () => {
  const gone = await Mlab.start(join(missions, "demo_c", "demo_c.mdl"));
  const page = await openPage();
  await page.goto(gone.url);
  await page.getByTestId("start-button").filter({ hasText: "Execute" }).waitFor();
  await gone.stop();
  await page.getByText(/Connection lost/).waitFor();
  expect(await page.getByTestId("main-button").isDisabled()).toBe(true);
  expect(await page.getByTestId("start-button").isDisabled()).toBe(true);
  await page.context().close();
});

test("a page that was left open finds its way back to a server that was killed and started again", async () => {
  const mission = join(missions, "demo_c", "demo_c.mdl");
  const first = await Mlab.start(mission);
  const page = await openPage();
  await page.goto(first.url);
  const execute = page.getByTestId("start-button").filter({ hasText: "Execute" });
  await execute.waitFor();
  const state = await first.kill();
  await page.getByText(/Connection lost/).waitFor();
  const again = await Mlab.startAgain(state, mission, "--port", new URL(first.url).port);
  expect(again.url).toBe(first.url);
  await page.getByText(/Connection lost/).waitFor({ state: "detached" });
  await execute.click();
  await page.getByTestId("run-state").filter({ hasText: "Running" }).waitFor();
  await page.context().close();
  await again.stop();
});

test("a mission that nobody started is no failure", async () => {
  expect(await mlab.stop()).toBe(0);
});
