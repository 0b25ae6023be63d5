import { create, fromBinary, toBinary } from "@bufbuild/protobuf";
import { expect, test, vi } from "vitest";
import { type LinkState, withToken } from "../../core/server_link.ts";
import { linkTo } from "./link.ts";
import { type FromDesigner, FromDesignerSchema, ToDesignerSchema } from "./protocol.ts";

const page = new URL("http://127.0.0.1:8080/designer.html?token=abc#file=a.cdl");

class Socket {
  readyState = 0;
  bufferedAmount = 0;
  binaryType = "";
  sent: ReturnType<typeof decode>[] = [];
  onopen = () => {};
  onmessage = (_: { data: unknown }) => {};
  onclose = (_: { code: number; reason: string }) => {};
  constructor(readonly url: string) {}
  send(bytes: Uint8Array) {
    this.sent.push(decode(bytes));
  }
  close() {}
  open() {
    this.readyState = 1;
    this.onopen();
  }
  say(body: FromDesigner["body"]) {
    const bytes = toBinary(FromDesignerSchema, create(FromDesignerSchema, { body }));
    this.onmessage({ data: bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength) });
  }
}
const decode = (bytes: Uint8Array) => fromBinary(ToDesignerSchema, bytes);

function begin(isStranger = async () => false) {
  const sockets: Socket[] = [];
  const states: LinkState["state"][] = [];
  const heard: FromDesigner[] = [];
  const link = linkTo({
    page,
    receive: (message) => heard.push(message),
    changed: ({ state }) => states.push(state),
    isStranger,
    open: (url) => {
      sockets.push(new Socket(url));
      return sockets.at(-1) as unknown as WebSocket;
    },
  });
  link.connect();
  return { link, sockets, states, heard };
}

test("addresses carry the token and nothing else", () => {
  expect(begin().sockets[0]!.url).toBe("ws://127.0.0.1:8080/designer?token=abc");
  expect(withToken(page, "./")).toBe("http://127.0.0.1:8080/?token=abc");
});

test("it greets, and pairs answers with what was asked", async () => {
  const { link, sockets, states } = begin();
  const socket = sockets[0]!;
  socket.open();
  expect(socket.sent[0]!.body).toMatchObject({ case: "greeting", value: { protocol: 1 } });
  socket.say({ case: "hello", value: { protocol: 1 } } as FromDesigner["body"]);
  expect(states.at(-1)).toBe("open");
  const first = link.ask({ case: "undo", value: { document: "a" } });
  const second = link.ask({ case: "redo", value: { document: "a" } });
  const [, one, two] = socket.sent.filter(({ body }) => body.case !== "beat");
  socket.say({ case: "answer", value: { request: two!.request, ok: true } } as FromDesigner["body"]);
  socket.say({ case: "answer", value: { request: one!.request, ok: false, error: "no" } } as FromDesigner["body"]);
  expect((await second).ok).toBe(true);
  expect((await first).error).toBe("no");
});

test("what was asked when the connection was lost is answered with that, and it comes back", async () => {
  vi.useFakeTimers();
  const { link, sockets, states } = begin();
  sockets[0]!.open();
  sockets[0]!.say({ case: "hello", value: { protocol: 1 } } as FromDesigner["body"]);
  const asked = link.ask({ case: "undo", value: { document: "a" } });
  sockets[0]!.readyState = 3;
  sockets[0]!.onclose({ code: 1006, reason: "" });
  expect((await asked).error).toMatch(/lost/);
  expect(states.at(-1)).toBe("lost");
  vi.advanceTimersByTime(6000);
  expect(sockets).toHaveLength(2);
  vi.useRealTimers();
});

test("who is not wanted does not come back", () => {
  vi.useFakeTimers();
  const { sockets, states } = begin();
  sockets[0]!.onclose({ code: 1008, reason: "wrong token" });
  expect(states.at(-1)).toBe("refused");
  vi.advanceTimersByTime(20_000);
  expect(sockets).toHaveLength(1);
  vi.useRealTimers();
});

test("a server that was started anew with another address is told from none, and tried on quietly", async () => {
  vi.useFakeTimers();
  const { sockets, states } = begin(async () => true);
  sockets[0]!.onclose({ code: 1006, reason: "" });
  await vi.advanceTimersByTimeAsync(1);
  expect(states.at(-1)).toBe("refused");
  await vi.advanceTimersByTimeAsync(20_000);
  sockets.at(-1)!.onclose({ code: 1006, reason: "" });
  await vi.advanceTimersByTimeAsync(20_000);
  expect(states.filter((state) => state === "refused")).toHaveLength(1);
  expect(sockets.length).toBeGreaterThan(2);
  sockets.at(-1)!.open();
  sockets.at(-1)!.say({ case: "hello", value: { protocol: 1 } } as FromDesigner["body"]);
  expect(states.at(-1)).toBe("open");
  vi.useRealTimers();
});
