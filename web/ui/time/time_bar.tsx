// The bar along the lower edge that shows where in the run one is, and goes elsewhere.
import { memo, type ReactNode, useCallback, useEffect, useMemo, useRef, useState } from "react";
import { momentText, readMoment } from "../../core/run_time.ts";
import { Choice } from "../controls/choice.tsx";
import { Button, Field, Hint, IconButton, Switch } from "../controls/controls.tsx";
import { Icon } from "../controls/icons.tsx";
import { PopoverButton } from "../controls/menus.tsx";
import { type EventKind, firstFrom, kEventKinds, kLooks, type TimeEvent } from "./events.ts";
import { type Span, spanWith, wholeSpan, zoomedSpan } from "./span.ts";
import { Track } from "./track.tsx";
import "./time.css";

/** Where one is. */
export interface Whereabouts {
  readonly time: number;
  readonly cycle: number;
  /** Simulated seconds per second, backwards where negative; 0: it stands. */
  readonly speed: number;
  readonly isNow: boolean;
  /** It is being computed; what is shown is of before. */
  readonly isComing: boolean;
  readonly problem: string;
}

export interface TimeBarProps {
  at: Whereabouts;
  end: number;
  knownTo: number;
  /** The run goes on: its end is now. */
  endIsNow: boolean;
  /** Why no other moment can be looked at; empty: each can. */
  whyNot: string;
  /** What else is to be known, as that it takes long. */
  note: string;
  /** Of the kinds that are shown. */
  events: readonly TimeEvent[];
  /** Of all kinds. */
  all: readonly TimeEvent[];
  /** What was looked for. */
  found: readonly { readonly time: number; readonly text: string }[];
  hidden: ReadonlySet<EventKind>;
  /** As chosen, without direction. */
  speed: number;
  isDark: boolean;
  /** Keys, as on their caps. */
  keys: Readonly<Record<TimeAct, string>>;
  isFinding: boolean;
  /** The list of bookmarks is open. */
  isListing: boolean;
  /** How many there are. */
  bookmarks: number;
  /** Why none can be made; empty: one can. */
  whyNoBookmark: string;
  does: TimeDoes;
  /** Beside the line, behind what else is done with it. */
  tools?: ReactNode;
  /** Over the bar, as where moments are looked for. */
  children?: ReactNode;
}

export type TimeAct =
  | "back"
  | "on"
  | "event-back"
  | "event-on"
  | "play"
  | "play-back"
  | "now"
  | "find"
  | "bookmark"
  | "bookmarks";

export interface TimeDoes {
  go(time: number): void;
  now(): void;
  step(cycles: number): void;
  event(by: 1 | -1): void;
  /** 0: stands. */
  play(direction: 1 | -1 | 0): void;
  speed(speed: number): void;
  hide(hidden: ReadonlySet<EventKind>): void;
  find(): void;
  /** Marks the moment that is shown. */
  bookmark(): void;
  /** Opens and closes their list. */
  bookmarks(): void;
}

export const kTimeSpeeds = [0.5, 1, 2, 5, 10, 50, 100] as const;

/** What moves with each moment is the track and the field; all else is drawn anew only when it says something else. */
export function TimeBar(props: TimeBarProps) {
  const { at, end, knownTo, endIsNow, whyNot, note, does, events, keys, isDark } = props;
  const [span, setSpan] = useSpan(end, at.time);
  const isDisabled = whyNot !== "";
  // A recording has no now that somebody could take its moments for.
  const word = !endIsNow ? "recording" : at.isNow ? "now" : at.isComing ? "past coming" : "past";
  return (
    <section className={`time-bar ${word}`} aria-label="Time line" data-testid="time-line">
      <span className="time-moves" role="toolbar" aria-label="Go through the run">
        <Movement
          speed={Math.sign(at.speed)}
          isNow={at.isNow}
          isAtBegin={at.time <= 0}
          isAtEnd={at.isNow || (!endIsNow && at.time >= end - 1e-6)}
          isAfterEvent={firstFrom(events, at.time - 1e-6) > 0}
          isBeforeEvent={!at.isNow && (events.at(-1)?.time ?? 0) > at.time + 1e-6}
          isDisabled={isDisabled}
          keys={keys}
          does={does}
        />
        <TimeField time={at.time} isDisabled={isDisabled} onGo={does.go} />
        <Speed speed={props.speed} isDisabled={isDisabled} onChoose={does.speed} />
      </span>
      <div className="time-line">
        <Track
          span={span}
          end={end}
          knownTo={isDisabled ? end : knownTo}
          time={at.time}
          isNow={at.isNow}
          endIsNow={endIsNow}
          events={events}
          found={props.found}
          isDark={isDark}
          isDisabled={isDisabled}
          onGo={does.go}
          onNow={does.now}
          onStep={does.step}
          onEvent={does.event}
          onSpan={setSpan}
        />
        {(whyNot || at.problem || note) && (
          <span className={`time-note small ${whyNot || at.problem ? "" : "muted"}`} role="status">
            {whyNot || at.problem || note}
          </span>
        )}
      </div>
      <span className="time-tools">
        <Zoom span={span} end={end} time={at.time} onSpan={setSpan} />
        <KindsShown all={props.all} hidden={props.hidden} isDark={isDark} onHide={does.hide} />
        <BookmarkButtons
          whyNoBookmark={props.whyNoBookmark}
          bookmarks={props.bookmarks}
          isListing={props.isListing}
          keys={keys}
          does={does}
        />
        <Find isFinding={props.isFinding} isDisabled={isDisabled} shortcut={keys.find} onFind={does.find} />
        {props.tools}
      </span>
      {endIsNow && <Now isNow={at.isNow} isDisabled={isDisabled} shortcut={keys.now} onNow={does.now} />}
      {props.children}
    </section>
  );
}

interface ZoomProps {
  span: Span;
  end: number;
  time: number;
  onSpan: (span: Span) => void;
}

/** Round the moment that is shown when they are pressed. */
function Zoom({ span, end, time, onSpan }: ZoomProps) {
  const latest = useRef({ span, end, time, onSpan });
  latest.current = { span, end, time, onSpan };
  const zoom = useCallback((factor: number) => {
    const now = latest.current;
    now.onSpan(zoomedSpan(now.span, factor, now.time, now.end));
  }, []);
  return <ZoomButtons isWhole={span.to - span.from >= wholeSpan(end).to - 1e-6} onZoom={zoom} />;
}

const ZoomButtons = memo(({ isWhole, onZoom }: { isWhole: boolean; onZoom: (factor: number) => void }) => (
  <>
    <IconButton icon="minus" label="Show more of the run" isDisabled={isWhole} onPress={() => onZoom(0.5)} />
    <IconButton icon="plus" label="Show less of the run, closer" onPress={() => onZoom(2)} />
  </>
));

interface FindButtonProps {
  isFinding: boolean;
  isDisabled: boolean;
  shortcut: string;
  onFind: () => void;
}

const Find = memo(({ isFinding, isDisabled, shortcut, onFind }: FindButtonProps) => (
  <IconButton
    icon="search"
    label="Find moments"
    shortcut={shortcut}
    pressed={isFinding}
    isDisabled={isDisabled}
    onPress={onFind}
  />
));

interface NowProps {
  isNow: boolean;
  isDisabled: boolean;
  shortcut: string;
  onNow: () => void;
}

const Now = memo(({ isNow, isDisabled, shortcut, onNow }: NowProps) => (
  <Hint text={isNow ? "The run is shown as it goes on" : "Back to the run as it goes on"} shortcut={shortcut}>
    <Button tone={isNow ? "quiet" : "primary"} className="time-now" isDisabled={isNow || isDisabled} onPress={onNow}>
      Now
    </Button>
  </Hint>
));

type BookmarkProps = Pick<TimeBarProps, "whyNoBookmark" | "bookmarks" | "isListing" | "keys" | "does">;

const BookmarkButtons = memo(({ whyNoBookmark, bookmarks, isListing, keys, does }: BookmarkProps) => (
  <>
    <IconButton
      icon="bookmark"
      label={whyNoBookmark === "" ? "Bookmark this moment" : `Bookmark this moment: ${whyNoBookmark}`}
      shortcut={keys.bookmark}
      isDisabled={whyNoBookmark !== ""}
      onPress={does.bookmark}
    />
    <IconButton
      icon="bookmarks"
      label={bookmarks === 0 ? "Bookmarks: none yet" : `Bookmarks: ${bookmarks}`}
      shortcut={keys.bookmarks}
      pressed={isListing}
      onPress={does.bookmarks}
    />
  </>
));

/** What is zoomed to; it goes with the moment that is shown. */
function useSpan(end: number, time: number): [Span, (span: Span) => void] {
  const [zoomed, setZoomed] = useState<Span | null>(null);
  const span = useMemo(() => zoomed ?? wholeSpan(end), [zoomed, end]);
  useEffect(() => {
    if (!zoomed) return;
    const next = spanWith(zoomed, Math.min(time, end), end);
    if (next !== zoomed) setZoomed(next);
  }, [zoomed, time, end]);
  return [
    span,
    (next) => {
      const isWhole = next.to - next.from >= wholeSpan(end).to - 1e-6;
      setZoomed(isWhole ? null : next);
    },
  ];
}

interface MovementProps {
  /** Backwards: -1, it stands: 0, ahead: 1. */
  speed: number;
  isNow: boolean;
  isAtBegin: boolean;
  isAtEnd: boolean;
  /** There is an event before, and one after. */
  isAfterEvent: boolean;
  isBeforeEvent: boolean;
  isDisabled: boolean;
  keys: TimeBarProps["keys"];
  does: TimeDoes;
}

const Movement = memo((props: MovementProps) => {
  const { speed, isNow, isAtBegin, isDisabled, keys, does } = props;
  return (
    <>
      <IconButton
        icon="event_back"
        className="wide-only"
        label="To the event before"
        shortcut={keys["event-back"]}
        isDisabled={isDisabled || !props.isAfterEvent}
        onPress={() => does.event(-1)}
      />
      <IconButton
        icon="cycle_back"
        label="A cycle back"
        shortcut={keys.back}
        isDisabled={isDisabled || isAtBegin}
        onPress={() => does.step(-1)}
      />
      <IconButton
        icon={speed < 0 ? "pause" : "play_back"}
        className="wide-only"
        label={speed < 0 ? "Let time stand" : "Play backwards"}
        shortcut={keys["play-back"]}
        isDisabled={isDisabled || isAtBegin}
        onPress={() => does.play(speed < 0 ? 0 : -1)}
      />
      <IconButton
        icon={speed > 0 ? "pause" : "play"}
        label={
          speed > 0
            ? "Let time stand"
            : isNow
              ? "Play: the run is shown as it goes on, so there is nothing to play"
              : "Play what was"
        }
        shortcut={keys.play}
        isDisabled={isDisabled || isNow}
        onPress={() => does.play(speed > 0 ? 0 : 1)}
      />
      <IconButton
        icon="cycle_on"
        label="A cycle on"
        shortcut={keys.on}
        isDisabled={isDisabled || props.isAtEnd}
        onPress={() => does.step(1)}
      />
      <IconButton
        icon="event_on"
        className="wide-only"
        label="To the next event"
        shortcut={keys["event-on"]}
        isDisabled={isDisabled || !props.isBeforeEvent}
        onPress={() => does.event(1)}
      />
    </>
  );
});

interface SpeedProps {
  speed: number;
  isDisabled: boolean;
  onChoose: (speed: number) => void;
}

const kSpeedChoices = kTimeSpeeds.map((one) => [String(one), `×${one}`] as const);

const Speed = memo(({ speed, isDisabled, onChoose }: SpeedProps) => (
  <span className="time-speed">
    <Choice
      label="Speed at which the past is played"
      hiddenLabel
      value={String(speed)}
      choices={kSpeedChoices}
      isDisabled={isDisabled}
      onChange={(one) => onChoose(Number(one))}
    />
  </span>
));

/** Shows the time; what is typed there is gone to. */
function TimeField({ time, isDisabled, onGo }: { time: number; isDisabled: boolean; onGo: (time: number) => void }) {
  const [typed, setTyped] = useState<string | null>(null);
  const [held, setHeld] = useState<string | null>(null); // who is in the field finds it at rest, though time goes on
  const [problem, setProblem] = useState<string>();
  const shown = momentText(time);
  return (
    <span
      className={`time-field number ${problem ? "wrong" : ""}`}
      title={problem ?? "Time that is shown; type another one to go there"}
    >
      <Field
        label="Time that is shown"
        hiddenLabel
        value={typed ?? held ?? shown}
        committed={shown}
        isDisabled={isDisabled}
        onFocus={() => setHeld(shown)}
        onBlur={() => {
          setHeld(null);
          setTyped(null); // what is no time does not stay in the place of the one that is shown
          setProblem(undefined);
        }}
        onChange={(text) => {
          setTyped(text === shown ? null : text);
          setProblem(undefined);
        }}
        onCommit={(text) => {
          if (typed === null) return;
          const wanted = readMoment(text);
          if (wanted === undefined) {
            setProblem(`“${text}” is no time: 2:13.4, or 133.4`);
            return;
          }
          setTyped(null);
          setHeld(null);
          onGo(wanted);
        }}
      />
      {problem && (
        <span className="time-field-problem" role="alert">
          {problem}
        </span>
      )}
    </span>
  );
}

interface KindsProps {
  all: readonly TimeEvent[];
  hidden: ReadonlySet<EventKind>;
  isDark: boolean;
  onHide: (hidden: ReadonlySet<EventKind>) => void;
}

const KindsShown = memo(({ all, hidden, isDark, onHide }: KindsProps) => {
  const counts = new Map<EventKind, number>();
  for (const { kind } of all) counts.set(kind, (counts.get(kind) ?? 0) + 1);
  const shown = kEventKinds.length - hidden.size;
  return (
    <PopoverButton
      label="Events on the line"
      trigger={
        <Button
          tone="quiet"
          className="square"
          aria-label={
            hidden.size === 0
              ? "Events on the line: all kinds"
              : `Events on the line: ${shown} of ${kEventKinds.length} kinds`
          }
        >
          <Icon name="layers" />
          {hidden.size > 0 && <span className="time-hidden" />}
        </Button>
      }
    >
      <div className="rows" style={{ gap: 2 }}>
        {[...kLooks].reverse().map((look) => (
          <span key={look.kind} className="time-kind">
            <Switch
              label={
                <>
                  <Sign shape={look.shape} color={isDark ? look.dark : look.light} /> {look.name}
                </>
              }
              value={!hidden.has(look.kind)}
              onChange={(isShown) => {
                const next = new Set(hidden);
                if (isShown) next.delete(look.kind);
                else next.add(look.kind);
                onHide(next);
              }}
            />
            <span className="number small muted">{counts.get(look.kind) ?? 0}</span>
          </span>
        ))}
      </div>
    </PopoverButton>
  );
});

const kSigns: Record<(typeof kLooks)[number]["shape"], string> = {
  bar: "M6 1h3v14H6z",
  low: "M7 10h1.5v5H7z",
  square: "M5 5h6v6H5z",
  dot: "M6.5 6.5h3v3h-3z",
  circle: "M12 8a4 4 0 1 1-8 0 4 4 0 0 1 8 0z",
  diamond: "M8 3l5 5-5 5-5-5z",
  down: "M3 4h10l-5 8z",
  up: "M8 4l5 8H3z",
  ribbon: "M4 2h8v12L8 10.5 4 14z",
};

function Sign({ shape, color }: { shape: keyof typeof kSigns; color: string }) {
  return (
    <svg className="time-sign" viewBox="0 0 16 16" aria-hidden="true">
      <path d={kSigns[shape]} fill={color} />
    </svg>
  );
}
