// Draws the time line: where it is not known yet, what happened, what was found, round moments.
import { type EventKind, type EventLook, firstFrom, kLooks, type TimeEvent } from "./events.ts";
import { clockTicks, type Span, shareOf, tickText } from "./span.ts";

export interface Painted {
  readonly span: Span;
  readonly end: number;
  readonly knownTo: number;
  readonly events: readonly TimeEvent[];
  /** What was looked for. */
  readonly found: readonly { readonly time: number }[];
  readonly isDark: boolean;
  readonly colors: { line: string; text: string; fill: string; found: string };
  readonly font: string;
}

const kLabels = 14; // px, below the events
const kLabelRoom = 76; // px for each

/** On a canvas of this size in CSS pixels. */
export function paintTimeLine(pen: CanvasRenderingContext2D, width: number, height: number, painted: Painted): void {
  pen.clearRect(0, 0, width, height);
  const band = height - kLabels;
  const x = (time: number) => shareOf(painted.span, time) * width;
  paintKnown(pen, band, x, painted);
  paintLabels(pen, width, height, x, painted);
  for (const look of kLooks) paintKind(pen, look, width, band, x, painted);
  paintFound(pen, width, band, x, painted);
}

/** As far as the run goes it has a ground; what would have to be computed first is hatched. */
function paintKnown(
  pen: CanvasRenderingContext2D,
  band: number,
  x: (time: number) => number,
  { end, knownTo, colors }: Painted,
): void {
  const from = Math.max(0, x(0));
  const known = Math.max(from, x(Math.min(knownTo, end)));
  const to = Math.max(known, x(end));
  pen.fillStyle = colors.fill;
  pen.fillRect(from, 0, to - from, band);
  if (to - known < 1) return;
  pen.save();
  pen.beginPath();
  pen.rect(known, 0, to - known, band);
  pen.clip();
  pen.strokeStyle = colors.line;
  pen.lineWidth = 1;
  pen.beginPath();
  for (let at = known - band; at < to; at += 6) {
    pen.moveTo(at, band);
    pen.lineTo(at + band, 0);
  }
  pen.stroke();
  pen.restore();
}

function paintLabels(
  pen: CanvasRenderingContext2D,
  width: number,
  height: number,
  x: (time: number) => number,
  { span, colors, font }: Painted,
): void {
  const ticks = clockTicks(span, Math.max(1, Math.floor(width / kLabelRoom)));
  const isFine = ticks.some((time) => Math.abs(time - Math.round(time)) > 0.01);
  pen.font = font;
  pen.fillStyle = colors.text;
  pen.strokeStyle = colors.line;
  pen.textBaseline = "alphabetic";
  pen.beginPath();
  for (const time of ticks) {
    const at = Math.round(x(time)) + 0.5;
    pen.moveTo(at, height - kLabels);
    pen.lineTo(at, height - kLabels + 4);
    const text = tickText(time, isFine);
    const half = pen.measureText(text).width / 2;
    pen.fillText(text, Math.min(width - 2 * half, Math.max(0, at - half)), height - 2);
  }
  pen.stroke();
}

/** At least so far apart [px]: signs that touch are none. */
const kApart: Record<EventLook["shape"], number> = {
  bar: 4,
  low: 3,
  dot: 4,
  square: 8,
  circle: 9,
  diamond: 11,
  down: 11,
  up: 11,
  ribbon: 10,
};

/** Signs of a kind keep a little room, so that thousands of events cost no more than the line is wide and stay signs. */
function paintKind(
  pen: CanvasRenderingContext2D,
  look: EventLook,
  width: number,
  band: number,
  x: (time: number) => number,
  { span, events, isDark }: Painted,
): void {
  pen.fillStyle = isDark ? look.dark : look.light;
  let last = Number.NEGATIVE_INFINITY;
  pen.beginPath();
  const reach = (6 * (span.to - span.from)) / Math.max(1, width);
  for (let i = firstFrom(events, span.from - reach); i < events.length; ++i) {
    const event = events[i]!;
    if (event.time > span.to + reach) break;
    if (event.kind !== look.kind) continue;
    const at = Math.round(x(event.time));
    if (at < last + kApart[look.shape]) continue;
    last = at;
    addSign(pen, look.shape, at, look.height * band, band);
  }
  pen.fill();
}

function paintFound(
  pen: CanvasRenderingContext2D,
  width: number,
  band: number,
  x: (time: number) => number,
  { found, colors }: Painted,
): void {
  pen.strokeStyle = colors.found;
  pen.lineWidth = 2;
  pen.beginPath();
  let last = Number.NEGATIVE_INFINITY;
  for (const { time } of found) {
    const at = Math.round(x(time));
    if (at < 0 || at > width || at <= last + 1) continue;
    last = at;
    pen.moveTo(at, 0);
    pen.lineTo(at, band);
    // A flag, so that it is no step.
    pen.moveTo(at - 4, 1);
    pen.lineTo(at + 4, 1);
  }
  pen.stroke();
}

/** The outline of a sign round a point. */
export function addSign(
  pen: Pick<CanvasRenderingContext2D, "moveTo" | "lineTo" | "arc" | "rect" | "closePath">,
  shape: EventLook["shape"],
  x: number,
  y: number,
  band: number,
): void {
  const polygon = (...points: number[]) => {
    pen.moveTo(x + points[0]!, y + points[1]!);
    for (let i = 2; i < points.length; i += 2) pen.lineTo(x + points[i]!, y + points[i + 1]!);
    pen.closePath();
  };
  switch (shape) {
    case "bar":
      pen.rect(x - 1, 0, 2, band);
      break;
    case "low":
      pen.rect(x - 0.5, band * 0.74, 1, band * 0.26);
      break;
    case "square":
      pen.rect(x - 2.5, y - 2.5, 5, 5);
      break;
    case "dot":
      pen.rect(x - 1, y - 1, 2, 2);
      break;
    case "circle":
      pen.moveTo(x + 3, y);
      pen.arc(x, y, 3, 0, 2 * Math.PI);
      break;
    case "diamond":
      polygon(0, -4, 4, 0, 0, 4, -4, 0);
      break;
    case "down":
      polygon(-4, -3, 4, -3, 0, 4);
      break;
    case "ribbon":
      polygon(-4, -6, 4, -6, 4, 6, 0, 2.5, -4, 6);
      break;
    case "up":
      polygon(0, -4, 4, 3, -4, 3);
      break;
  }
}

export function lookOf(kind: EventKind): EventLook {
  return kLooks.find((look) => look.kind === kind)!;
}
