// What is shown, saved as a picture, a drawing or a table.
import type uPlot from "uplot";
import { offer } from "../../ui/files/offer.ts";
import { type ExportSeries, toCsv, toSvg } from "./export.ts";
import type { Recorder } from "./recorder.ts";
import { alignSamples, type SampleBuffer } from "./samples.ts";
import { seriesLabel } from "./series.ts";
import type { Strip, StripLine } from "./strips.ts";

export interface ShownPlots {
  readonly strips: readonly Strip[];
  readonly recorder: Recorder;
  readonly span: { from: number; to: number };
  readonly colors: readonly string[];
  readonly plots: ReadonlyMap<string, uPlot>;
}

/** All samples of all lines inside the span, one table. */
export function saveCsv({ strips, recorder, span }: ShownPlots): void {
  const lines = strips.flatMap((strip) => strip.lines.map((line) => ({ line, unit: strip.unit })));
  const table = alignSamples(lines.map(({ line }) => samplesIn(recorder.recordingOf(line.key)?.buffer, span)));
  const series = lines.map(({ line, unit }) => ({ label: seriesLabel(line.spec), unit, color: "", dash: [] }));
  offer("plots.csv", new Blob([toCsv(table, series)], { type: "text/csv" }));
}

export function saveSvg({ strips, recorder, span, colors }: ShownPlots): void {
  const style = getComputedStyle(document.documentElement);
  const drawn = strips.map((strip) => ({
    title: strip.title,
    unit: strip.unit,
    series: strip.lines.map((line) => exportSeries(line, strip.unit, colors)),
    table: alignSamples(strip.lines.map((line) => samplesIn(recorder.recordingOf(line.key)?.buffer, span))),
  }));
  const text = toSvg(drawn, span, {
    width: 960,
    stripHeight: 260,
    background: style.getPropertyValue("--surface").trim() || "#ffffff",
    text: style.getPropertyValue("--text").trim() || "#000000",
    grid: style.getPropertyValue("--line").trim() || "#dddddd",
  });
  offer("plots.svg", new Blob([text], { type: "image/svg+xml" }));
}

/** As on the screen: title, legend and lines of each strip. */
export async function savePng({ strips, colors, plots }: ShownPlots): Promise<void> {
  const shown = strips.flatMap((strip) => {
    const canvas = plots.get(strip.key)?.ctx.canvas;
    return canvas ? [{ strip, canvas }] : [];
  });
  if (shown.length === 0) return;
  const style = getComputedStyle(document.documentElement);
  const density = devicePixelRatio || 1;
  const head = Math.round(40 * density);
  const picture = document.createElement("canvas");
  picture.width = Math.max(...shown.map(({ canvas }) => canvas.width));
  picture.height = shown.reduce((sum, { canvas }) => sum + canvas.height + head, 0);
  const pen = picture.getContext("2d");
  if (!pen) return;
  pen.fillStyle = style.getPropertyValue("--surface").trim() || "#ffffff";
  pen.fillRect(0, 0, picture.width, picture.height);
  let y = 0;
  for (const { strip, canvas } of shown) {
    drawHead(pen, strip, colors, y, density, style);
    pen.drawImage(canvas, 0, y + head);
    y += canvas.height + head;
  }
  const blob = await new Promise<Blob | null>((done) => picture.toBlob(done, "image/png"));
  if (blob) offer("plots.png", blob);
}

function drawHead(
  pen: CanvasRenderingContext2D,
  strip: Strip,
  colors: readonly string[],
  top: number,
  density: number,
  style: CSSStyleDeclaration,
): void {
  pen.save();
  pen.translate(0, top);
  pen.scale(density, density);
  const family = style.getPropertyValue("--font").trim() || "sans-serif";
  pen.fillStyle = style.getPropertyValue("--text").trim() || "#000000";
  pen.font = `600 13px ${family}`;
  pen.fillText(strip.unit === "" ? strip.title : `${strip.title} [${strip.unit}]`, 10, 16);
  pen.font = `12px ${family}`;
  let x = 10;
  for (const line of strip.lines) {
    pen.strokeStyle = colors[line.color] ?? "gray";
    pen.lineWidth = 3;
    pen.setLineDash([...line.dash]);
    pen.beginPath();
    pen.moveTo(x, 30);
    pen.lineTo(x + 20, 30);
    pen.stroke();
    pen.fillText(line.label, x + 26, 34);
    x += 44 + pen.measureText(line.label).width;
  }
  pen.restore();
}

function exportSeries(line: StripLine, unit: string, colors: readonly string[]): ExportSeries {
  return { label: line.label, unit, color: colors[line.color] ?? "gray", dash: line.dash };
}

function samplesIn(buffer: SampleBuffer | undefined, span: { from: number; to: number }) {
  const near = buffer?.within(span.from, span.to);
  const none = { times: new Float64Array(0), values: new Float64Array(0) };
  if (!near) return none;
  const inside = [...near.times.keys()].filter((i) => {
    const t = near.times[i] as number;
    return t >= span.from && t <= span.to;
  });
  return {
    times: Float64Array.from(inside, (i) => near.times[i] as number),
    values: Float64Array.from(inside, (i) => near.values[i] as number),
  };
}
