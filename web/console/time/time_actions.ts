// Going through the run, among all that can be done.

import { shownEvents } from "../../ui/time/events.ts";
import type { ActionTable } from "../session/registry.ts";
import type { Session } from "../session/session.ts";
import { bookmarksOf } from "./bookmarks.ts";
import { futureOf } from "./future_store.ts";
import { travelOf } from "./time_travel.ts";

/** As in ui/commands/keys.ts; free in the console and in the designer. */
export const kTimeKeys = {
  back: "j",
  on: "k",
  "event-back": "shift+j",
  "event-on": "shift+k",
  play: "g",
  "play-back": "shift+g",
  now: "e",
  find: "q",
  bookmark: "i",
  bookmarks: "shift+i",
} as const;

const fixed = (session: Session) => travelOf(session).whyNot;

const atNow = (session: Session) =>
  travelOf(session).whereabouts().isNow ? "The run is shown as it goes on." : undefined;

const atBeginning = (session: Session) =>
  travelOf(session).whereabouts().time <= 0 ? "This is the beginning of the run." : undefined;

const atEnd = (session: Session) => {
  const travel = travelOf(session);
  const { isNow, time } = travel.whereabouts();
  if (isNow) return "The run is shown as it goes on.";
  return session.model.isRecording() && time >= travel.end - 1e-6 ? "This is the end of the recording." : undefined;
};

const noEvents = (session: Session) => {
  const travel = travelOf(session);
  return shownEvents(travel.events(), travel.get("hidden")).length > 0 ? undefined : "Nothing has happened.";
};

export const kTimeTable: ActionTable = {
  group: "Time",
  rows: [
    {
      id: "time-play",
      label: (session) => (travelOf(session).whereabouts().speed > 0 ? "Let the past stand" : "Play what was"),
      icon: "play",
      shortcut: kTimeKeys.play,
      unless: [fixed, atNow],
      run: (session) => {
        const travel = travelOf(session);
        travel.does.play(travel.whereabouts().speed > 0 ? 0 : 1);
      },
    },
    {
      id: "time-play-back",
      label: (session) => (travelOf(session).whereabouts().speed < 0 ? "Let the past stand" : "Play backwards"),
      icon: "play_back",
      shortcut: kTimeKeys["play-back"],
      unless: [fixed, atBeginning],
      run: (session) => {
        const travel = travelOf(session);
        travel.does.play(travel.whereabouts().speed < 0 ? 0 : -1);
      },
    },
    {
      id: "time-back",
      label: "Look a cycle back",
      icon: "cycle_back",
      shortcut: kTimeKeys.back,
      unless: [fixed, atBeginning],
      run: (session) => travelOf(session).does.step(-1),
    },
    {
      id: "time-on",
      label: "Look a cycle on",
      icon: "cycle_on",
      shortcut: kTimeKeys.on,
      unless: [fixed, atEnd],
      run: (session) => travelOf(session).does.step(1),
    },
    {
      id: "time-event-back",
      label: "Look at the event before",
      icon: "event_back",
      shortcut: kTimeKeys["event-back"],
      unless: [fixed, noEvents],
      run: (session) => travelOf(session).does.event(-1),
    },
    {
      id: "time-event-on",
      label: "Look at the next event",
      icon: "event_on",
      shortcut: kTimeKeys["event-on"],
      unless: [fixed, noEvents, atEnd],
      run: (session) => travelOf(session).does.event(1),
    },
    {
      id: "time-beginning",
      label: "Look at the beginning of the run",
      icon: "rewind",
      unless: [fixed, atBeginning],
      run: (session) => travelOf(session).does.go(0),
    },
    {
      id: "time-now",
      label: (session) => (session.model.isRecording() ? "Look at the end of the recording" : "Back to now"),
      icon: "right",
      shortcut: kTimeKeys.now,
      unless: [fixed, atEnd],
      run: (session) => travelOf(session).does.now(),
    },
    {
      id: "time-find",
      label: "Find moments…",
      icon: "search",
      shortcut: kTimeKeys.find,
      unless: [fixed],
      run: (session) => travelOf(session).set("isFinding", true),
    },
    {
      id: "bookmark",
      label: "Bookmark this moment",
      icon: "bookmark",
      shortcut: kTimeKeys.bookmark,
      unless: [(session) => bookmarksOf(session).whyNot],
      run: (session) => void bookmarksOf(session).mark(),
    },
    {
      id: "bookmarks",
      label: (session) => (bookmarksOf(session).get("isOpen") ? "Close the list of bookmarks" : "List the bookmarks"),
      icon: "bookmarks",
      shortcut: kTimeKeys.bookmarks,
      unless: [(session) => (session.model.get("bookmarks") ? undefined : "The server knows of no bookmarks.")],
      run: (session) => bookmarksOf(session).toggle(),
    },
    {
      id: "time-what-if",
      label: "What if…",
      icon: "question",
      unless: [fixed],
      run: (session) => futureOf(session).open(),
    },
  ],
};
