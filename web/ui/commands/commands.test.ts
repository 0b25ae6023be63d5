import { describe, expect, it } from "vitest";
import { isForPageInList, isShortcut, isTakenByFocus, shownShortcut } from "./keys.ts";
import { ranked, score } from "./search.ts";

const press = (key: string, more = {}) => ({
  key,
  ctrlKey: false,
  metaKey: false,
  shiftKey: false,
  altKey: false,
  ...more,
});

describe("a shortcut", () => {
  it("is its key with exactly its modifiers", () => {
    expect(isShortcut("ctrl+shift+z", press("Z", { ctrlKey: true, shiftKey: true }))).toBe(true);
    expect(isShortcut("ctrl+z", press("z", { ctrlKey: true, shiftKey: true }))).toBe(false);
    expect(isShortcut("f", press("f"))).toBe(true);
    expect(isShortcut("f", press("f", { ctrlKey: true }))).toBe(false);
    expect(isShortcut("ctrl+.", press(".", { ctrlKey: true }))).toBe(true);
  });
  it("does not care how a sign is typed", () => {
    expect(isShortcut("?", press("?", { shiftKey: true }))).toBe(true);
    expect(isShortcut("+", press("+", { shiftKey: true }))).toBe(true);
    expect(isShortcut("space", press(" "))).toBe(true);
  });
  it("works with Command", () => expect(isShortcut("ctrl+k", press("k", { metaKey: true }))).toBe(true));
  it("is shown as on the keys", () => {
    expect(shownShortcut("ctrl+shift+z")).toBe("Ctrl Shift Z");
    expect(shownShortcut("+")).toBe("+");
    expect(shownShortcut("space")).toBe("Space");
  });
  it("leaves keys to what has the focus", () => {
    document.body.innerHTML = `<input id="a"><button id="b"></button><div role="grid"><p id="c"></p></div><p id="d"></p>`;
    const element = (id: string) => document.getElementById(id);
    expect(isTakenByFocus(element("a"), press("f"))).toBe(true);
    expect(isTakenByFocus(element("b"), press(" "))).toBe(true);
    expect(isTakenByFocus(element("b"), press("f"))).toBe(false);
    expect(isTakenByFocus(element("c"), press("f"))).toBe(true);
    expect(isTakenByFocus(element("d"), press(" "))).toBe(false);
    expect(isTakenByFocus(element("a"), press("k", { ctrlKey: true }))).toBe(false);
    expect(isTakenByFocus(element("a"), press("z", { ctrlKey: true }))).toBe(true);
    expect(isTakenByFocus(element("d"), press("z", { ctrlKey: true }))).toBe(false);
  });
});

describe("a letter in a list", () => {
  it("is the page's, but in menus, dialogs and fields, which are searched by letters", () => {
    document.body.innerHTML = `<div role="grid"><p id="a"></p><input id="b"></div>
      <div role="menu"><p id="c"></p></div><div role="dialog"><div role="listbox"><p id="d"></p></div></div><p id="e"></p>`;
    const is = (id: string, key: string, more = {}) => isForPageInList(document.getElementById(id), press(key, more));
    expect(is("a", "x")).toBe(true);
    expect(is("a", "?")).toBe(true);
    for (const key of [" ", "Enter", "ArrowDown", "Escape"]) expect(is("a", key)).toBe(false);
    expect(is("a", "a", { ctrlKey: true })).toBe(false);
    for (const id of ["b", "c", "d", "e"]) expect(is(id, "x")).toBe(false);
  });
});

describe("the palette", () => {
  const labels = ["Pause", "Step one cycle", "Emergency stop", "Show the log", "Fit the map"];
  it("puts words that begin so first", () => {
    expect(ranked("st", labels, (label) => label)[0]).toBe("Step one cycle");
    expect(ranked("log", labels, (label) => label)).toEqual(["Show the log"]);
  });
  it("finds initials", () => expect(ranked("ftm", labels, (label) => label)[0]).toBe("Fit the map"));
  it("shows everything before anything is typed", () => expect(ranked("", labels, (label) => label)).toEqual(labels));
  it("finds nothing where letters are missing", () => expect(score("xyz", "Pause")).toBe(0));
});
