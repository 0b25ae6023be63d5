import { create, fromBinary, type MessageInitShape, toBinary } from "@bufbuild/protobuf";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Connection } from "./connection.ts";
import { Model } from "./model.ts";
import { Control_Action, ToBrowserSchema, type ToServer, ToServerSchema } from "./protocol.ts";

type Body = NonNullable<MessageInitShape<typeof ToBrowserSchema>["body"]>;

class FakeSocket {
  readyState = 0;
  bufferedAmount = 0;
  binaryType = "";
  sent: ToServer[] = [];
  onopen: ((event: Event) => void) | null = null;
  onmessage: ((event: MessageEvent) => void) | null = null;
  onclose: ((event: CloseEvent) => void) | null = null;

  constructor(readonly url: string) {}

  send(bytes: Uint8Array): void {
    this.sent.push(fromBinary(ToServerSchema, bytes));
  }
  close(): void {
    this.fail(1000);
  }
  open(): void {
    this.readyState = 1;
    this.onopen?.(new Event("open"));
  }
  fail(code: number, reason = ""): void {
    this.readyState = 3;
    this.onclose?.({ code, reason } as CloseEvent);
  }
  say(body: Body): void {
    const bytes = toBinary(ToBrowserSchema, create(ToBrowserSchema, { body }));
    this.onmessage?.(new MessageEvent("message", { data: bytes.slice().buffer }));
  }
  get cases(): (string | undefined)[] {
    return this.sent.map(({ body }) => body.case);
  }
}

let sockets: FakeSocket[] = [];
let drawings: (() => void)[] = [];
let posted: string[] = [];
let post: () => Promise<boolean>;

function connect(): { connection: Connection; model: Model; socket: FakeSocket } {
  const model = new Model();
  const connection = new Connection(model, {
    page: new URL("http://127.0.0.1:8080/?token=abc&theme=dark"),
    name: "Ada",
    clientKey: "key",
    surroundings: {
      open(url) {
        sockets.push(new FakeSocket(url));
        return sockets.at(-1) as unknown as WebSocket;
      },
      afterDrawing: (done) => void drawings.push(done),
      post(url) {
        posted.push(url);
        return post();
      },
      isStranger: async () => false,
    },
  });
  connection.connect();
  return { connection, model, socket: sockets.at(-1)! };
}

beforeEach(() => {
  vi.useFakeTimers();
  sockets = [];
  drawings = [];
  posted = [];
  post = async () => true;
});
afterEach(() => {
  vi.useRealTimers();
});

test("it goes to the session with the page's token, and says hello and what it watches", () => {
  const { socket, model } = connect();
  expect(socket.url).toBe("ws://127.0.0.1:8080/session?token=abc");
  socket.open();
  expect(socket.cases).toEqual(["hello", "watch"]);
  expect(socket.sent[0]!.body.value).toMatchObject({ protocol: 1, name: "Ada", clientKey: "key" });
  socket.say({ case: "welcome", value: { client: 3, session: "s" } });
  expect(model.get("link").state).toBe("open");
  expect(model.get("welcome")?.client).toBe(3);
});

test("a question gets its own answer, in whatever order they come", async () => {
  const { connection, socket } = connect();
  socket.open();
  const first = connection.ask({ case: "control", value: { action: Control_Action.EXECUTE } });
  const second = connection.ask({ case: "undo", value: {} });
  const [a, b] = socket.sent.slice(-2).map(({ request }) => request);
  socket.say({ case: "reply", value: { request: b!, ok: true } });
  socket.say({ case: "reply", value: { request: a!, ok: false, error: "no" } });
  expect((await second).ok).toBe(true);
  expect((await first).error).toBe("no");
});

test("a lost connection answers all that is open, and tells that it is lost", async () => {
  const { connection, model, socket } = connect();
  socket.open();
  const open = connection.ask({ case: "undo", value: {} });
  socket.fail(1006);
  expect((await open).ok).toBe(false);
  expect(model.get("link").state).toBe("lost");
  expect((await connection.ask({ case: "redo", value: {} })).error).toContain("no connection");
});

test("it comes back by itself, more patiently each time, and watches the same again", () => {
  const { connection } = connect();
  sockets[0]!.open();
  connection.watching.wish("map", { rate: 60 });
  sockets[0]!.fail(1006);
  const waits: number[] = [];
  for (let attempt = 1; attempt < 8; ++attempt) {
    const begin = Date.now();
    while (sockets.length <= attempt) vi.advanceTimersByTime(10);
    waits.push(Date.now() - begin);
    if (attempt < 7) sockets[attempt]!.fail(1006);
  }
  expect(waits[0]).toBeLessThan(400);
  expect(waits[3]!).toBeGreaterThan(waits[0]!);
  expect(Math.max(...waits)).toBeLessThanOrEqual(6100);
  sockets[7]!.open();
  expect(sockets[7]!.sent[1]!.body.value).toMatchObject({ rate: 60 });
});

test("who is refused does not knock again", () => {
  const { model, socket } = connect();
  socket.fail(1008, "the token is not right");
  vi.advanceTimersByTime(60_000);
  expect(sockets).toHaveLength(1);
  expect(model.get("link")).toMatchObject({ state: "refused", reason: "the token is not right" });
});

test("a frame is acknowledged when it has been drawn, not before", () => {
  const { socket } = connect();
  socket.open();
  socket.say({ case: "frame", value: { number: 41n, time: 1 } });
  expect(socket.cases).not.toContain("acknowledge");
  for (const drawn of drawings) drawn();
  expect(socket.sent.at(-1)!.body).toMatchObject({ case: "acknowledge", value: { frame: 41n } });
});

test("where the line is clogged nothing more is put into it", () => {
  const { connection, socket } = connect();
  socket.open();
  socket.bufferedAmount = 10_000_000;
  expect(connection.tell({ case: "stick", value: { unit: "u", x: 1 } })).toBe(false);
});

test("an open socket from which nothing comes is told as silent, and given up after a while", async () => {
  const { connection, model, socket } = connect();
  socket.open();
  socket.say({ case: "welcome", value: { client: 3, session: "s" } });
  const number = () => socket.sent.findLast(({ body }) => body.case === "beat")?.body.value as { number: bigint };
  socket.say({ case: "beat", value: { number: number().number } });
  const last = Date.now();
  vi.advanceTimersByTime(1_500);
  expect(model.get("link")).toMatchObject({ state: "open", silentSince: last });
  socket.say({ case: "beat", value: { number: number().number } });
  expect(model.get("link").silentSince).toBe(0);
  const asked = connection.ask({ case: "undo", value: {} });
  vi.advanceTimersByTime(17_000);
  expect((await asked).ok).toBe(false);
  expect(model.get("link").state).toBe("lost");
  expect(model.get("link").silentSince).toBeGreaterThan(0);
  expect(sockets.length).toBe(2);
  sockets[1]!.open();
  sockets[1]!.say({ case: "welcome", value: { client: 3, session: "s" } });
  expect(model.get("link")).toMatchObject({ state: "open", silentSince: 0 });
});

test("a handshake that is swallowed is tried again", () => {
  connect();
  vi.advanceTimersByTime(17_000);
  expect(sockets.length).toBe(2);
});

test("an emergency stop goes both ways, and counts when one of them arrived", async () => {
  const { connection, socket } = connect();
  socket.open();
  const stopped = connection.emergencyStop();
  expect(socket.cases).toContain("emergencyStop");
  expect(posted).toEqual(["http://127.0.0.1:8080/stop?token=abc"]);
  socket.fail(1006);
  expect(await stopped).toBe(true);
});

test("an emergency stop that the server confirms does not wait for the other way", async () => {
  post = () => new Promise(() => {});
  const { connection, socket } = connect();
  socket.open();
  const stopped = connection.emergencyStop();
  const request = socket.sent.findLast(({ body }) => body.case === "emergencyStop")!.request;
  socket.say({ case: "reply", value: { request, ok: true } });
  expect(await stopped).toBe(true);
});

test("an emergency stop that was posted does not wait for a silent socket", async () => {
  const { connection, socket } = connect();
  socket.open();
  expect(await connection.emergencyStop()).toBe(true);
  expect(socket.cases).toContain("emergencyStop");
});

test("an emergency stop that goes neither way is told within seconds", async () => {
  post = () => new Promise(() => {});
  const { connection } = connect();
  let stopped: boolean | undefined;
  void connection.emergencyStop().then((ok) => {
    stopped = ok;
  });
  await vi.advanceTimersByTimeAsync(4_000);
  expect(stopped).toBeUndefined();
  await vi.advanceTimersByTimeAsync(1_500);
  expect(stopped).toBe(false);
  expect(posted).toHaveLength(1);
});

test("an emergency stop that is refused both ways is told at once", async () => {
  post = () => Promise.reject(new TypeError("failed to fetch"));
  const { connection } = connect();
  expect(await connection.emergencyStop()).toBe(false);
});
