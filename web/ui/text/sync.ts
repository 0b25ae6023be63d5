// Keeps an editor and the server's document together: what is typed here goes out as edits of a revision, what others
// change (on the map, in another browser, by undo) comes in, and neither is lost. One edit is under way at a time.
//
//   base --sent--> --unsent--> editor
//
// `base` is the server's text as last seen, `sent` an edit that was not answered or not shown yet, `unsent` what was typed
// since. A foreign change of `base` is moved over both, and into the editor.
import { ChangeSet, Text } from "@codemirror/state";
import { bytesOf } from "./bytes.ts";
import { difference } from "./difference.ts";

export interface ServerText {
  revision: bigint;
  text: string;
}

/** As the protocol wants it: bytes of UTF-8. */
export interface OutgoingEdit {
  revision: bigint;
  begin: number;
  end: number;
  text: string;
}

type Phase =
  | "idle"
  | "sent" // the answer is awaited
  | "taken"; // answered with yes; the document with it is awaited

export class TextSync {
  private base: Text;
  private revision: bigint;
  private sent: ChangeSet | undefined;
  private unsent: ChangeSet | undefined;
  private phase: Phase = "idle";
  private newest: ServerText | undefined; // arrived while an edit was under way

  constructor(server: ServerText) {
    this.base = Text.of(server.text.split("\n"));
    this.revision = server.revision;
  }

  /** Something here has not reached the server yet. */
  get isAhead(): boolean {
    return this.sent !== undefined || this.unsent !== undefined;
  }

  /** What the editor shows: the base with all that was typed. */
  get text(): string {
    let doc = this.base;
    if (this.sent) doc = this.sent.apply(doc);
    if (this.unsent) doc = this.unsent.apply(doc);
    return doc.toString();
  }

  /** A place in the text that the server last showed, as a place in the editor. */
  fromServer(position: number): number {
    const bounded = Math.min(position, this.base.length);
    const moved = this.sent ? this.sent.mapPos(bounded, 1) : bounded;
    return this.unsent ? this.unsent.mapPos(moved, 1) : moved;
  }

  /** The person typed. */
  typed(changes: ChangeSet): void {
    this.unsent = this.unsent ? this.unsent.compose(changes) : changes;
  }

  /** The edit to be sent now, if any; `answered` has to be called with what the server says. */
  takeOutgoing(): OutgoingEdit | undefined {
    if (this.phase !== "idle" || !this.unsent) return undefined;
    const before = this.base.toString();
    const after = this.unsent.apply(this.base).toString();
    const change = difference(before, after);
    if (!change) {
      this.unsent = undefined;
      return undefined;
    }
    this.sent = this.unsent;
    this.unsent = undefined;
    this.phase = "sent";
    return {
      revision: this.revision,
      begin: bytesOf(before, change.from),
      end: bytesOf(before, change.to),
      text: change.insert,
    };
  }

  /** The server's yes or no to the edit that is under way. Gives what has to change in the editor. */
  answered(ok: boolean): ChangeSet | undefined {
    if (this.phase !== "sent") return undefined;
    if (ok) {
      this.phase = "taken";
    } else {
      this.unsent = this.sent && this.unsent ? this.sent.compose(this.unsent) : (this.sent ?? this.unsent);
      this.sent = undefined;
      this.phase = "idle";
    }
    const waiting = this.newest;
    this.newest = undefined;
    return waiting ? this.arrived(waiting) : undefined;
  }

  /** The connection was lost: nobody will answer. The edit goes out again, over what the server then shows. */
  disconnected(): void {
    this.newest = undefined;
    if (this.phase !== "idle") {
      this.unsent = this.sent && this.unsent ? this.sent.compose(this.unsent) : (this.sent ?? this.unsent);
      this.sent = undefined;
    }
    this.phase = "idle";
  }

  /** The server shows its document. Gives what has to change in the editor. */
  arrived(server: ServerText): ChangeSet | undefined {
    if (this.phase === "sent") {
      this.newest = server;
      return undefined;
    }
    if (this.phase === "taken") {
      if (server.revision <= this.revision) return undefined; // older than our edit
      this.base = (this.sent as ChangeSet).apply(this.base);
      this.sent = undefined;
      this.phase = "idle";
    }
    this.revision = server.revision;
    const change = difference(this.base.toString(), server.text);
    if (!change) return undefined;
    const foreign = ChangeSet.of(change, this.base.length);
    this.base = foreign.apply(this.base);
    if (!this.unsent) return foreign;
    const intoEditor = foreign.map(this.unsent, true);
    this.unsent = this.unsent.map(foreign);
    return intoEditor;
  }
}
