// The other future that is asked for: what is chosen in its panel, and what the server answers.
import type { MessageInitShape } from "@bufbuild/protobuf";
import type { Changeable, Changeable_Text, WhatIf_ChangeSchema, WhatIfSchema } from "../../core/protocol.ts";
import { readMoment } from "../../core/run_time.ts";
import { Store } from "../../core/store.ts";
import { offer } from "../../ui/files/offer.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { perSession, type Session } from "../session/session.ts";
import { bookmarksOf } from "./bookmarks.ts";
import { travelOf } from "./time_travel.ts";

export type ChangeKind = "parameter" | "order" | "text";

/** Something that is to be otherwise; what belongs to other kinds than its own is kept, in case one comes back. */
export interface Change {
  readonly id: number;
  readonly kind: ChangeKind;
  /** `1`, or the name of a unit; empty: what is selected. */
  readonly target: string;
  readonly port: string;
  readonly value: string;
  readonly order: string;
  readonly path: string;
  readonly text: string;
}

export interface FutureParts {
  isOpen: boolean;
  /** Another one is asked for, though there is one. */
  isAgain: boolean;
  changes: readonly Change[];
  /** As it is typed; empty: to the end. */
  length: string;
  withoutPeople: boolean;
  /** What can be changed at the moment, by the robot that was asked about. */
  changeable: ReadonlyMap<number, Changeable>;
  isAsking: boolean;
  problem: string;
}

export const kMostChanges = 64;
const kLongest = 7200; // s

const kEmpty = { target: "", port: "", value: "", order: "", path: "", text: "" } as const;

export class FutureStore extends Store<FutureParts> {
  private read = 0;
  private lastId = 1;

  constructor(private readonly session: Session) {
    super({
      isOpen: false,
      isAgain: false,
      changes: [{ ...kEmpty, id: 1, kind: "parameter" }],
      length: "",
      withoutPeople: false,
      changeable: new Map(),
      isAsking: false,
      problem: "",
    });
  }

  /** In the place of the others that stand there. */
  open(): void {
    travelOf(this.session).set("isFinding", false);
    bookmarksOf(this.session).close();
    this.set("isOpen", true);
  }

  /** Closes it where it is seen. */
  toggle(): void {
    const isHidden = travelOf(this.session).get("isFinding") || bookmarksOf(this.session).get("isOpen");
    if (this.get("isOpen") && !isHidden) this.set("isOpen", false);
    else this.open();
  }

  // ---- what is changed

  add(): void {
    const changes = this.get("changes");
    if (changes.length >= kMostChanges) return;
    const last = changes.at(-1);
    this.set("changes", [
      ...changes,
      { ...kEmpty, id: ++this.lastId, kind: last?.kind ?? "parameter", target: last?.target ?? "" },
    ]);
    this.set("problem", "");
  }

  remove(id: number): void {
    this.set(
      "changes",
      this.get("changes").filter((one) => one.id !== id),
    );
    this.set("problem", "");
  }

  alter(id: number, parts: Partial<Omit<Change, "id">>): void {
    this.set(
      "changes",
      this.get("changes").map((one) => (one.id === id ? { ...one, ...parts } : one)),
    );
    this.set("problem", "");
  }

  /** The robots that are meant. */
  robotsOf({ target }: Change): readonly number[] {
    const roster = this.session.model.get("roster");
    if (/^\d+$/.test(target)) return [Number(target)];
    const members = roster.robotsOf(target);
    if (members.length > 0) return members;
    const first = this.session.model.get("selection").robots[0] ?? roster.robots[0]?.id;
    return first === undefined ? [] : [first];
  }

  /** What can be changed of that robot; nothing: it is not known yet. */
  changeableOf(change: Change): Changeable | undefined {
    return this.get("changeable").get(this.robotsOf(change)[0] ?? 0);
  }

  texts(): readonly Changeable_Text[] {
    return [...this.get("changeable").values()][0]?.texts ?? [];
  }

  /** Why nobody but the operator may change a text; nothing: this one may. */
  get whyNoText(): string | undefined {
    return this.session.model.isOperator() ? undefined : "Only the operator can change a design: take control first.";
  }

  /** Why it can't be computed, whatever else is entered. */
  get whyNot(): string | undefined {
    return this.get("changes").some(({ kind }) => kind === "text") ? this.whyNoText : undefined;
  }

  /** About whom the server has to be asked, so that all changes can be made. */
  wanted(): readonly number[] {
    const changes = this.get("changes");
    const robots = changes.filter(({ kind }) => kind === "parameter").map((one) => this.robotsOf(one)[0] ?? 0);
    if (robots.length === 0 && changes.some(({ kind }) => kind === "text"))
      robots.push(this.robotsOf(changes[0]!)[0] ?? 0);
    return [...new Set(robots)];
  }

  /** Asks what can be changed after that cycle. */
  async readChangeable(cycle: number): Promise<void> {
    const number = ++this.read;
    const robots = this.wanted();
    const replies = await Promise.all(
      robots.map((robot) =>
        this.session.connection.ask({ case: "readChangeable", value: { cycle: BigInt(cycle), robot } }),
      ),
    );
    if (number !== this.read) return;
    const known = new Map<number, Changeable>();
    replies.forEach(({ result }, i) => {
      if (result.case === "changeable") known.set(robots[i]!, result.value);
    });
    this.set("changeable", known);
    const refused = replies.find(({ ok }) => !ok);
    if (refused) this.set("problem", sentence(refused.error));
  }

  // ---- asking

  /** What would be asked for; a sentence: why it can't be. */
  wish(cycle: number): MessageInitShape<typeof WhatIfSchema> | string {
    const seconds = readLength(this.get("length"));
    if (typeof seconds === "string") return seconds;
    const whyNot = this.whyNot;
    if (whyNot !== undefined) return whyNot;
    const changes: MessageInitShape<typeof WhatIf_ChangeSchema>[] = [];
    const all = this.get("changes");
    for (const [i, one] of all.entries()) {
      const wished = this.wishOf(one);
      if (typeof wished === "string") return all.length > 1 ? `Change ${i + 1}: ${wished}` : wished;
      changes.push({ what: wished });
    }
    const paths = all.filter(({ kind }) => kind === "text").map(({ path }) => path);
    const twice = paths.find((path, i) => paths.indexOf(path) !== i);
    if (twice !== undefined) return `${fileName(twice)} is changed twice: remove one of the changes.`;
    return { cycle: BigInt(cycle), seconds, withoutPeople: this.get("withoutPeople"), changes };
  }

  private wishOf(change: Change): NonNullable<MessageInitShape<typeof WhatIf_ChangeSchema>["what"]> | string {
    switch (change.kind) {
      case "parameter": {
        const value = change.value.trim();
        if (change.port === "") return "Choose a parameter.";
        if (value === "") return "Enter a value.";
        return { case: "parameter", value: { robots: [...this.robotsOf(change)], port: change.port, value } };
      }
      case "order":
        if (change.order.trim() === "") return "Enter an order, as UNIT scouts STOP.";
        return { case: "order", value: change.order };
      case "text":
        if (change.path === "") return "Choose a text.";
        return { case: "text", value: { path: change.path, text: change.text } };
    }
  }

  async compute(cycle: number): Promise<void> {
    const wish = this.wish(cycle);
    if (typeof wish === "string") {
      this.set("problem", wish);
      return;
    }
    this.set("problem", "");
    this.set("isAsking", true);
    const reply = await this.session.connection.ask({ case: "whatIf", value: wish });
    this.set("isAsking", false);
    if (reply.ok) this.set("isAgain", false);
    else this.set("problem", sentence(reply.error));
  }

  async forget(): Promise<void> {
    this.set("isAgain", false);
    await this.session.connection.ask({ case: "forgetFuture", value: {} });
  }

  /** Hands it to the browser as a file. */
  async save(): Promise<void> {
    const reply = await this.session.connection.ask({ case: "saveFuture", value: {} });
    if (reply.result.case !== "recording") {
      this.set("problem", sentence(reply.error));
      return;
    }
    const { name, content } = reply.result.value;
    offer(name, new Blob([content as Uint8Array<ArrayBuffer>], { type: "application/octet-stream" }));
  }
}

/** For how long, as times of the run are typed; 0: to its end. A sentence: it is no such time. */
export function readLength(text: string): number | string {
  if (text.trim() === "") return 0;
  const seconds = readMoment(text);
  if (seconds !== undefined && seconds > 0 && seconds <= kLongest) return seconds;
  return `“${text.trim()}” is no time: enter 90, 1:30 or 1:02:03, at most two hours.`;
}

export function fileName(path: string): string {
  return path.split("/").at(-1) ?? path;
}

export const futureOf = perSession((session) => new FutureStore(session));
