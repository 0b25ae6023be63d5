// The parts of the page that the keyboard goes to and fro between, and which of them has the focus.

/** In the order in which they stand on the page. */
const kPanes = ".topbar, .dock, .canvas, .strip";
// Of a part, the first of these that it has takes the focus.
const kTakers = [".cm-content", ".panel", "button:not([disabled])"];

let last: Element | null = null;
let isByKey = false;
let isByTab = false;

/** Keeps in mind where the focus was, and whether keys are what the person works with. */
export function watchPanes(): () => void {
  const focused = (event: FocusEvent) => {
    if (event.target instanceof Element) last = event.target.closest(kPanes) ?? last;
  };
  const key = (event: KeyboardEvent) => {
    if (/^(Control|Shift|Alt|Meta)$/.test(event.key)) return;
    isByKey = true;
    isByTab = event.key === "Tab";
  };
  const pointer = () => {
    isByKey = false;
    isByTab = false;
  };
  window.addEventListener("focusin", focused);
  window.addEventListener("keydown", key, { capture: true });
  window.addEventListener("pointerdown", pointer, { capture: true });
  return () => {
    window.removeEventListener("focusin", focused);
    window.removeEventListener("keydown", key, { capture: true });
    window.removeEventListener("pointerdown", pointer, { capture: true });
  };
}

/** The focus goes to the next part of the page, or (-1) the one before. */
export function goToPane(step: 1 | -1): void {
  const panes = [...document.querySelectorAll(kPanes)];
  if (panes.length === 0) return;
  const here = document.activeElement?.closest(kPanes) ?? last;
  const at = here ? panes.indexOf(here) : -1;
  // From nowhere to the drawing, which is what a person comes for.
  const next = at < 0 ? panes.findIndex((pane) => pane.matches(".canvas")) : (at + step + panes.length) % panes.length;
  takerOf(panes[Math.max(0, next)]!)?.focus();
}

function takerOf(pane: Element): HTMLElement | null {
  if (pane instanceof HTMLElement && pane.matches(".canvas")) {
    return pane.querySelector<HTMLElement>(".react-flow__node.selected") ?? pane;
  }
  for (const taker of kTakers) {
    const found = pane.querySelector<HTMLElement>(taker);
    if (found) return found;
  }
  return null;
}

/** Whether it is the Tab key that moves the focus, and not a click, or a dialog that gives it back. */
export function isTabbed(): boolean {
  return isByTab;
}

const kGivenBack = 80; // a dialog that closes gives the focus back within this time [ms]
let offer: ReturnType<typeof setTimeout> | undefined;

/** Where nothing has the focus and keys are used, it goes to `element`: once a dialog had time to give it back. */
export function offerFocus(element: HTMLElement | null): void {
  clearTimeout(offer);
  if (!isLost()) return;
  offer = setTimeout(() => isLost() && element?.focus({ preventScroll: true }), kGivenBack);
}

function isLost(): boolean {
  return isByKey && document.activeElement === document.body;
}
