// The card of the guided first tour, and the ring round what it is about.
import { type RefObject, useEffect, useRef, useState } from "react";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { useDesigner, usePart } from "../session/use.ts";
import { fit, nodeElement } from "../sight/view.ts";
import { bestCorner, type Corner, isInside } from "./corner.ts";
import { kTourSteps, nodesOf, type Step } from "./steps.ts";
import "./tour.css";

export function Tour() {
  const designer = useDesigner();
  const at = usePart((state) => state.tour);
  const step = kTourSteps[at];
  const isDone = usePart((state) => kTourSteps[state.tour]?.isDone?.(state) ?? false);
  const waits = usePart((state) => state.tourWaits);
  useInSight(step);
  const card = useRef<HTMLElement>(null);
  const corner = useCorner(card, step !== undefined);
  useEffect(() => {
    if (!isDone) designer.store.setState({ tourWaits: false });
    if (!isDone || waits) return;
    const timer = setTimeout(() => go(designer, at + 1), 500);
    return () => clearTimeout(timer);
  }, [isDone, waits, at, designer]);
  const next = usePart((state) => kTourSteps[state.tour]?.next?.(state) ?? "");
  if (!step) return null;
  const isLast = at === kTourSteps.length - 1;
  return (
    <>
      <Ring selector={step.at ?? ""} next={next} />
      <section ref={card} className={`tour-card ${corner}`} aria-label="Guided tour" aria-live="polite">
        <header>
          <h2>{step.title}</h2>
          <span className="small muted">
            {at + 1} of {kTourSteps.length}
          </span>
          <IconButton icon="close" label="Leave the tour" onPress={() => go(designer, -1)} />
        </header>
        <p>{step.text}</p>
        <footer>
          {at > 0 && (
            <Button tone="quiet" onPress={() => go(designer, at - 1)}>
              Back
            </Button>
          )}
          <span className="grow" />
          {isDone && !isLast && <span className="pill go">Done</span>}
          <Button
            tone={step.isDone && !isDone ? "plain" : "primary"}
            onPress={() => go(designer, isLast ? -1 : at + 1)}
          >
            {isLast ? "Finish" : step.isDone && !isDone ? "Skip" : "Next"}
          </Button>
        </footer>
      </section>
    </>
  );
}

function go(designer: ReturnType<typeof useDesigner>, step: number): void {
  const tourWaits = kTourSteps[step]?.isDone?.(designer.state) ?? false;
  designer.store.setState({ tour: step < kTourSteps.length ? step : -1, tourWaits });
}

/** Brings what a step speaks of into sight when the step comes. */
function useInSight(step: Step | undefined): void {
  const designer = useDesigner();
  useEffect(() => {
    const area = document.querySelector(".canvas")?.getBoundingClientRect();
    if (!step || !area) return;
    const boxes = nodesOf(step, designer.drawing).map((name) => nodeElement(name)?.getBoundingClientRect());
    if (boxes.some((box) => box && !isInside(box, area))) fit();
  }, [step, designer]);
}

/** Out of the way of what is drawn. It stays under the pointer, and while it has the focus. */
function useCorner(card: RefObject<HTMLElement | null>, isShown: boolean): Corner {
  const [corner, setCorner] = useState<Corner>("bottom-right");
  useEffect(() => {
    if (!isShown) return;
    const look = () => {
      const own = card.current;
      const area = document.querySelector(".canvas")?.getBoundingClientRect();
      if (!own || !area || own.matches(":hover, :focus-within")) return;
      const drawn = [...document.querySelectorAll(".canvas .react-flow__node")].map((one) =>
        one.getBoundingClientRect(),
      );
      const { offsetWidth: width, offsetHeight: height } = own;
      setCorner((now) => bestCorner(area, { width, height }, drawn, now));
    };
    look();
    const timer = setInterval(look, 400);
    return () => clearInterval(timer);
  }, [card, isShown]);
  return corner;
}

/** Round the part of the page that the step is about, or the component that comes next, which is brought into sight. */
function Ring({ selector, next }: { selector: string; next: string }) {
  const [box, setBox] = useState<DOMRect | null>(null);
  useEffect(() => {
    let shown: Element | null = null;
    const look = () => {
      const entry = next ? document.querySelector(`.palette-entry[data-component="${CSS.escape(next)}"]`) : null;
      if (entry && entry !== shown) entry.scrollIntoView({ block: "center" });
      shown = entry;
      const found = entry && isInSight(entry) ? entry : selector ? document.querySelector(selector) : null;
      setBox(found?.getBoundingClientRect() ?? null);
    };
    look();
    const timer = setInterval(look, 400);
    return () => clearInterval(timer);
  }, [selector, next]);
  if (!box || box.width > window.innerWidth * 0.6) return null;
  return (
    <div
      className="tour-ring"
      aria-hidden="true"
      style={{ left: box.x - 4, top: box.y - 4, width: box.width + 8, height: box.height + 8 }}
    />
  );
}

/** Somebody may have scrolled it away. */
function isInSight(entry: Element): boolean {
  const { top, bottom } = entry.getBoundingClientRect();
  const panel = entry.closest(".panel")?.getBoundingClientRect();
  return !panel || (top >= panel.top && bottom <= panel.bottom);
}
