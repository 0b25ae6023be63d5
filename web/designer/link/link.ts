// The WebSocket to the designer's server: greets, keeps coming back, pairs requests with their answers.
import { create } from "@bufbuild/protobuf";
import { type Answer, AnswerSchema, decode, encode, type FromDesigner, kProtocol, type Request } from "../protocol.ts";

const kShortestPause = 250; // ms before the first new attempt, doubled with each
const kLongestPause = 5000;

export interface LinkState {
  readonly state: "connecting" | "open" | "lost" | "refused";
  readonly reason: string;
  /** When it is tried again, as Date.now(); 0: not by itself. */
  readonly retryAt: number;
}

export interface LinkOptions {
  /** The page's address; the token is its query's `token`. */
  readonly page: URL;
  /** Whatever is not an answer. */
  readonly receive: (message: FromDesigner) => void;
  readonly changed: (state: LinkState) => void;
  /** Whether a server is there that does not know the page's token. Replaced in tests. */
  readonly isStranger?: (page: URL) => Promise<boolean>;
  /** Replaced in tests. */
  readonly open?: (url: string) => WebSocket;
}

export class Link {
  private socket: WebSocket | null = null;
  private lastRequest = 0;
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private attempts = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private isClosed = false;
  private isWelcome = false;
  /** The server has been started anew, with another token. */
  private isStranger = false;

  constructor(private readonly options: LinkOptions) {}

  connect(): void {
    clearTimeout(this.timer);
    if (this.socket || this.isClosed) return;
    if (!this.isStranger) this.tellState(this.attempts ? "lost" : "connecting", "");
    const open = this.options.open ?? ((url: string) => new WebSocket(url));
    const socket = open(addressOf(this.options.page));
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    this.isWelcome = false;
    socket.onopen = () => this.tell({ case: "greeting", value: { protocol: kProtocol } });
    socket.onmessage = (event) => this.receive(event.data);
    socket.onclose = (event) => this.lose(socket, event);
  }

  /** For good, as when the page is left. */
  close(): void {
    this.isClosed = true;
    clearTimeout(this.timer);
    this.socket?.close();
  }

  get isOpen(): boolean {
    return this.socket?.readyState === 1;
  }

  /** The Answer says what was wrong where it was not ok. Never throws: a lost connection is such an Answer too. */
  ask(body: Request): Promise<Answer> {
    const request = ++this.lastRequest;
    if (!this.isOpen) return Promise.resolve(refusal(request, "there is no connection to the server"));
    return new Promise((resolve) => {
      this.waiting.set(request, resolve);
      this.socket!.send(encode(request, body));
    });
  }

  tell(body: Request): void {
    if (this.isOpen) this.socket!.send(encode(0, body));
  }

  private receive(data: unknown): void {
    if (!(data instanceof ArrayBuffer)) return;
    const message = decode(new Uint8Array(data));
    const { body } = message;
    if (body.case === "answer") {
      this.waiting.get(body.value.request)?.(body.value);
      this.waiting.delete(body.value.request);
      return;
    }
    if (body.case === "hello") {
      this.attempts = 0;
      this.isWelcome = true;
      this.isStranger = false;
      this.tellState("open", "");
    }
    this.options.receive(message);
  }

  private lose(socket: WebSocket, event: CloseEvent): void {
    if (this.socket !== socket) return;
    this.socket = null;
    for (const [request, resolve] of this.waiting) resolve(refusal(request, "the connection to the server was lost"));
    this.waiting.clear();
    if (this.isClosed) return;
    // 1008: the server does not want us, and would not the next time.
    if (event.code === 1008 && !this.isWelcome) {
      this.tellState("refused", event.reason || "the server refused the connection");
      return;
    }
    const pause = Math.min(kLongestPause, kShortestPause * 2 ** this.attempts) * (0.8 + 0.4 * Math.random());
    ++this.attempts;
    this.timer = setTimeout(() => this.connect(), pause);
    // It is tried on quietly: a server may come that is given this address again.
    if (this.isStranger) return;
    this.tellState("lost", event.reason || "the server does not answer", Date.now() + pause);
    if (!this.isWelcome) void this.lookForStranger();
  }

  /** To a WebSocket a refused token looks as if no server was there. */
  private async lookForStranger(): Promise<void> {
    const look = this.options.isStranger ?? refusesToken;
    if (!(await look(this.options.page)) || this.isOpen || this.isClosed) return;
    this.isStranger = true;
    this.tellState("refused", "mlab was started anew, and has another address now");
  }

  private tellState(state: LinkState["state"], reason: string, retryAt = 0): void {
    this.options.changed({ state, reason, retryAt });
  }
}

async function refusesToken(page: URL): Promise<boolean> {
  try {
    return (await fetch(withToken(page, "health"), { cache: "no-store" })).status === 403;
  } catch {
    return false; // nobody answers
  }
}

function refusal(request: number, error: string): Answer {
  return create(AnswerSchema, { request, ok: false, error });
}

/** Of the designer's socket, beside the page. */
export function addressOf(page: URL): string {
  return withToken(page, "designer").replace(/^http/, "ws");
}

/** Another address of the same server, with the token. */
export function withToken(page: URL, path: string): string {
  const url = new URL(path, page);
  const token = page.searchParams.get("token");
  url.search = "";
  url.hash = "";
  if (token) url.searchParams.set("token", token);
  return url.href;
}
