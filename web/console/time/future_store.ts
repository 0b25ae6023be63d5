// The other future that is asked for: what is chosen in its panel, and what the server answers.
import type { MessageInitShape } from "@bufbuild/protobuf";
import type { Changeable, WhatIfSchema } from "../../core/protocol.ts";
import { Store } from "../../core/store.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { perSession, type Session } from "../session/session.ts";
import { bookmarksOf } from "./bookmarks.ts";
import { travelOf } from "./time_travel.ts";

export type ChangeKind = "parameter" | "order" | "text" | "nothing";

export interface FutureParts {
  isOpen: boolean;
  /** Another one is asked for, though there is one. */
  isAgain: boolean;
  kind: ChangeKind;
  /** `1`, or the name of a unit. */
  target: string;
  port: string;
  value: string;
  order: string;
  path: string;
  text: string;
  /** [s]; empty: to the end. */
  seconds: string;
  withoutPeople: boolean;
  /** What can be changed at the moment; null: not known yet. */
  changeable: Changeable | null;
  isAsking: boolean;
  problem: string;
}

export class FutureStore extends Store<FutureParts> {
  private read = 0;

  constructor(private readonly session: Session) {
    super({
      isOpen: false,
      isAgain: false,
      kind: "parameter",
      target: "",
      port: "",
      value: "",
      order: "",
      path: "",
      text: "",
      seconds: "",
      withoutPeople: false,
      changeable: null,
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

  /** The robots that are meant. */
  robots(): readonly number[] {
    const roster = this.session.model.get("roster");
    const target = this.get("target");
    if (/^\d+$/.test(target)) return [Number(target)];
    const members = roster.robotsOf(target);
    if (members.length > 0) return members;
    const first = this.session.model.get("selection").robots[0] ?? roster.robots[0]?.id;
    return first === undefined ? [] : [first];
  }

  /** Asks what can be changed after that cycle. */
  async readChangeable(cycle: number): Promise<void> {
    const number = ++this.read;
    const robot = this.robots()[0] ?? 0;
    const reply = await this.session.connection.ask({
      case: "readChangeable",
      value: { cycle: BigInt(cycle), robot },
    });
    if (number !== this.read) return;
    this.set("changeable", reply.result.case === "changeable" ? reply.result.value : null);
    if (!reply.ok) this.set("problem", sentence(reply.error));
  }

  /** What would be asked for; a sentence: why it can't be. */
  wish(cycle: number): MessageInitShape<typeof WhatIfSchema> | string {
    const seconds = this.get("seconds").trim() === "" ? 0 : Number(this.get("seconds").replace(",", "."));
    if (!(seconds >= 0 && seconds <= 3600)) return `“${this.get("seconds")}” is no time: 0 to 3600 seconds.`;
    const common = { cycle: BigInt(cycle), seconds, withoutPeople: this.get("withoutPeople") };
    switch (this.get("kind")) {
      case "parameter": {
        const { port, value } = { port: this.get("port"), value: this.get("value").trim() };
        if (port === "") return "Choose a parameter.";
        if (value === "") return "Enter a value.";
        const parameter = { robots: [...this.robots()], port, value };
        return { ...common, changes: [{ what: { case: "parameter", value: parameter } }] };
      }
      case "order":
        if (this.get("order").trim() === "") return "Enter an order, as UNIT scouts STOP.";
        return { ...common, changes: [{ what: { case: "order", value: this.get("order") } }] };
      case "text": {
        if (this.get("path") === "") return "Choose a text.";
        const text = { path: this.get("path"), text: this.get("text") };
        return { ...common, changes: [{ what: { case: "text", value: text } }] };
      }
      case "nothing":
        return common;
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
    const link = document.createElement("a");
    link.href = URL.createObjectURL(
      new Blob([content as Uint8Array<ArrayBuffer>], { type: "application/octet-stream" }),
    );
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }
}

export const futureOf = perSession((session) => new FutureStore(session));
