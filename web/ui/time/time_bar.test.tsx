import { act } from "react";
import { createRoot, type Root } from "react-dom/client";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { TimeBar, type TimeBarProps, type TimeDoes } from "./time_bar.tsx";

(globalThis as { IS_REACT_ACT_ENVIRONMENT?: boolean }).IS_REACT_ACT_ENVIRONMENT = true;

let root: Root;
let host: HTMLElement;

beforeEach(() => {
  host = document.createElement("div");
  document.body.append(host);
  root = createRoot(host);
});
afterEach(() => {
  act(() => root.unmount());
  host.remove();
});

function setUp(more: Partial<TimeBarProps> = {}) {
  const does: TimeDoes = {
    go: vi.fn(),
    now: vi.fn(),
    step: vi.fn(),
    event: vi.fn(),
    play: vi.fn(),
    speed: vi.fn(),
    hide: vi.fn(),
    find: vi.fn(),
    bookmark: vi.fn(),
    bookmarks: vi.fn(),
  };
  const props: TimeBarProps = {
    at: { time: 133.4, cycle: 1334, speed: 0, isNow: false, isComing: false, problem: "" },
    end: 302,
    knownTo: 302,
    endIsNow: true,
    whyNot: "",
    note: "",
    events: [],
    all: [],
    found: [],
    hidden: new Set(),
    speed: 1,
    isDark: false,
    keys: {
      back: "J",
      on: "K",
      "event-back": "",
      "event-on": "",
      play: "G",
      "play-back": "",
      now: "E",
      find: "Q",
      bookmark: "I",
      bookmarks: "",
    },
    isFinding: false,
    isListing: false,
    bookmarks: 0,
    whyNoBookmark: "",
    does,
    ...more,
  };
  act(() => root.render(<TimeBar {...props} />));
  const slider = host.querySelector("[role=slider]") as HTMLElement;
  const press = (key: string, options = {}) =>
    act(
      () =>
        void slider.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...options })),
    );
  return { does, slider, press };
}

test("the line is a slider that says the moment in words", () => {
  const { slider } = setUp();
  expect(slider.getAttribute("aria-valuetext")).toBe("2 min 13.4 s");
  expect(slider.getAttribute("aria-valuemax")).toBe("302");
  act(() => root.unmount());
  root = createRoot(host);
  const now = setUp({ at: { time: 302, cycle: 3020, speed: 0, isNow: true, isComing: false, problem: "" } });
  expect(now.slider.getAttribute("aria-valuetext")).toBe("now, 5 min 2.0 s");
});

test("arrows step by cycles, with Shift by events, Page keys by ten seconds, Home and End to the ends", () => {
  const { does, press } = setUp();
  press("ArrowLeft");
  press("ArrowRight");
  expect(does.step).toHaveBeenNthCalledWith(1, -1);
  expect(does.step).toHaveBeenNthCalledWith(2, 1);
  press("ArrowLeft", { shiftKey: true });
  expect(does.event).toHaveBeenCalledWith(-1);
  press("PageDown");
  expect(does.go).toHaveBeenLastCalledWith(133.4 - 10);
  press("Home");
  expect(does.go).toHaveBeenLastCalledWith(0);
  press("End");
  expect(does.now).toHaveBeenCalledTimes(1);
});

test("at the end of a recording there is no now", () => {
  const { does, press } = setUp({ endIsNow: false });
  press("End");
  expect(does.now).not.toHaveBeenCalled();
  expect(does.go).toHaveBeenLastCalledWith(302);
});

test("where no other moment can be looked at the line says why, and no key moves it", () => {
  const { does, slider, press } = setUp({ whyNot: "Its robots are elsewhere, in real time." });
  expect(host.querySelector("[role=status]")?.textContent).toBe("Its robots are elsewhere, in real time.");
  expect(slider.getAttribute("aria-disabled")).toBe("true");
  press("ArrowLeft");
  press("Home");
  expect(does.step).not.toHaveBeenCalled();
  expect(does.go).not.toHaveBeenCalled();
});

test("who is in the field for the time finds it at rest while time goes on, and what is typed there is gone to", () => {
  const first = setUp();
  const field = host.querySelector("input") as HTMLInputElement;
  act(() => field.focus());
  const later = { time: 134.9, cycle: 1349, speed: 0, isNow: false, isComing: false, problem: "" };
  const { does } = setUp({ at: later });
  expect(field.value).toBe("2:13.4");
  act(() => {
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")!.set!.call(field, "8");
    field.dispatchEvent(new Event("input", { bubbles: true }));
  });
  act(() => void field.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true, cancelable: true })));
  expect(does.go).toHaveBeenLastCalledWith(8);
  expect(first.does.go).not.toHaveBeenCalled();
  expect(field.value).toBe("2:14.9");
});
