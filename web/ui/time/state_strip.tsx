// The states of a robot's sequences over the whole run, each as a strip, and as tables for who can't see them.
import { type MouseEvent, useLayoutEffect, useMemo, useRef, useState } from "react";
import { momentText } from "../../core/run_time.ts";
import { Button } from "../controls/controls.tsx";
import { pieceAt, type SequenceTrack, stripsIn } from "./sequences.ts";
import { type Span, shareOf, timeAt, wholeSpan } from "./span.ts";
import "./time.css";

interface StatesProps {
  tracks: readonly SequenceTrack[];
  /** Of the run [s]. */
  end: number;
  knownTo: number;
  /** That is shown [s]. */
  time: number;
  isDark: boolean;
  onGo: (time: number) => void;
  /** A sequence as people call it. */
  nameOf: (path: string) => string;
}

const kLight = ["#1d5fc4", "#b4540a", "#14713f", "#a3195b", "#6a4bc4", "#0b7285", "#7a6200", "#4d5766"];
const kDark = ["#74a8ff", "#ff9f5a", "#5fd08c", "#ff85b8", "#b197fc", "#4fd1e0", "#e3c34e", "#c3ccd8"];
const kHeight = 20; // px
const kMostRows = 200;

export function StateStrips(props: StatesProps) {
  const { tracks, end, knownTo, time } = props;
  const [isTable, setTable] = useState(false);
  if (tracks.length === 0) return <p className="small muted">Its program has no states, or it has not run yet.</p>;
  return (
    <div className="state-strips">
      {tracks.map((track) => (
        <StateRow key={track.path} {...props} track={track} />
      ))}
      {knownTo < end - 2 && (
        <p className="small muted" role="status">
          Being computed: known to {momentText(knownTo)} of {momentText(end)}.
        </p>
      )}
      <Button tone="link" aria-expanded={isTable} onPress={() => setTable(!isTable)}>
        {isTable ? "Hide the table" : "As a table"}
      </Button>
      {isTable && tracks.map((track) => <StateTable key={track.path} {...props} track={track} time={time} />)}
    </div>
  );
}

function StateRow({ track, end, time, isDark, onGo, nameOf }: StatesProps & { track: SequenceTrack }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [width, setWidth] = useState(0);
  const [hover, setHover] = useState<number | null>(null);
  const span = useMemo(() => wholeSpan(end), [end]);
  useLayoutEffect(() => {
    const element = canvas.current;
    if (!element) return;
    const measure = () => setWidth(Math.floor(element.clientWidth));
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  useLayoutEffect(() => paint(canvas.current, track, span, width, isDark), [track, span, width, isDark]);
  const at = pieceAt(track, Math.min(time, end));
  const pointed = hover === null ? undefined : pieceAt(track, timeAt(span, hover));
  const under = (event: MouseEvent<HTMLCanvasElement>) => {
    const { left, width: wide } = event.currentTarget.getBoundingClientRect();
    return Math.min(1, Math.max(0, (event.clientX - left) / Math.max(1, wide)));
  };
  return (
    <div className="state-row">
      <span className="state-row-name small">
        <span className="ellipsis">{nameOf(track.path)}</span>
        <b>{pointed ? `${momentText(pointed.begin)} ${pointed.state}` : (at?.state ?? "–")}</b>
      </span>
      <span className="state-row-line">
        <canvas
          ref={canvas}
          style={{ height: kHeight }}
          role="img"
          aria-label={`States of ${nameOf(track.path)} over the run: ${track.states.join(", ") || "none"}. The table below says when.`}
          onClick={(event) => onGo(timeAt(span, under(event)))}
          onMouseMove={(event) => setHover(under(event))}
          onMouseLeave={() => setHover(null)}
        />
        <span
          className="state-row-at"
          style={{ left: `${100 * Math.min(1, Math.max(0, shareOf(span, time)))}%` }}
          aria-hidden="true"
        />
      </span>
    </div>
  );
}

function paint(
  element: HTMLCanvasElement | null,
  track: SequenceTrack,
  span: Span,
  width: number,
  isDark: boolean,
): void {
  const pen = element?.getContext("2d");
  if (!element || !pen || width === 0) return;
  const density = window.devicePixelRatio || 1;
  element.width = Math.round(width * density);
  element.height = Math.round(kHeight * density);
  pen.setTransform(density, 0, 0, density, 0, 0);
  const style = getComputedStyle(element);
  pen.font = `600 11px ${style.fontFamily}`;
  pen.textBaseline = "middle";
  const colors = isDark ? kDark : kLight;
  for (const { left, right, state } of stripsIn(track, span, width)) {
    pen.fillStyle =
      state < 0 ? style.getPropertyValue("--line-strong").trim() || "gray" : colors[state % colors.length]!;
    pen.fillRect(left, 0, Math.max(right - left, 0.5), kHeight);
    const name = track.states[state] ?? "";
    if (right - left < 24 || pen.measureText(name).width > right - left - 8) continue;
    pen.fillStyle = isDark ? "#10141a" : "#ffffff";
    pen.fillText(name, left + 4, kHeight / 2 + 0.5);
  }
}

/** The rows round the moment that is shown, where there are many. */
function StateTable({ track, time, onGo, nameOf }: StatesProps & { track: SequenceTrack }) {
  const { pieces } = track;
  const at = pieces.findLastIndex((one) => one.begin <= time + 1e-6);
  const first = Math.max(0, Math.min(at - kMostRows / 2, pieces.length - kMostRows));
  const rows = pieces.slice(first, first + kMostRows);
  return (
    <table className="state-table small">
      <caption>
        {nameOf(track.path)}
        {rows.length < pieces.length && `: ${rows.length} of ${pieces.length}, round the moment that is shown`}
      </caption>
      <thead>
        <tr>
          <th scope="col">From</th>
          <th scope="col">To</th>
          <th scope="col">State</th>
        </tr>
      </thead>
      <tbody>
        {rows.map((one, i) => (
          <tr key={one.begin} aria-current={first + i === at ? "true" : undefined}>
            <td className="number">
              <Button tone="link" aria-label={`${momentText(one.begin)}: go there`} onPress={() => onGo(one.begin)}>
                {momentText(one.begin)}
              </Button>
            </td>
            <td className="number">{momentText(one.end)}</td>
            <td>{one.state}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
