// Lists the moments that people have marked, and takes their notes.
import { type RefObject, useEffect, useRef, useState } from "react";
import { momentText } from "../../core/run_time.ts";
import { Button, Field, IconButton } from "../controls/controls.tsx";
import { count } from "../words/format.ts";
import { sentence } from "../words/sentence.ts";

export interface ListedBookmark {
  readonly id: bigint;
  readonly time: number;
  readonly note: string;
  readonly by: string;
}

export interface BookmarkPanelProps {
  /** By time. */
  bookmarks: readonly ListedBookmark[];
  /** That is shown [s]. */
  time: number;
  /** Whose note is being written; null: none. */
  editing: bigint | null;
  /** That was made last, whose id changes from 0 to its own; null: none. */
  fresh: bigint | null;
  /** That was removed last; null: none. */
  removed: string | null;
  /** The file that they are in; empty: none. */
  keptIn: string;
  /** Why the last change is in no file; empty: it is. */
  notKept: string;
  /** Why none can be made or changed; empty: one can. */
  whyNot: string;
  onGo: (time: number) => void;
  onEdit: (id: bigint | null) => void;
  onNote: (id: bigint, note: string) => void;
  onRemove: (id: bigint) => void;
  onTakeBack: () => void;
  onClose: () => void;
}

export function BookmarkPanel(props: BookmarkPanelProps) {
  const { bookmarks, removed, keptIn, notKept, whyNot, onClose } = props;
  const box = useRef<HTMLElement>(null);
  useFocusOnce(box, props.editing !== null);
  return (
    <section
      ref={box}
      tabIndex={-1}
      className="time-find time-bookmarks"
      aria-label="Bookmarks"
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        onClose();
      }}
    >
      <header>
        <h3>Bookmarks</h3>
        <IconButton icon="close" label="Close" shortcut="Esc" onPress={onClose} />
      </header>
      <span className="small muted" role="status">
        {bookmarks.length === 0 ? "No moment of this run is marked." : count(bookmarks.length, "bookmark")}
      </span>
      {whyNot !== "" && <p className="small muted">{whyNot}</p>}
      {notKept !== "" && (
        <p className="time-find-problem small" role="alert">
          Not kept in a file: {sentence(notKept)}
        </p>
      )}
      {removed !== null && (
        <div className="time-find-line time-bookmark-removed" role="status">
          <span className="grow small">
            Removed: <bdi>{removed}</bdi>
          </span>
          <Button onPress={props.onTakeBack}>Undo</Button>
        </div>
      )}
      {bookmarks.length > 0 && <Rows {...props} />}
      {keptIn !== "" && notKept === "" && (
        <p className="small muted time-bookmark-file" title={keptIn}>
          In {keptIn}
        </p>
      )}
    </section>
  );
}

function Rows(props: BookmarkPanelProps) {
  const { bookmarks, time, editing, fresh } = props;
  const here = useRef<HTMLLIElement>(null);
  const list = useRef<HTMLOListElement>(null);
  const before = useRef(editing);
  useEffect(() => {
    const isWritten = editing === null && before.current !== null;
    before.current = editing;
    if (editing !== null) here.current?.scrollIntoView({ block: "nearest" });
    // Not a row: what is pressed next is not to lead away from now.
    if (isWritten && document.activeElement === document.body) list.current?.closest("section")?.focus();
  }, [editing]);
  return (
    <ol ref={list} className="time-found" aria-label="Moments that were marked">
      {bookmarks.map((one) =>
        one.id === editing ? (
          // What is being typed stays when the server has told its id.
          <li key={one.id === fresh ? "fresh" : String(one.id)} ref={here}>
            <NoteField bookmark={one} {...props} />
          </li>
        ) : (
          <li key={String(one.id)} className="time-bookmark">
            <Row bookmark={one} isHere={Math.abs(one.time - time) < 1e-3} {...props} />
          </li>
        ),
      )}
    </ol>
  );
}

function Row({ bookmark, isHere, ...props }: BookmarkPanelProps & { bookmark: ListedBookmark; isHere: boolean }) {
  const { id, time, note, by } = bookmark;
  const at = momentText(time);
  return (
    <>
      <button
        type="button"
        className="time-found-row"
        aria-current={isHere ? "true" : undefined}
        onClick={() => props.onGo(time)}
      >
        <span className="number muted">{at}</span>
        <span className="time-bookmark-note">
          {note === "" ? <span className="muted">no note</span> : <bdi>{note}</bdi>}
          {by !== "" && (
            <span className="small muted">
              {" "}
              <bdi>{by}</bdi>
            </span>
          )}
        </span>
      </button>
      <IconButton
        icon="draw"
        label={`Write the note of ${at}`}
        isDisabled={props.whyNot !== ""}
        onPress={() => props.onEdit(id)}
      />
      <IconButton
        icon="bin"
        label={`Remove the bookmark of ${at}`}
        isDisabled={props.whyNot !== ""}
        onPress={() => props.onRemove(id)}
      />
    </>
  );
}

const kMostNote = 500; // characters, as the server has it

/** Enter keeps what was written, and so does going elsewhere; Escape leaves the note as it was. */
function NoteField({ bookmark, ...props }: BookmarkPanelProps & { bookmark: ListedBookmark }) {
  const { id, time, note } = bookmark;
  const [text, setText] = useState(note);
  const isDone = useRef(false);
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => box.current?.querySelector("input")?.focus(), []);
  const finish = (next: string) => {
    if (isDone.current) return;
    isDone.current = true;
    props.onNote(id, next);
  };
  return (
    <div
      ref={box}
      className="time-find-line time-bookmark-edit"
      onKeyDownCapture={(event) => {
        if (event.key !== "Escape" && event.key !== "Enter") return;
        event.stopPropagation();
        // Else it would press what has the focus next.
        event.preventDefault();
        if (event.key === "Enter") finish(text);
        else {
          isDone.current = true;
          props.onEdit(null);
        }
      }}
    >
      <span className="number muted">{momentText(time)}</span>
      <span className="grow">
        <Field
          label={`Note of ${momentText(time)}`}
          hiddenLabel
          placeholder="A note, if you like"
          value={text}
          onChange={(next) => setText([...next].slice(0, kMostNote).join(""))}
          onCommit={finish}
        />
      </span>
      <Button tone="primary" onPress={() => finish(text)}>
        Keep
      </Button>
    </div>
  );
}

/** Where a note is to be written that is gone to instead. */
function useFocusOnce(box: RefObject<HTMLElement | null>, isWriting: boolean): void {
  const wasWriting = useRef(isWriting);
  useEffect(() => {
    if (!wasWriting.current) box.current?.querySelector<HTMLElement>(".time-found-row, .button")?.focus();
  }, [box]);
}
