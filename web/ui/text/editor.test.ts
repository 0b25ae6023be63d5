import { ChangeSet, Text } from "@codemirror/state";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { bytesOf, unitsOf } from "./bytes.ts";
import { difference } from "./difference.ts";
import { type OutgoingEdit, TextSync } from "./sync.ts";

const utf8 = new TextEncoder();
const unicode = fc.string({ unit: "grapheme", maxLength: 30 });

describe("bytes and code units", () => {
  it("agree with the encoder at every character", () => {
    fc.assert(
      fc.property(unicode, (text) => {
        let units = 0;
        for (const character of text) {
          units += character.length;
          const bytes = utf8.encode(text.slice(0, units)).length;
          expect(bytesOf(text, units)).toBe(bytes);
          expect(unitsOf(text, bytes)).toBe(units);
        }
      }),
    );
  });
  it("stay at the beginning of a character that is cut", () => {
    expect(unitsOf("é", 1)).toBe(0);
    expect(bytesOf("a😀", 2)).toBe(1);
  });
});

describe("a difference", () => {
  it("makes the one text of the other", () => {
    fc.assert(
      fc.property(unicode, unicode, (before, after) => {
        const change = difference(before, after);
        const result = change ? before.slice(0, change.from) + change.insert + before.slice(change.to) : before;
        expect(result).toBe(after);
      }),
    );
  });
  it("is as small as one replacement can be", () => {
    expect(difference("MOVETO PP-A", "MOVETO PP-B")).toEqual({ from: 10, to: 11, insert: "B" });
    expect(difference("aa", "aaa")).toEqual({ from: 2, to: 2, insert: "a" });
    expect(difference("same", "same")).toBeUndefined();
  });
  it("leaves characters of two code units whole", () => {
    expect(difference("😀", "😁")).toEqual({ from: 0, to: 2, insert: "😁" });
  });
});

/** A server with one document, and an editor that a person types into. */
class Pair {
  text: string;
  revision = 1n;
  sync: TextSync;
  shown: string;
  private outgoing: OutgoingEdit | undefined;
  constructor(text: string) {
    this.text = text;
    this.shown = text;
    this.sync = new TextSync({ revision: 1n, text });
  }
  type(from: number, to: number, insert: string): void {
    const changes = ChangeSet.of({ from, to, insert }, this.shown.length);
    this.shown = changes.apply(textOf(this.shown)).toString();
    this.sync.typed(changes);
  }
  foreign(from: number, to: number, insert: string): void {
    this.text = this.text.slice(0, from) + insert + this.text.slice(to);
    this.revision += 1n;
    this.show();
  }
  send(): void {
    this.outgoing ??= this.sync.takeOutgoing();
  }
  /** The server deals with the edit; its answer comes before or after the document. */
  serve(documentFirst: boolean): void {
    const edit = this.outgoing;
    if (!edit) return;
    this.outgoing = undefined;
    const ok = edit.revision === this.revision;
    if (ok) {
      const bytes = utf8.encode(this.text);
      const decoder = new TextDecoder();
      this.text = decoder.decode(bytes.slice(0, edit.begin)) + edit.text + decoder.decode(bytes.slice(edit.end));
      this.revision += 1n;
      if (documentFirst) this.show();
    }
    this.change(this.sync.answered(ok));
    if (ok && !documentFirst) this.show();
  }
  private show(): void {
    this.change(this.sync.arrived({ revision: this.revision, text: this.text }));
  }
  private change(changes: ChangeSet | undefined): void {
    if (changes) this.shown = changes.apply(textOf(this.shown)).toString();
    expect(this.sync.text).toBe(this.shown);
  }
}

const textOf = (text: string) => Text.of(text.split("\n"));

describe("an editor beside the server", () => {
  it("sends what is typed as bytes", () => {
    const pair = new Pair("é MOVETO");
    pair.type(2, 8, "OCCUPY");
    expect(pair.sync.takeOutgoing()).toEqual({ revision: 1n, begin: 3, end: 9, text: "OCCUPY" });
  });
  it("keeps what is typed when the text changes elsewhere", () => {
    const pair = new Pair("one two");
    pair.type(7, 7, " three");
    pair.foreign(0, 3, "eins");
    expect(pair.shown).toBe("eins two three");
    pair.send();
    pair.serve(true);
    expect(pair.text).toBe("eins two three");
    expect(pair.sync.isAhead).toBe(false);
  });
  it("tries again over the newer text after a refusal", () => {
    const pair = new Pair("one two");
    pair.type(7, 7, "!");
    pair.send();
    pair.foreign(0, 0, "# ");
    pair.serve(false);
    expect(pair.shown).toBe("# one two!");
    pair.send();
    pair.serve(false);
    expect(pair.text).toBe("# one two!");
  });
  it("moves the server's places along with what was typed", () => {
    const pair = new Pair("one two");
    pair.type(0, 0, "xx ");
    expect(pair.sync.fromServer(4)).toBe(7);
  });
  it("sends again what a lost connection swallowed", () => {
    const pair = new Pair("one");
    pair.type(3, 3, " two");
    expect(pair.sync.takeOutgoing()).toBeDefined();
    pair.sync.disconnected();
    expect(pair.sync.takeOutgoing()).toMatchObject({ text: " two" });
  });
  it("ends with the same text on both sides, whatever the order of things", () => {
    const place = fc.nat(40);
    const step = fc.oneof(
      fc.record({ do: fc.constant("type" as const), at: place, cut: fc.nat(5), insert: fc.string({ maxLength: 4 }) }),
      fc.record({
        do: fc.constant("foreign" as const),
        at: place,
        cut: fc.nat(5),
        insert: fc.string({ maxLength: 4 }),
      }),
      fc.record({ do: fc.constant("send" as const) }),
      fc.record({ do: fc.constant("serve" as const), documentFirst: fc.boolean() }),
    );
    fc.assert(
      fc.property(fc.array(step, { maxLength: 30 }), (steps) => {
        const pair = new Pair("UNIT scouts MOVETO PP-Charlie");
        for (const step of steps) {
          if (step.do === "send") pair.send();
          else if (step.do === "serve") pair.serve(step.documentFirst);
          else {
            const length = (step.do === "type" ? pair.shown : pair.text).length;
            const from = Math.min(step.at, length);
            pair[step.do](from, Math.min(length, from + step.cut), step.insert);
          }
        }
        for (let i = 0; i < 6; i++) {
          pair.send();
          pair.serve(i % 2 === 0);
        }
        expect(pair.sync.isAhead).toBe(false);
        expect(pair.shown).toBe(pair.text);
      }),
    );
  });
});
