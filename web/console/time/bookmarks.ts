// Moments that people mark: what is ordered of the server, and what only this browser knows of their list.
import { momentText } from "../../core/run_time.ts";
import { Store } from "../../core/store.ts";
import type { ListedBookmark } from "../../ui/time/bookmark_panel.tsx";
import { order } from "../session/orders.ts";
import { perSession, type Session } from "../session/session.ts";
import { travelOf } from "./time_travel.ts";

export interface BookmarkParts {
  /** Their list is shown. */
  isOpen: boolean;
  /** Whose note is being written; 0: of the one that is being made; null: none. */
  editing: bigint | null;
  /** The one that was made last; its id is 0 until the server has answered. */
  fresh: { readonly id: bigint; readonly time: number } | null;
  /** That was removed last, and may come back; null: none. */
  removed: { readonly id: bigint; readonly name: string } | null;
}

export class BookmarkList extends Store<BookmarkParts> {
  private made: Promise<bigint | null> = Promise.resolve(null);

  constructor(private readonly session: Session) {
    super({ isOpen: false, editing: null, fresh: null, removed: null });
    // Another run has others.
    session.model.subscribe("welcome", () => this.forget());
    session.model.subscribe("bookmarks", () => {
      const isGone = this.all.every(({ id }) => id !== this.get("editing") && id !== this.get("fresh")?.id);
      if (isGone && this.get("fresh")?.id !== 0n) this.set("editing", null);
    });
  }

  get all() {
    return this.session.model.get("bookmarks")?.bookmarks ?? [];
  }

  /** Why none can be made or changed; nothing: one can. */
  get whyNot(): string | undefined {
    const { model } = this.session;
    if (!model.get("bookmarks")) return "The server knows of no bookmarks.";
    if (model.get("link").state !== "open") return "There is no connection.";
    if (!model.isOperator()) return "Only the operator can do this: take control first.";
    const line = model.get("timeLine");
    return model.isRecording() || (line?.end ?? 0) > 0 || model.time > 0 ? undefined : "The run has not begun.";
  }

  /** By time; with the one that is being made. */
  shown(): readonly ListedBookmark[] {
    const editing = this.get("editing");
    const fresh = this.get("fresh");
    if (editing === null || fresh === null || this.all.some(({ id }) => id === fresh.id)) return this.all;
    const out: ListedBookmark[] = [...this.all, { ...fresh, note: "", by: "" }];
    return out.sort((a, b) => a.time - b.time);
  }

  /** Marks the moment that is shown, and asks for a note at once: what is typed next is no shortcut. */
  async mark(): Promise<void> {
    if (this.whyNot !== undefined) return;
    const { time, cycle, isNow, isComing } = travelOf(this.session).whereabouts();
    const value = isNow ? { now: true } : { time, cycle: isComing ? 0n : BigInt(cycle) };
    this.set("fresh", { id: 0n, time });
    this.set("editing", 0n);
    this.open();
    this.made = order(this.session, { case: "setBookmark", value }).then(({ result }) =>
      result.case === "bookmark" ? result.value : null,
    );
    const id = await this.made;
    const isWriting = this.get("editing") === 0n;
    this.set("fresh", id === null ? null : { id, time });
    if (isWriting) this.set("editing", id);
  }

  async note(id: bigint, note: string): Promise<void> {
    this.set("editing", null);
    const of = id === 0n ? await this.made : id;
    if (of === null || (this.all.find((one) => one.id === of)?.note ?? "") === note) return;
    await order(this.session, { case: "setBookmark", value: { id: of, note } });
  }

  async remove(id: bigint): Promise<void> {
    const one = this.all.find((each) => each.id === id);
    const { ok } = await order(this.session, { case: "removeBookmark", value: { id } });
    if (ok && one) this.set("removed", { id, name: `${momentText(one.time)}${one.note ? ` “${one.note}”` : ""}` });
  }

  async takeBack(): Promise<void> {
    const removed = this.get("removed");
    if (!removed) return;
    this.set("removed", null);
    await order(this.session, { case: "removeBookmark", value: { id: removed.id, takeBack: true } });
  }

  toggle(): void {
    const isOpen = !this.get("isOpen");
    if (isOpen) this.open();
    else this.close();
  }

  close(): void {
    this.set("isOpen", false);
    this.forget();
  }

  /** Where moments are looked for, too: one of both. */
  private open(): void {
    travelOf(this.session).set("isFinding", false);
    this.set("isOpen", true);
  }

  private forget(): void {
    this.set("editing", null);
    this.set("fresh", null);
    this.set("removed", null);
  }
}

export const bookmarksOf = perSession((session) => new BookmarkList(session));
