// Which part of a run the time line shows, and where a moment lies on it.

/** [s] */
export interface Span {
  readonly from: number;
  readonly to: number;
}

const kShortest = 0.5; // s: closer, cycles lie farther apart than a thumb is wide

/** The whole run; at least a second, so that there is something to see. */
export function wholeSpan(end: number): Span {
  return { from: 0, to: Math.max(end, 1) };
}

/** Closer by `factor` (below 1: farther) round a moment, inside of the run; the whole run where that is all. */
export function zoomedSpan(span: Span, factor: number, round: number, end: number): Span {
  const whole = wholeSpan(end);
  const length = Math.max(Math.min(kShortest, whole.to), (span.to - span.from) / factor);
  if (length >= whole.to) return whole;
  const share = (round - span.from) / (span.to - span.from);
  return inside({ from: round - share * length, to: round + (1 - share) * length }, end);
}

/** By a share of its length, to later if positive. */
export function movedSpan(span: Span, share: number, end: number): Span {
  const by = (span.to - span.from) * share;
  return inside({ from: span.from + by, to: span.to + by }, end);
}

/** The same length with the moment in sight: where it isn't, it gets a tenth of room before or behind it. */
export function spanWith(span: Span, time: number, end: number): Span {
  if (time >= span.from && time <= span.to) return span;
  const length = span.to - span.from;
  const from = time > span.to ? time - 0.9 * length : time - 0.1 * length;
  return inside({ from, to: from + length }, end);
}

function inside({ from, to }: Span, end: number): Span {
  const { to: last } = wholeSpan(end);
  const by = from < 0 ? -from : Math.min(0, last - to);
  return { from: Math.max(0, from + by), to: Math.min(last, to + by) };
}

/** 0 to 1 inside of the span. */
export function shareOf(span: Span, time: number): number {
  return (time - span.from) / (span.to - span.from);
}

export function timeAt(span: Span, share: number): number {
  return span.from + Math.min(1, Math.max(0, share)) * (span.to - span.from);
}

const kSteps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 28800, 86400];

/** Round moments for labels, at most so many. */
export function clockTicks({ from, to }: Span, most: number): number[] {
  const step = kSteps.find((one) => (to - from) / one <= Math.max(1, most)) ?? kSteps.at(-1)!;
  const first = Math.ceil(from / step - 1e-9);
  const last = Math.floor(to / step + 1e-9);
  const every = Math.max(1, Math.ceil((last - first + 1) / Math.max(1, most + 1)));
  const ticks: number[] = [];
  for (let i = first; i <= last; i += every) ticks.push(Number((i * step).toFixed(1)));
  return ticks;
}

/** `2:10`, below a second's step `2:10.5`. */
export function tickText(time: number, isFine: boolean): string {
  const seconds = isFine ? Math.round(time * 10) / 10 : Math.round(time);
  const minutes = Math.floor(seconds / 60);
  const hours = Math.floor(minutes / 60);
  const rest = isFine ? (seconds % 60).toFixed(1).padStart(4, "0") : String(seconds % 60).padStart(2, "0");
  return hours > 0 ? `${hours}:${String(minutes % 60).padStart(2, "0")}:${rest}` : `${minutes}:${rest}`;
}
