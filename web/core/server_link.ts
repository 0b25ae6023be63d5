// A WebSocket to the server: keeps coming back, pairs requests with their answers, and notices when nothing answers
// though it is open. What the messages say is its user's.
import { Pulse } from "./pulse.ts";

const kShortestPause = 250; // ms before the first new attempt, doubled with each
const kLongestPause = 5000;
const kDead = 10_000; // ms of silence, and the socket is given up: another one may come through
const kMostBuffered = 256 * 1024; // bytes; beyond, what wants no answer is left out

export interface LinkState {
  /** "refused": the server doesn't take the token or the protocol. */
  readonly state: "connecting" | "open" | "lost" | "refused";
  /** Why, for a person; empty while all is well. */
  readonly reason: string;
  /** When the next attempt is made, as Date.now(); 0: none is planned. */
  readonly retryAt: number;
  /** When the last sign of the server came, as Date.now(), where it is silent or lost; 0: it answers, or never did. */
  readonly silentSince: number;
}

/** How the two sides talk: `Body` is what is asked, `Message` what comes, `Answer` what the one who asked gets. */
export interface Speech<Body, Message, Answer extends { request: number }> {
  encode(request: number, body: Body): Uint8Array<ArrayBuffer>;
  /** Throws on bytes that are no message. */
  decode(bytes: Uint8Array): Message;
  answerIn(message: Message): Answer | undefined;
  refusal(request: number, error: string): Answer;
  /** Whether the server lets us in by this. */
  isWelcome(message: Message): boolean;
  beat(number: bigint): Body;
  /** The number of a beat that came. */
  beatIn(message: Message): bigint | undefined;
}

export interface LinkOptions<Body, Message, Answer extends { request: number }> {
  /** The page's address; the token is its query's `token`. */
  readonly page: URL;
  /** Of the socket, beside the page. */
  readonly path: string;
  readonly speech: Speech<Body, Message, Answer>;
  /** The socket is open: time to say who we are. */
  readonly opened: () => void;
  /** Whatever is not an answer. */
  readonly receive: (message: Message) => void;
  readonly changed: (state: LinkState) => void;
  /** Whether a server is there that does not know the page's token. Replaced in tests. */
  readonly isStranger?: ((page: URL) => Promise<boolean>) | undefined;
  /** Replaced in tests. */
  readonly open?: ((url: string) => WebSocket) | undefined;
}

export class ServerLink<Body, Message, Answer extends { request: number }> {
  private socket: WebSocket | null = null;
  private lastRequest = 0;
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private attempts = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private reason = "";
  private isClosed = false;
  private isWelcome = false;
  /** The server has been started anew, with another token. */
  private isStranger = false;

  private silentSince = 0;
  private readonly pulse = new Pulse({
    send: (number) => this.tell(this.options.speech.beat(number)),
    changed: (since) => this.fallSilent(since),
  });
  private givesUp: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly options: LinkOptions<Body, Message, Answer>) {}

  connect(): void {
    clearTimeout(this.timer);
    if (this.socket || this.isClosed) return;
    if (!this.isStranger) this.tellState(this.attempts ? "lost" : "connecting", this.reason);
    const open = this.options.open ?? ((url: string) => new WebSocket(url));
    const socket = open(withToken(this.options.page, this.options.path).replace(/^http/, "ws"));
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    this.isWelcome = false;
    socket.onopen = () => this.options.opened();
    socket.onmessage = (event) => this.receive(event.data);
    socket.onclose = (event) => this.lose(socket, event);
    // A handshake may be swallowed as well.
    this.givesUp = setTimeout(() => this.abandon(socket), kDead);
  }

  /** For good, as when the page is left. */
  close(): void {
    this.isClosed = true;
    clearTimeout(this.timer);
    this.endPulse();
    this.socket?.close();
  }

  get isOpen(): boolean {
    return this.socket?.readyState === 1;
  }

  /** The answer says what was wrong where it was not ok. Never throws: a lost connection is such an answer too. */
  ask(body: Body): Promise<Answer> {
    const request = ++this.lastRequest;
    const { encode, refusal } = this.options.speech;
    if (!this.isOpen) return Promise.resolve(refusal(request, "there is no connection to the server"));
    return new Promise((resolve) => {
      this.waiting.set(request, resolve);
      this.socket!.send(encode(request, body));
    });
  }

  /** Without an answer. False where it was not sent: no connection, or so slow that it would only pile up. */
  tell(body: Body): boolean {
    if (!this.isOpen || this.socket!.bufferedAmount > kMostBuffered) return false;
    this.socket!.send(this.options.speech.encode(0, body));
    return true;
  }

  private receive(data: unknown): void {
    if (!(data instanceof ArrayBuffer)) return;
    const { speech } = this.options;
    const message = speech.decode(new Uint8Array(data));
    const beat = speech.beatIn(message);
    this.pulse.heard(beat);
    if (beat !== undefined) return;
    const answer = speech.answerIn(message);
    if (answer) {
      this.waiting.get(answer.request)?.(answer);
      this.waiting.delete(answer.request);
      return;
    }
    if (speech.isWelcome(message)) {
      this.attempts = 0;
      this.isWelcome = true;
      this.isStranger = false;
      clearTimeout(this.givesUp);
      this.silentSince = 0;
      this.tellState("open", "");
      this.pulse.start();
    }
    this.options.receive(message);
  }

  private lose(socket: WebSocket, event: { code: number; reason: string }): void {
    if (this.socket !== socket) return;
    this.socket = null;
    if (this.isWelcome) this.silentSince ||= this.pulse.lastSign;
    this.endPulse();
    const { refusal } = this.options.speech;
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

  /** The socket is open and nothing comes, or nothing arrives there. */
  private fallSilent(since: number): void {
    this.silentSince = since;
    clearTimeout(this.givesUp);
    const { socket } = this;
    if (since !== 0 && socket) {
      this.givesUp = setTimeout(() => this.abandon(socket), Math.max(0, since + kDead - Date.now()));
    }
    this.tellState("open", "");
  }

  /** A line that swallows everything never closes by itself. */
  private abandon(socket: WebSocket): void {
    if (this.socket !== socket) return;
    socket.onopen = socket.onmessage = socket.onclose = null;
    socket.close();
    this.lose(socket, { code: 1006, reason: "the server has not answered for a while" });
  }

  private endPulse(): void {
    this.pulse.stop();
    clearTimeout(this.givesUp);
  }

  /** To a WebSocket a refused token looks as if no server was there. */
  private async lookForStranger(): Promise<void> {
    const look = this.options.isStranger ?? refusesToken;
    if (!(await look(this.options.page)) || this.isOpen || this.isClosed) return;
    this.isStranger = true;
    this.tellState("refused", "mlab was started anew, and has another address now");
  }

  private tellState(state: LinkState["state"], reason: string, retryAt = 0): void {
    this.reason = reason;
    this.options.changed({ state, reason, retryAt, silentSince: this.silentSince });
  }
}

async function refusesToken(page: URL): Promise<boolean> {
  try {
    return (await fetch(withToken(page, "health"), { cache: "no-store" })).status === 403;
  } catch {
    return false; // nobody answers
  }
}

/** Another address of the page's server, with the token. */
export function withToken(page: URL, path: string): string {
  const url = new URL(path.replace(/^\//, ""), page);
  const token = page.searchParams.get("token");
  url.search = "";
  url.hash = "";
  if (token) url.searchParams.set("token", token);
  return url.href;
}
