import { act } from "react";
import { createRoot, type Root } from "react-dom/client";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { BookmarkPanel, type BookmarkPanelProps } from "./bookmark_panel.tsx";

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

function setUp(more: Partial<BookmarkPanelProps> = {}) {
  const props: BookmarkPanelProps = {
    bookmarks: [
      { id: 1n, time: 12.3, note: "<b>odd</b> & \u202Eback", by: "Anna" },
      { id: 2n, time: 60, note: "", by: "" },
    ],
    time: 60,
    editing: null,
    fresh: null,
    removed: null,
    keptIn: "/runs/a.mcap",
    notKept: "",
    whyNot: "",
    onGo: vi.fn(),
    onEdit: vi.fn(),
    onNote: vi.fn(),
    onRemove: vi.fn(),
    onTakeBack: vi.fn(),
    onClose: vi.fn(),
    ...more,
  };
  act(() => root.render(<BookmarkPanel {...props} />));
  return props;
}

const rows = () => [...host.querySelectorAll<HTMLElement>(".time-found-row")];
const button = (label: string) => host.querySelector<HTMLElement>(`[aria-label="${label}"]`)!;

test("notes are text, whoever wrote them, and keep their direction to themselves", () => {
  setUp();
  expect(rows()[0]!.querySelector("bdi")?.textContent).toBe("<b>odd</b> & \u202Eback");
  expect(host.querySelector("b")).toBeNull();
  expect(rows()[1]!.textContent).toContain("no note");
  expect(rows()[1]!.getAttribute("aria-current")).toBe("true");
});

test("a row goes to its moment, and its buttons write and remove", () => {
  const props = setUp();
  act(() => rows()[0]!.click());
  expect(props.onGo).toHaveBeenCalledWith(12.3);
  act(() => button("Write the note of 0:12.3").click());
  expect(props.onEdit).toHaveBeenCalledWith(1n);
  act(() => button("Remove the bookmark of 1:00.0").click());
  expect(props.onRemove).toHaveBeenCalledWith(2n);
});

test("Enter keeps a note once, Escape leaves it as it was", () => {
  const props = setUp({ editing: 2n });
  const field = host.querySelector("input")!;
  expect(document.activeElement).toBe(field);
  const press = (key: string) =>
    act(() => void field.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true })));
  press("Enter");
  act(() => field.blur());
  expect(props.onNote).toHaveBeenCalledTimes(1);
  expect(props.onNote).toHaveBeenCalledWith(2n, "");
  act(() => root.unmount());
  root = createRoot(host);
  const again = setUp({ editing: 2n });
  const other = host.querySelector("input")!;
  act(() => void other.dispatchEvent(new KeyboardEvent("keydown", { key: "Escape", bubbles: true, cancelable: true })));
  expect(again.onEdit).toHaveBeenCalledWith(null);
  expect(again.onNote).not.toHaveBeenCalled();
  expect(again.onClose).not.toHaveBeenCalled();
});

test("says what is not kept, and what was removed can come back", () => {
  const props = setUp({ notKept: "`/runs/a.mcap.bookmarks` can't be written: no space", removed: "0:10.0 “odd”" });
  expect(host.querySelector("[role=alert]")?.textContent).toContain("can't be written: no space");
  const undo = [...host.querySelectorAll<HTMLElement>("button")].find((one) => one.textContent === "Undo")!;
  act(() => undo.click());
  expect(props.onTakeBack).toHaveBeenCalledTimes(1);
});
