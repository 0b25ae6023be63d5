// The session's connection to the server: says Hello and what it watches, and acknowledges frames once drawn.
import { create } from "@bufbuild/protobuf";
import type { Model } from "./model.ts";
import {
  decodeToBrowser,
  encodeToServer,
  kProtocol,
  type Order,
  type Reply,
  ReplySchema,
  type ToBrowser,
} from "./protocol.ts";
import { ServerLink, type Speech, withToken } from "./server_link.ts";
import { Watching } from "./watching.ts";

const kLongestPost = 5000; // ms until a stop that was posted counts as lost

/** What the browser gives, replaced in tests. */
export interface Surroundings {
  open(url: string): WebSocket;
  /** Calls back when what was changed until now has been drawn. */
  afterDrawing(done: () => void): void;
  post(url: string): Promise<boolean>;
  /** Whether a server is there that does not know the page's token; by asking it, where nothing else is said. */
  isStranger?(page: URL): Promise<boolean>;
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
  private readonly link: ServerLink<Order, ToBrowser, Reply>;
  private readonly surroundings: Surroundings;

  constructor(
    readonly model: Model,
    private readonly options: ConnectionOptions,
  ) {
    this.surroundings = options.surroundings ?? kBrowser;
    const { open, isStranger } = this.surroundings;
    this.link = new ServerLink({
      page: options.page,
      path: "session",
      speech: kSpeech,
      opened: () => this.hello(),
      receive: (message) => this.receive(message),
      changed: (link) => model.set("link", link),
      open,
      isStranger,
    });
  }

  connect(): void {
    this.link.connect();
  }

  /** Ends it for good, as when the page is left. */
  close(): void {
    this.link.close();
  }

  /** As ServerLink does. */
  ask(order: Order): Promise<Reply> {
    return this.link.ask(order);
  }

  /** As ServerLink does. */
  tell(order: Order): boolean {
    return this.link.tell(order);
  }

  /**
   * By both ways at once, the socket and a request of its own. True as soon as one of them arrived, false when neither
   * did. For the request nobody waits long; but it stays on its way, and stops the robots also where it arrives late.
   */
  emergencyStop(): Promise<boolean> {
    const asked = this.ask({ case: "emergencyStop", value: {} }).then(({ ok }) => ok);
    const posted = this.surroundings.post(withToken(this.options.page, "stop"));
    const late = new Promise<boolean>((resolve) => setTimeout(() => resolve(false), kLongestPost));
    return Promise.any([asked, Promise.race([posted, late])].map(arrived)).catch(() => false);
  }

  /** `/report` and the like, with the token. */
  url(path: string): string {
    return withToken(this.options.page, path);
  }

  private hello(): void {
    const { name = "", clientKey } = this.options;
    this.tell({ case: "hello", value: { protocol: kProtocol, name, clientKey } });
    this.watching.flush();
  }

  private receive(message: ToBrowser): void {
    this.model.accept(message);
    const { body } = message;
    if (body.case !== "frame") return;
    const frame = body.value.number;
    this.surroundings.afterDrawing(() => this.tell({ case: "acknowledge", value: { frame } }));
  }
}

/** Fails where it did not arrive. */
async function arrived(way: Promise<boolean>): Promise<true> {
  if (!(await way)) throw new Error("it did not arrive");
  return true;
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

const kSpeech: Speech<Order, ToBrowser, Reply> = {
  encode: encodeToServer,
  decode: decodeToBrowser,
  answerIn: ({ body }) => (body.case === "reply" ? body.value : undefined),
  refusal: (request, error) => create(ReplySchema, { request, ok: false, error }),
  isWelcome: ({ body }) => body.case === "welcome",
  beat: (number) => ({ case: "beat", value: { number } }),
  beatIn: ({ body }) => (body.case === "beat" ? body.value.number : undefined),
};

const kBrowser: Surroundings = {
  open: (url) => new WebSocket(url),
  // A hidden page draws nothing: then twice a second is enough to stay in the picture.
  afterDrawing(done) {
    if (document.visibilityState === "hidden") setTimeout(done, 500);
    else requestAnimationFrame(done);
  },
  post: async (url) => (await fetch(url, { method: "POST" })).ok,
};
