// The time line of the session, where there is one: once the run has begun, or a recording was opened.
import { useMemo } from "react";
import { neighbourMoment } from "../../core/moment_finder.ts";
import { Status_Mode } from "../../core/protocol.ts";
import { shownShortcut } from "../../ui/commands/keys.ts";
import { BookmarkPanel } from "../../ui/time/bookmark_panel.tsx";
import { shownEvents } from "../../ui/time/events.ts";
import { FindPanel } from "../../ui/time/find_panel.tsx";
import { type TimeAct, TimeBar } from "../../ui/time/time_bar.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { usePart, useReading, useSession } from "../session/session.ts";
import { FuturePanel, useGhosts, WhatIfButton } from "./future_panel.tsx";
import { kTimeKeys } from "./time_actions.ts";
import { useExamples } from "./use_examples.ts";
import { useBookmarkPart, useBookmarks, useFinding, useTravel, useTravelPart, useWhereabouts } from "./use_travel.ts";

const kKeys = Object.fromEntries(Object.entries(kTimeKeys).map(([act, key]) => [act, shownShortcut(key)])) as Record<
  TimeAct,
  string
>;

// The same each time, so that they are not drawn anew with each moment.
const kTools = <WhatIfButton />;
const kFuture = <FuturePanel />;

/** Whether there is a line to be shown. */
export function useHasTimeLine(): boolean {
  return useReading(["timeLine", "status", "time"], (model) => {
    const line = model.get("timeLine");
    const mode = model.get("status")?.mode ?? Status_Mode.NO_MISSION;
    if (!line) return false;
    return line.recording !== "" || line.end > 0 || (model.get("time") > 0 && mode !== Status_Mode.NO_MISSION);
  });
}

export function TimeLine() {
  return useHasTimeLine() ? <Line /> : null;
}

function Line() {
  const { model } = useSession();
  const travel = useTravel();
  const line = usePart("timeLine");
  usePart("log");
  usePart("alertsAfter");
  const isDark = usePart("map").theme === "dark";
  const hidden = useTravelPart("hidden");
  const speed = useTravelPart("speed");
  const isFinding = useTravelPart("isFinding");
  const finding = useFinding();
  const list = useBookmarks();
  const isListing = useBookmarkPart("isOpen");
  const kept = usePart("bookmarks");
  usePart("clients");
  const at = useWhereabouts();
  const all = travel.events();
  const events = useMemo(() => shownEvents(all, hidden), [all, hidden]);
  const end = travel.end;
  const does = useMemo(
    () => ({ ...travel.does, bookmark: () => void list.mark(), bookmarks: () => list.toggle() }),
    [travel, list],
  );
  useGhosts();
  return (
    <TimeBar
      at={at}
      end={end}
      // Who has not looked elsewhere need not know how fast that would be.
      knownTo={at.isNow ? end : (line?.knownTo ?? end)}
      endIsNow={!model.isRecording()}
      whyNot={line?.whyNot ? sentence(line.whyNot) : ""}
      note={noteOf(line)}
      events={events}
      all={all}
      found={finding.moments}
      hidden={hidden}
      speed={speed}
      isDark={isDark}
      keys={kKeys}
      isFinding={isFinding}
      isListing={isListing && !isFinding}
      bookmarks={kept?.bookmarks.length ?? 0}
      whyNoBookmark={list.whyNot ?? ""}
      does={does}
      tools={kTools}
    >
      {!isListing && !isFinding && kFuture}
      {isListing && !isFinding && <Listed time={at.time} />}
      {isFinding && <Sought time={at.time} end={end} />}
    </TimeBar>
  );
}

function Sought({ time, end }: { time: number; end: number }) {
  const travel = useTravel();
  const finding = useFinding();
  const examples = useExamples();
  return (
    <FindPanel
      finding={finding}
      examples={examples}
      end={end}
      time={time}
      onFind={(condition) => void travel.finder.find(condition)}
      onCancel={() => travel.finder.cancel()}
      onGo={travel.does.go}
      onNext={(by) => {
        const to = neighbourMoment(finding.moments, time, by);
        if (to !== undefined) travel.does.go(to);
      }}
      onClose={() => travel.set("isFinding", false)}
    />
  );
}

function Listed({ time }: { time: number }) {
  const list = useBookmarks();
  const travel = useTravel();
  const kept = usePart("bookmarks");
  const editing = useBookmarkPart("editing");
  const removed = useBookmarkPart("removed");
  const fresh = useBookmarkPart("fresh");
  return (
    <BookmarkPanel
      bookmarks={list.shown()}
      fresh={fresh?.id ?? null}
      time={time}
      editing={editing}
      removed={removed?.name ?? null}
      keptIn={kept?.keptIn ?? ""}
      notKept={kept?.notKept ?? ""}
      whyNot={list.whyNot ?? ""}
      onGo={travel.does.go}
      onEdit={(id) => list.set("editing", id)}
      onNote={(id, note) => void list.note(id, note)}
      onRemove={(id) => void list.remove(id)}
      onTakeBack={() => void list.takeBack()}
      onClose={() => list.close()}
    />
  );
}

function noteOf(line: { parted: string; whySlow: string } | null): string {
  return sentence(line?.parted || line?.whySlow || "");
}
