// The WebSocket to the server: says Hello, keeps coming back, answers requests, and acknowledges frames once drawn.
import { create } from "@bufbuild/protobuf";
import type { Link, Model } from "./model.ts";
import { decodeToBrowser, encodeToServer, kProtocol, type Order, type Reply, ReplySchema } from "./protocol.ts";
import { Watching } from "./watching.ts";

const kShortestPause = 250; // ms before the first new attempt, doubled with each
const kLongestPause = 5000;
const kMostBuffered = 256 * 1024; // bytes; beyond, acknowledgements and sticks are left out

/** What the browser gives, replaced in tests. */
export interface Surroundings {
  open(url: string): WebSocket;
  /** Calls back when what was changed until now has been drawn. */
  afterDrawing(done: () => void): void;
  post(url: string): Promise<boolean>;
}

export interface ConnectionOptions {
  /** The page's address; the token is its query's `token`. */
  readonly page: URL;
  /** How the person is shown to others. */
  readonly name?: string;
  /** The same for one tab over its reloads. */
  readonly clientKey: string;
  readonly surroundings?: Surroundings;
}

export class Connection {
  readonly watching = new Watching((watch) => this.tell({ case: "watch", value: watch }));
  private socket: WebSocket | null = null;
  private lastRequest = 0;
  private readonly waiting = new Map<number, (reply: Reply) => void>();
  private attempts = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private isClosed = false;
  private isWelcome = false;
  private readonly surroundings: Surroundings;

  constructor(
    readonly model: Model,
    private readonly options: ConnectionOptions,
  ) {
    this.surroundings = options.surroundings ?? kBrowser;
  }

  connect(): void {
    clearTimeout(this.timer);
    if (this.socket || this.isClosed) return;
    this.setLink(this.attempts ? "lost" : "connecting", this.model.get("link").reason);
    const socket = this.surroundings.open(socketUrl(this.options.page));
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    this.isWelcome = false;
    socket.onopen = () => this.hello();
    socket.onmessage = (event) => this.receive(event.data);
    socket.onclose = (event) => this.lose(socket, event);
  }

  /** Ends it for good, as when the page is left. */
  close(): void {
    this.isClosed = true;
    clearTimeout(this.timer);
    this.socket?.close();
  }

  /** The Reply, which says what was wrong where it was not ok. Never throws: a lost connection is such a Reply too. */
  ask(order: Order): Promise<Reply> {
    const request = ++this.lastRequest;
    if (!this.isOpen()) return Promise.resolve(refusal(request, "there is no connection to the server"));
    return new Promise((resolve) => {
      this.waiting.set(request, resolve);
      this.socket!.send(encodeToServer(request, order));
    });
  }

  /** Without an answer. False where it was not sent: no connection, or so slow that it would only pile up. */
  tell(order: Order): boolean {
    if (!this.isOpen() || this.socket!.bufferedAmount > kMostBuffered) return false;
    this.socket!.send(encodeToServer(0, order));
    return true;
  }

  /** By both ways, the socket and a request of its own, whichever is there first. */
  async emergencyStop(): Promise<boolean> {
    const [reply, posted] = await Promise.all([
      this.ask({ case: "emergencyStop", value: {} }),
      this.surroundings.post(pageUrl(this.options.page, "stop")).catch(() => false),
    ]);
    return reply.ok || posted;
  }

  /** `/report` and the like, with the token. */
  url(path: string): string {
    return pageUrl(this.options.page, path);
  }

  private isOpen(): boolean {
    return this.socket?.readyState === 1;
  }

  private hello(): void {
    const { name = "", clientKey } = this.options;
    this.tell({ case: "hello", value: { protocol: kProtocol, name, clientKey } });
    this.watching.flush();
  }

  private receive(data: unknown): void {
    if (!(data instanceof ArrayBuffer)) return;
    const message = decodeToBrowser(new Uint8Array(data));
    const { body } = message;
    if (body.case === "reply") {
      this.waiting.get(body.value.request)?.(body.value);
      this.waiting.delete(body.value.request);
      return;
    }
    if (body.case === "welcome") {
      this.attempts = 0;
      this.isWelcome = true;
      this.setLink("open", "");
    }
    this.model.accept(message);
    if (body.case === "frame") {
      const frame = body.value.number;
      this.surroundings.afterDrawing(() => this.tell({ case: "acknowledge", value: { frame } }));
    }
  }

  private lose(socket: WebSocket, event: CloseEvent): void {
    if (this.socket !== socket) return;
    this.socket = null;
    for (const [request, resolve] of this.waiting) resolve(refusal(request, "the connection to the server was lost"));
    this.waiting.clear();
    if (this.isClosed) return;
    // 1008: the server does not want us, and would not the next time.
    if (event.code === 1008 && !this.isWelcome) {
      this.setLink("refused", event.reason || "the server refused the connection");
      return;
    }
    const pause = Math.min(kLongestPause, kShortestPause * 2 ** this.attempts) * (0.8 + 0.4 * Math.random());
    ++this.attempts;
    this.timer = setTimeout(() => this.connect(), pause);
    this.setLink("lost", event.reason || "the server does not answer", Date.now() + pause);
  }

  private setLink(state: Link["state"], reason: string, retryAt = 0): void {
    this.model.set("link", { state, reason, retryAt });
  }
}

/** The key by which the server knows this tab again after a reload. */
export function tabKey(storage: Storage): string {
  const known = storage.getItem("mlab.client");
  if (known) return known;
  const key = [...crypto.getRandomValues(new Uint8Array(16))]
    .map((byte) => byte.toString(16).padStart(2, "0"))
    .join("");
  storage.setItem("mlab.client", key);
  return key;
}

function refusal(request: number, error: string): Reply {
  return create(ReplySchema, { request, ok: false, error });
}

function pageUrl(page: URL, path: string): string {
  const url = new URL(path.replace(/^\//, ""), page);
  const token = page.searchParams.get("token");
  url.search = "";
  url.hash = "";
  if (token) url.searchParams.set("token", token);
  return url.href;
}

function socketUrl(page: URL): string {
  return pageUrl(page, "session").replace(/^http/, "ws");
}

const kBrowser: Surroundings = {
  open: (url) => new WebSocket(url),
  // A hidden page draws nothing: then twice a second is enough to stay in the picture.
  afterDrawing(done) {
    if (document.visibilityState === "hidden") setTimeout(done, 500);
    else requestAnimationFrame(done);
  },
  post: async (url) => (await fetch(url, { method: "POST" })).ok,
};
