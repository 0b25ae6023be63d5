// How components get at the time line.
import { useCallback, useEffect, useState, useSyncExternalStore } from "react";
import type { Finding } from "../../core/moment_finder.ts";
import { type PastWish, readPast } from "../../core/past_reader.ts";
import type { Past } from "../../core/protocol.ts";
import type { Whereabouts } from "../../ui/time/time_bar.tsx";
import { hear, isAlike, usePart, useReading, useSession, useSteady, useStored } from "../session/session.ts";
import { type BookmarkList, type BookmarkParts, bookmarksOf } from "./bookmarks.ts";
import { type TimeTravel, type TravelParts, travelOf } from "./time_travel.ts";

export function useTravel(): TimeTravel {
  return travelOf(useSession());
}

export function useTravelPart<Name extends keyof TravelParts>(name: Name): TravelParts[Name] {
  return useStored<TravelParts, Name>(useTravel(), name);
}

/** What was looked for, and found. */
export function useFinding(): Finding {
  return useStored<{ finding: Finding }, "finding">(useTravel().finder, "finding");
}

export function useBookmarks(): BookmarkList {
  return bookmarksOf(useSession());
}

export function useBookmarkPart<Name extends keyof BookmarkParts>(name: Name): BookmarkParts[Name] {
  return useStored<BookmarkParts, Name>(useBookmarks(), name);
}

/** Drawn anew when the moment that is shown is another one: of a run that goes on some times a second. */
export function useWhereabouts(): Whereabouts {
  const { model, pace } = useSession();
  const travel = useTravel();
  const subscribe = useCallback(
    (listener: () => void) => {
      const ends = (["moment", "timeLine", "time"] as const).map((name) => hear(model, name, listener, pace));
      // What is gone to is shown together with what is there, unless that takes long.
      ends.push(travel.subscribe("wanted", () => (pace ? pace.withNext(listener) : listener())));
      return () => {
        for (const end of ends) end();
        pace?.forget(listener);
      };
    },
    [model, travel, pace],
  );
  return useSyncExternalStore(
    subscribe,
    useSteady(() => travel.whereabouts(), isAlike),
  );
}

/** Whether other moments can be looked at. */
export function useHasPast(): boolean {
  const travel = useTravel();
  return useReading(
    ["timeLine", "time"],
    (model) => travel.whyNot === undefined && (model.get("time") > 0 || travel.end > 0),
  );
}

/** What was over the whole run, read while it is shown; null: not known yet. */
export function usePast(wish: PastWish | null): { past: Past | null; problem: string } {
  const { model, connection } = useSession();
  const hasPast = useHasPast();
  const session = usePart("welcome")?.session;
  const [known, setKnown] = useState<{ past: Past | null; problem: string }>({ past: null, problem: "" });
  const key = wish && hasPast ? JSON.stringify(wish) : "";
  useEffect(() => {
    setKnown({ past: null, problem: "" });
    if (key === "") return;
    return readPast(
      { model, connection },
      {
        wish: JSON.parse(key) as PastWish,
        take: (past) => setKnown({ past, problem: "" }),
        failed: (problem) => setKnown((before) => ({ ...before, problem })),
        goesOn: true,
      },
    );
  }, [model, connection, key, session]);
  return known;
}
