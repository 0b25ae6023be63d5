// Shortcuts: `ctrl+shift+z`, `f`, `?`, `escape`. On a Mac, ctrl is Command.

export interface KeyPress {
  key: string;
  ctrlKey: boolean;
  metaKey: boolean;
  shiftKey: boolean;
  altKey: boolean;
}

/** Whether the key pressed is this shortcut. Shift is not asked for signs that need it (`?`, `+`). */
export function isShortcut(shortcut: string, press: KeyPress): boolean {
  const parts = shortcut.split("+").filter((part) => part !== "");
  const key = shortcut.endsWith("+") ? "+" : (parts.at(-1) as string);
  const wanted = new Set(shortcut.endsWith("+") ? parts : parts.slice(0, -1));
  if ((press.ctrlKey || press.metaKey) !== wanted.has("ctrl")) return false;
  if (press.altKey !== wanted.has("alt")) return false;
  const isLetter = /^[a-z]$/.test(key);
  if ((isLetter || key.length > 1) && press.shiftKey !== wanted.has("shift")) return false;
  return nameOf(press.key) === key;
}

/** As on a key cap: `Ctrl + K`. */
export function shownShortcut(shortcut: string, isMac = false): string {
  const names: Record<string, string> = {
    ctrl: isMac ? "⌘" : "Ctrl",
    shift: "Shift",
    alt: isMac ? "⌥" : "Alt",
    escape: "Esc",
    space: "Space",
    enter: "Enter",
    delete: "Delete",
    home: "Home",
    arrowleft: "←",
    arrowright: "→",
    arrowup: "↑",
    arrowdown: "↓",
  };
  const parts = shortcut.endsWith("+") ? [...shortcut.slice(0, -1).split("+"), "+"] : shortcut.split("+");
  return parts
    .filter((part) => part !== "")
    .map((part) => names[part] ?? (/^(.|f\d+)$/.test(part) ? part.toUpperCase() : part))
    .join(" ");
}

/**
 * Whether a letter or sign is a shortcut though a list has the focus. Lists of the page are walked by arrows; those that
 * pop up (menus, choices, dialogs) are searched by letters.
 */
export function isForPageInList(target: Element | null, press: KeyPress): boolean {
  if (!target || press.key.length !== 1 || press.key === " " || press.ctrlKey || press.metaKey || press.altKey)
    return false;
  if (target.closest("input, textarea, select, [contenteditable=true], [role=textbox]")) return false;
  if (target.closest("[role=menu], [role=dialog], [role=alertdialog], .popover")) return false;
  return target.closest("[role=listbox], [role=grid], [role=treegrid], [role=tree]") !== null;
}

/** Bare keys belong to what has the focus where that takes them: text, lists, sliders; Space and Enter also to buttons. */
export function isTakenByFocus(target: Element | null, press: KeyPress): boolean {
  if (!target) return false;
  const isField = target.closest("input, textarea, select") !== null;
  // A field undoes its own typing, selects its own text.
  if (press.ctrlKey || press.metaKey) {
    return isField
      ? /^[acvxyz]$/i.test(press.key)
      : target.closest("[contenteditable=true]") !== null && press.key === "a";
  }
  if (isField) {
    const isText = !(target instanceof HTMLInputElement && /^(checkbox|radio|range)$/.test(target.type));
    return isText || press.key.length > 1 || press.key === " ";
  }
  if (target.closest("[contenteditable=true], [role=textbox]")) return true;
  if (target.closest("[role=listbox], [role=grid], [role=menu], [role=tree], [role=dialog], [role=alertdialog]")) {
    return true;
  }
  return (
    (press.key === " " || press.key === "Enter") && target.closest("button, a, [role=button], [role=tab]") !== null
  );
}

function nameOf(key: string): string {
  if (key === " ") return "space";
  return key.toLowerCase();
}
