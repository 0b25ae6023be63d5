// One strip: its title, a legend with the values at the cursor, and the lines.
import { type RefObject, useEffect, useLayoutEffect, useRef, useState } from "react";
import { Button } from "react-aria-components";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { Recorder } from "./recorder.ts";
import { alignSamples, valueAt } from "./samples.ts";
import type { SeriesSpec } from "./series.ts";
import type { Strip } from "./strips.ts";
import { valueText } from "./ticks.ts";

interface Props {
  strip: Strip;
  recorder: Recorder;
  span: { from: number; to: number };
  /** Grows whenever there is something new to draw. */
  revision: number;
  colors: readonly string[];
  look: { text: string; grid: string; past: string; font: string };
  /** Run time under the cursor of any strip; null: none. */
  cursor: number | null;
  /** That is shown, where it is not now [s]. */
  moment: number | null;
  onCursor: (time: number | null) => void;
  /** To another moment. */
  onGo: (time: number) => void;
  onZoom: (from: number, to: number) => void;
  onReset: () => void;
  onRemove: (spec: SeriesSpec) => void;
  onPlot: (key: string, plot: uPlot | null) => void;
}

const kHeight = 132;

export function PlotStrip(props: Props) {
  const { strip } = props;
  const host = useRef<HTMLDivElement>(null);
  usePlot(host, props);
  return (
    <section className="plot-strip" aria-label={`Plot of ${strip.title}`}>
      <header>
        <h3>
          {strip.title}
          {strip.unit !== "" && <span className="plot-unit"> [{strip.unit}]</span>}
        </h3>
        <Legend {...props} />
      </header>
      <div ref={host} className="plot-canvas" aria-hidden="true" />
    </section>
  );
}

/** The plot in `host`, made anew when its lines or its looks change, drawn anew when what it shows does. */
function usePlot(host: RefObject<HTMLDivElement | null>, props: Props): void {
  const { strip, span, revision } = props;
  const plot = useRef<uPlot | null>(null);
  const latest = useRef(props);
  latest.current = props;
  const [width, setWidth] = useState(0);

  useLayoutEffect(() => {
    const element = host.current;
    if (!element) return;
    const observer = new ResizeObserver(() => setWidth(Math.floor(element.clientWidth)));
    observer.observe(element);
    setWidth(Math.floor(element.clientWidth));
    return () => observer.disconnect();
  }, [host]);

  const lines = strip.lines.map((line) => `${line.key} ${line.color} ${line.dash.join(" ")}`).join("\n");
  const look = JSON.stringify([props.colors, props.look]);
  useEffect(() => {
    if (!host.current || width === 0) return;
    const made = new uPlot(
      optionsOf(latest, width),
      [[], ...strip.lines.map(() => [])] as uPlot.AlignedData,
      host.current,
    );
    plot.current = made;
    latest.current.onPlot(strip.key, made);
    draw(made, latest.current);
    return () => {
      latest.current.onPlot(strip.key, null);
      plot.current = null;
      made.destroy();
    };
  }, [host, lines, look, strip.unit, width > 0]);

  useEffect(() => {
    if (width > 0) plot.current?.setSize({ width, height: kHeight });
  }, [width]);

  useEffect(() => {
    if (plot.current) draw(plot.current, latest.current);
  }, [revision, span.from, span.to, lines]);

  useEffect(() => {
    plot.current?.redraw(false);
  }, [props.moment]);
}

/** What each line is, with its value under the pointer; else the newest. */
function Legend({ strip, recorder, span, cursor, moment, colors, onRemove }: Props) {
  const time = cursor ?? moment ?? span.to;
  return (
    <ul className="plot-legend">
      {strip.lines.map((line) => {
        const recording = recorder.recordingOf(line.key);
        const value = recording ? valueAt(recording.buffer.within(time, time), time) : null;
        return (
          <li key={line.key} title={recording?.error || undefined}>
            <Swatch color={colors[line.color] ?? "gray"} dash={line.dash} />
            <span className="plot-label">{line.label}</span>
            <span className="plot-value">{recording?.error ? "no data" : valueText(value)}</span>
            <Button
              className="plot-remove"
              aria-label={`Remove ${strip.title} of ${line.label}`}
              onPress={() => onRemove(line.spec)}
            >
              ×
            </Button>
          </li>
        );
      })}
    </ul>
  );
}

function Swatch({ color, dash }: { color: string; dash: readonly number[] }) {
  return (
    <svg className="plot-swatch" viewBox="0 0 20 6" aria-hidden="true">
      <line x1="0" y1="3" x2="20" y2="3" stroke={color} strokeWidth="3" strokeDasharray={dash.join(" ") || undefined} />
    </svg>
  );
}

function draw(plot: uPlot, { strip, recorder, span }: Props): void {
  const empty = { times: new Float64Array(0), values: new Float64Array(0) };
  const samples = strip.lines.map((l) => recorder.recordingOf(l.key)?.buffer.within(span.from, span.to) ?? empty);
  const table = alignSamples(samples);
  plot.batch(() => {
    plot.setData([table.times, ...table.columns] as uPlot.AlignedData, false);
    plot.setScale("x", { min: span.from, max: span.to });
    const [low, high] = rangeInside(table.times, table.columns, span);
    plot.setScale("y", { min: low, max: high });
  });
}

/** Of the values that are shown, with some room. */
function rangeInside(
  times: readonly number[],
  columns: readonly (readonly (number | null | undefined)[])[],
  span: { from: number; to: number },
): [number, number] {
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  times.forEach((t, i) => {
    if (t < span.from || t > span.to) return;
    for (const column of columns) {
      const v = column[i];
      if (v === null || v === undefined) continue;
      low = Math.min(low, v);
      high = Math.max(high, v);
    }
  });
  if (low > high) return [0, 1];
  const room = high > low ? (high - low) * 0.06 : Math.max(Math.abs(low) * 0.1, 0.5);
  return [low - room, high + room];
}

function optionsOf(latest: { current: Props }, width: number): uPlot.Options {
  const { strip, colors } = latest.current;
  return {
    width,
    height: kHeight,
    padding: [6, 10, 0, 0],
    legend: { show: false },
    scales: { x: { time: false, auto: false }, y: { auto: false } },
    series: [
      {},
      ...strip.lines.map((line) => ({
        label: line.label,
        stroke: colors[line.color] ?? "gray",
        width: 1.75,
        dash: [...line.dash],
        points: { show: false },
      })),
    ],
    axes: axesOf(latest.current),
    cursor: {
      y: false,
      points: { size: 6 },
      drag: { x: true, y: false, setScale: false, dist: 5 },
      sync: { key: "mlab.plots", setSeries: false },
      bind: bindingsOf(latest),
    },
    hooks: hooksOf(latest),
  };
}

const kDoubleClick = 260; // ms in which a click becomes two

/** A click goes to its moment, a double click back to all; dragging chooses a span, which hooks tell. */
function bindingsOf(latest: { current: Props }): uPlot.Cursor.Bind {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let pressed = 0;
  return {
    mousedown: (_, __, handler) => (event: MouseEvent) => {
      pressed = event.clientX;
      return handler(event);
    },
    click: (u) => (event: MouseEvent) => {
      clearTimeout(timer);
      if (event.detail > 1 || Math.abs(event.clientX - pressed) > 3) return null;
      const time = u.posToVal(u.cursor.left ?? -1, "x");
      timer = setTimeout(() => latest.current.onGo(time), kDoubleClick);
      return null;
    },
    dblclick: () => () => {
      clearTimeout(timer);
      latest.current.onReset();
      return null;
    },
  };
}

/** The moment that is shown, as a line through all. */
function drawMoment(u: uPlot, { moment, span, look }: Props): void {
  if (moment === null || moment < span.from || moment > span.to) return;
  const x = Math.round(u.valToPos(moment, "x", true));
  u.ctx.save();
  u.ctx.strokeStyle = look.past;
  u.ctx.lineWidth = 2 * window.devicePixelRatio;
  u.ctx.beginPath();
  u.ctx.moveTo(x, u.bbox.top);
  u.ctx.lineTo(x, u.bbox.top + u.bbox.height);
  u.ctx.stroke();
  u.ctx.restore();
}

/** Of time, and of the strip's unit. */
function axesOf({ strip, look }: Props): uPlot.Axis[] {
  const axis = {
    stroke: look.text,
    font: look.font,
    grid: { stroke: look.grid, width: 1 },
    ticks: { stroke: look.grid, width: 1, size: 4 },
  };
  return [
    {
      ...axis,
      size: 24,
      gap: 2,
      space: 70,
      values: (_, ticks) => ticks.map((t) => `${Number(t.toPrecision(10))} s`),
    },
    {
      ...axis,
      size: 52,
      gap: 4,
      space: 26,
      label: strip.unit === "" ? undefined : strip.unit,
      labelSize: 16,
      labelGap: 0,
      labelFont: look.font,
    },
  ];
}

/** Tells where the pointer is, and which time was chosen by dragging. */
function hooksOf(latest: { current: Props }): uPlot.Hooks.Arrays {
  return {
    draw: [(u) => drawMoment(u, latest.current)],
    setCursor: [
      (u) => {
        const left = u.cursor.left ?? -1;
        latest.current.onCursor(left < 0 ? null : u.posToVal(left, "x"));
      },
    ],
    setSelect: [
      (u) => {
        if (u.select.width < 5) return;
        const from = u.posToVal(u.select.left, "x");
        const to = u.posToVal(u.select.left + u.select.width, "x");
        u.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
        latest.current.onZoom(from, to);
      },
    ],
  };
}
