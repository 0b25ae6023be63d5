// The line itself: a slider over the whole run, or the part of it that is zoomed to.
import {
  type KeyboardEvent,
  memo,
  type PointerEvent,
  type RefObject,
  useEffect,
  useLayoutEffect,
  useRef,
  useState,
} from "react";
import { momentSpoken, momentText } from "../../core/run_time.ts";
import { readableMessage } from "../words/format.ts";
import { nearestEvent, type TimeEvent } from "./events.ts";
import { lookOf, paintTimeLine } from "./paint.ts";
import { movedSpan, type Span, shareOf, timeAt, zoomedSpan } from "./span.ts";

export interface TrackProps {
  span: Span;
  end: number;
  knownTo: number;
  /** That is shown [s]. */
  time: number;
  /** The run goes on, and is shown as it does. */
  isNow: boolean;
  /** What `end` is called: in a run that goes on it is now. */
  endIsNow: boolean;
  events: readonly TimeEvent[];
  found: readonly { readonly time: number; readonly text: string }[];
  isDark: boolean;
  isDisabled: boolean;
  onGo: (time: number) => void;
  onNow: () => void;
  onStep: (cycles: number) => void;
  onEvent: (by: 1 | -1) => void;
  onSpan: (span: Span) => void;
}

const kNear = 6; // px: an event under the pointer
const kPage = 10; // s

export function Track(props: TrackProps) {
  const { span, time, end, isDisabled, isNow, endIsNow } = props;
  const box = useRef<HTMLDivElement>(null);
  const width = useWidth(box);
  const [hover, setHover] = useState<number | "thumb" | null>(null);
  useWheel(box, props);
  const share = shareOf(span, time);
  const isSeen = share >= -0.001 && share <= 1.001;
  const pointed = hover === "thumb" ? Math.min(1, Math.max(0, share)) : hover;
  return (
    <div
      ref={box}
      className="time-track"
      role="slider"
      tabIndex={isDisabled ? -1 : 0}
      aria-label="Moment of the run"
      aria-valuemin={0}
      aria-valuemax={Number(end.toFixed(1))}
      aria-valuenow={Number(Math.min(time, end).toFixed(1))}
      aria-valuetext={isNow ? `now, ${momentSpoken(time)}` : momentSpoken(time)}
      aria-disabled={isDisabled || undefined}
      onKeyDown={(event) => pressOnTrack(event, props)}
      {...usePointer(box, props, setHover)}
    >
      <Picture
        span={span}
        end={end}
        knownTo={props.knownTo}
        events={props.events}
        found={props.found}
        isDark={props.isDark}
        width={width}
      />
      {endIsNow && (
        <span className="time-now-edge" style={{ left: `${100 * shareOf(span, end)}%` }} aria-hidden="true" />
      )}
      {isSeen && (
        <span className="time-thumb" style={{ left: `${100 * Math.min(1, Math.max(0, share))}%` }} aria-hidden="true" />
      )}
      {pointed !== null && width > 0 && <Tip {...props} at={pointed} width={width} />}
    </div>
  );
}

/** The time under the pointer, and what happened there. */
function Tip({ span, events, found, at, width, isDark }: TrackProps & { at: number; width: number }) {
  const time = timeAt(span, at);
  const within = ((span.to - span.from) * kNear) / width;
  const match = nearestEvent(found, time, within);
  const event = nearestEvent(events, time, within);
  const look = event && lookOf(event.kind);
  const said = match ?? event;
  return (
    <span className={`time-tip ${at > 0.5 ? "left" : ""}`} style={{ left: `${100 * at}%` }} aria-hidden="true">
      <b className="number">{momentText(said?.time ?? time)}</b>
      {match && <span>{readableMessage(match.text)}</span>}
      {!match && event && look && (
        <span>
          <i style={{ color: isDark ? look.dark : look.light }}>{look.name}</i> {readableMessage(event.text)}
        </span>
      )}
    </span>
  );
}

type PictureProps = Pick<TrackProps, "span" | "end" | "knownTo" | "events" | "found" | "isDark"> & { width: number };

const Picture = memo(({ span, end, knownTo, events, found, isDark, width }: PictureProps) => {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const element = canvas.current;
    const pen = element?.getContext("2d");
    if (!element || !pen || width === 0) return;
    const height = element.clientHeight;
    const density = window.devicePixelRatio || 1;
    element.width = Math.round(width * density);
    element.height = Math.round(height * density);
    pen.setTransform(density, 0, 0, density, 0, 0);
    const style = getComputedStyle(element);
    const read = (name: string) => style.getPropertyValue(name).trim() || "gray";
    paintTimeLine(pen, width, height, {
      span,
      end,
      knownTo,
      events,
      found,
      isDark,
      colors: {
        line: read("--line-strong"),
        text: read("--text-3"),
        fill: read("--pressed"),
        found: read("--text"),
      },
      font: `11px ${style.fontFamily}`,
    });
  }, [span, end, knownTo, events, found, isDark, width]);
  return <canvas ref={canvas} className="time-picture" />;
});

function useWidth(box: RefObject<HTMLElement | null>): number {
  const [width, setWidth] = useState(0);
  useLayoutEffect(() => {
    const element = box.current;
    if (!element) return;
    const measure = () => setWidth(Math.floor(element.clientWidth));
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, [box]);
  return width;
}

function shareUnder(element: HTMLElement, clientX: number): number {
  const { left, width } = element.getBoundingClientRect();
  return width > 0 ? Math.min(1, Math.max(0, (clientX - left) / width)) : 0;
}

/**
 * Dragging scrubs; at the end of a run that goes on there is now.
 *
 * @param setHover  what is told of: a place under the pointer, or where the thumb is while it is dragged
 */
function usePointer(
  box: RefObject<HTMLDivElement | null>,
  props: TrackProps,
  setHover: (at: number | "thumb" | null) => void,
) {
  const dragged = useRef(false);
  const goTo = (event: PointerEvent): void => {
    const element = box.current;
    if (!element) return;
    const time = timeAt(props.span, shareUnder(element, event.clientX));
    const pixel = (props.span.to - props.span.from) / Math.max(1, element.clientWidth);
    if (props.endIsNow && time >= props.end - 3 * pixel) props.onNow();
    else props.onGo(Math.min(time, props.end));
  };
  const end = () => {
    dragged.current = false;
  };
  return {
    onPointerDown: (event: PointerEvent) => {
      if (props.isDisabled || event.button !== 0) return;
      dragged.current = true;
      (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
      (event.currentTarget as HTMLElement).focus({ preventScroll: true });
      goTo(event);
      event.preventDefault();
    },
    onPointerMove: (event: PointerEvent) => {
      if (dragged.current) {
        setHover("thumb");
        goTo(event);
      } else setHover(box.current ? shareUnder(box.current, event.clientX) : null);
    },
    onPointerLeave: () => setHover(null),
    onPointerUp: end,
    onPointerCancel: end,
    onLostPointerCapture: end,
  };
}

/** The wheel zooms round the pointer; sideways, or with Shift, it moves the part that is shown. */
function useWheel(box: RefObject<HTMLDivElement | null>, props: TrackProps): void {
  const latest = useRef(props);
  latest.current = props;
  useEffect(() => {
    const element = box.current;
    if (!element) return;
    const turn = (event: WheelEvent) => {
      const { span, end, onSpan } = latest.current;
      event.preventDefault();
      const sideways =
        Math.abs(event.deltaX) > Math.abs(event.deltaY) ? event.deltaX : event.shiftKey ? event.deltaY : 0;
      if (sideways !== 0) onSpan(movedSpan(span, Math.sign(sideways) * 0.1, end));
      else
        onSpan(
          zoomedSpan(span, event.deltaY < 0 ? 1.3 : 1 / 1.3, timeAt(span, shareUnder(element, event.clientX)), end),
        );
    };
    element.addEventListener("wheel", turn, { passive: false });
    return () => element.removeEventListener("wheel", turn);
  }, [box]);
}

function pressOnTrack(event: KeyboardEvent, props: TrackProps): void {
  if (props.isDisabled || event.ctrlKey || event.metaKey || event.altKey) return;
  const { time, end, endIsNow } = props;
  const go = (to: number) => (endIsNow && to >= end ? props.onNow() : props.onGo(Math.min(end, Math.max(0, to))));
  switch (event.key) {
    case "ArrowLeft":
    case "ArrowDown":
      if (event.shiftKey) props.onEvent(-1);
      else props.onStep(-1);
      break;
    case "ArrowRight":
    case "ArrowUp":
      if (event.shiftKey) props.onEvent(1);
      else props.onStep(1);
      break;
    case "PageUp":
      go(time + kPage);
      break;
    case "PageDown":
      go(time - kPage);
      break;
    case "Home":
      go(0);
      break;
    case "End":
      go(end);
      break;
    default:
      return;
  }
  event.preventDefault();
  event.stopPropagation();
}
