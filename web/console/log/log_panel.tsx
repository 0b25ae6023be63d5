// Everything that happened. Only the rows in sight are in the page.
import { type RefObject, useEffect, useMemo, useRef, useState } from "react";
import { type Log_Entry, Log_Kind } from "../../core/protocol.ts";
import { Button, Search, Switch } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { PopoverButton } from "../../ui/controls/menus.tsx";
import { count, duration, readableMessage } from "../../ui/words/format.ts";
import { useIsElsewhen, usePart, useSession } from "../session/session.ts";
import { useHasPast, useTravel, useWhereabouts } from "../time/use_travel.ts";
import { filterLog, kEverything, kKinds, kKindWords, type LogFilter, windowOf } from "./filter.ts";
import { hasPlace, showPlace } from "./show_place.ts";
import "./log.css";

const kRow = 26; // [px]

export function LogPanel() {
  const log = usePart("log");
  const selection = usePart("selection");
  const [filter, setFilter] = useState<LogFilter>(kEverything);
  const [onlySelected, setOnlySelected] = useState(false);
  const effective = useMemo(
    () => ({ ...filter, robots: onlySelected ? new Set(selection.robots) : new Set<number>() }),
    [filter, onlySelected, selection.robots],
  );
  const entries = useMemo(() => filterLog(log, effective), [log, effective]);
  return (
    <div className="log">
      <div className="log-bar">
        <Search label="Filter the log" value={filter.text} onChange={(text) => setFilter({ ...filter, text })} />
        <KindFilter filter={filter} onChange={setFilter} />
        <Switch
          label={
            selection.robots.length > 0
              ? `Only ${count(selection.robots.length, "selected robot")}`
              : "Only selected robots"
          }
          value={onlySelected && selection.robots.length > 0}
          isDisabled={selection.robots.length === 0}
          onChange={setOnlySelected}
        />
        <span className="small muted number">
          {entries.length === log.length
            ? count(log.length, "entry", "entries")
            : `${entries.length} of ${count(log.length, "entry", "entries")}`}
        </span>
      </div>
      <Rows entries={entries} />
    </div>
  );
}

function KindFilter({ filter, onChange }: { filter: LogFilter; onChange: (filter: LogFilter) => void }) {
  const shown = kKinds.length - filter.hidden.size;
  return (
    <PopoverButton
      label="Kinds of entries"
      trigger={
        <Button>
          {shown === kKinds.length ? "All kinds" : `${shown} of ${kKinds.length} kinds`}
          <Icon name="down" />
        </Button>
      }
    >
      <div className="rows" style={{ gap: 2 }}>
        <Button
          tone="link"
          onPress={() => onChange({ ...filter, hidden: filter.hidden.size > 0 ? new Set() : new Set(kKinds) })}
        >
          {filter.hidden.size > 0 ? "Show all" : "Hide all"}
        </Button>
        {kKinds.map((kind) => (
          <Switch
            key={kind}
            label={kKindWords[kind]}
            value={!filter.hidden.has(kind)}
            onChange={(isShown) => {
              const hidden = new Set(filter.hidden);
              if (isShown) hidden.delete(kind);
              else hidden.add(kind);
              onChange({ ...filter, hidden });
            }}
          />
        ))}
      </div>
    </PopoverButton>
  );
}

function Rows({ entries }: { entries: readonly Log_Entry[] }) {
  const box = useRef<HTMLDivElement>(null);
  useShownMoment(box, entries);
  const [scroll, setScroll] = useState({ top: 0, height: 400 });
  const isAtEnd = useRef(true);
  useEffect(() => {
    const element = box.current;
    if (element && isAtEnd.current) element.scrollTop = element.scrollHeight;
  }, [entries]);
  useEffect(() => {
    const element = box.current;
    if (!element) return;
    const measure = () => {
      setScroll({ top: element.scrollTop, height: element.clientHeight });
      if (isAtEnd.current) element.scrollTop = element.scrollHeight;
    };
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  const { first, end } = windowOf(entries.length, scroll.top, scroll.height, kRow);
  return (
    <div
      ref={box}
      className="log-rows"
      role="log"
      aria-label="Events"
      aria-live="off"
      // biome-ignore lint/a11y/noNoninteractiveTabindex: a region that scrolls has to be reached by keyboard
      tabIndex={0}
      onScroll={(event) => {
        const element = event.currentTarget;
        isAtEnd.current = element.scrollHeight - element.scrollTop - element.clientHeight < kRow;
        setScroll({ top: element.scrollTop, height: element.clientHeight });
      }}
    >
      {entries.length === 0 && <p className="empty small">Nothing to show.</p>}
      <div style={{ height: entries.length * kRow, position: "relative" }}>
        {entries.slice(first, end).map((entry, i) => (
          <Row key={String(entry.number)} entry={entry} top={(first + i) * kRow} />
        ))}
      </div>
    </div>
  );
}

function Row({ entry, top }: { entry: Log_Entry; top: number }) {
  const session = useSession();
  const { model } = session;
  const isLater = useIsElsewhen() && entry.time > model.time + 1e-6;
  const tone =
    entry.isAlert || entry.kind === Log_Kind.CONTACT ? "danger" : entry.kind === Log_Kind.WARNING ? "hold" : "";
  const who = entry.robot ? model.get("roster").nameOf(entry.robot) : entry.unit;
  return (
    <div className={`log-row ${tone} ${isLater ? "later" : ""}`} style={{ top }}>
      <EntryTime entry={entry} />
      <span className="log-kind">{kKindWords[entry.kind]}</span>
      <span className="log-who ellipsis">{who}</span>
      {hasPlace(entry) ? (
        <Button
          tone="link"
          className="ellipsis log-text"
          onPress={() => showPlace(session, entry)}
          aria-label={`${readableMessage(entry.text)}: show on the map`}
        >
          {readableMessage(entry.text)}
          <Icon name="centre" />
        </Button>
      ) : (
        <span className="ellipsis log-text" title={readableMessage(entry.text)}>
          {readableMessage(entry.text)}
        </span>
      )}
    </div>
  );
}

/** Leads to the moment, where it can be looked at: entries of an earlier run can't. */
function EntryTime({ entry }: { entry: Log_Entry }) {
  const travel = useTravel();
  const hasPast = useHasPast();
  const isOfThisRun = entry.number > usePart("alertsAfter");
  const text = duration(entry.time, true);
  if (!hasPast || !isOfThisRun) return <span className="number muted">{text}</span>;
  return (
    <Button
      tone="link"
      className="number"
      aria-label={`${text}: look at this moment`}
      onPress={() => travel.go(entry.time)}
    >
      {text}
    </Button>
  );
}

/** At another moment, what was told last then is in sight. */
function useShownMoment(box: RefObject<HTMLDivElement | null>, entries: readonly Log_Entry[]): void {
  const isElsewhen = useIsElsewhen();
  const { time } = useWhereabouts();
  const last = isElsewhen ? entries.findLastIndex((entry) => entry.time <= time + 1e-6) : -1;
  useEffect(() => {
    const element = box.current;
    if (!element || last < 0) return;
    const top = last * kRow;
    if (top >= element.scrollTop && top + kRow <= element.scrollTop + element.clientHeight) return;
    element.scrollTop = Math.max(0, top + kRow - element.clientHeight);
  }, [box, last]);
}
