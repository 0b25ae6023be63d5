// Plots as files: a table (CSV) and a drawing (SVG). Text in, text out.

import type { AlignedTable } from "./samples.ts";
import { niceTicks } from "./ticks.ts";

export interface ExportSeries {
  readonly label: string;
  readonly unit: string;
  readonly color: string;
  readonly dash: readonly number[];
}

/** RFC 4180: comma, quotes doubled, line ends CR LF. Where there is no sample or no number the field is empty. */
export function toCsv(table: AlignedTable, series: readonly ExportSeries[]): string {
  const head = ["time [s]", ...series.map((s) => (s.unit === "" ? s.label : `${s.label} [${s.unit}]`))];
  const lines = [head.map(csvField).join(",")];
  table.times.forEach((time, row) => {
    const cells = table.columns.map((column) => {
      const value = column[row];
      return value === null || value === undefined ? "" : String(value);
    });
    // Times are whole cycles: what binary fractions add to them is noise.
    lines.push([String(Number(time.toPrecision(12))), ...cells].join(","));
  });
  return `${lines.join("\r\n")}\r\n`;
}

function csvField(text: string): string {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** One panel of the drawing: lines that share a vertical axis. */
export interface ExportStrip {
  readonly title: string;
  readonly unit: string;
  readonly series: readonly ExportSeries[];
  readonly table: AlignedTable;
}

export interface DrawingStyle {
  readonly width: number;
  readonly stripHeight: number;
  readonly background: string;
  readonly text: string;
  readonly grid: string;
}

const kLeft = 72;
const kRight = 16;
const kTop = 44;
const kBottom = 40;

/** A drawing of all strips, one below the other, over the same span of time. Needs nothing but itself to be shown. */
export function toSvg(strips: readonly ExportStrip[], span: { from: number; to: number }, style: DrawingStyle): string {
  const height = strips.length * style.stripHeight;
  const parts = strips.map((strip, i) => stripSvg(strip, span, style, i * style.stripHeight));
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${style.width}" height="${height}" viewBox="0 0 ${style.width} ${height}" font-family="system-ui, sans-serif" font-size="12">`,
    `<rect width="100%" height="100%" fill="${style.background}"/>`,
    ...parts,
    "</svg>",
    "",
  ].join("\n");
}

function stripSvg(strip: ExportStrip, span: { from: number; to: number }, style: DrawingStyle, y0: number): string {
  const right = style.width - kRight;
  const top = y0 + kTop;
  const bottom = y0 + style.stripHeight - kBottom;
  const values = valueSpan(strip.table, span);
  const duration = Math.max(span.to - span.from, 1e-9);
  const x = (t: number) => kLeft + ((t - span.from) / duration) * (right - kLeft);
  const y = (v: number) => bottom - ((v - values.from) / (values.to - values.from)) * (bottom - top);
  const out = [`<g fill="${style.text}">`];
  const unit = strip.unit === "" ? "" : ` [${strip.unit}]`;
  out.push(`<text x="${kLeft}" y="${y0 + 16}" font-weight="600">${escapeXml(strip.title + unit)}</text>`);
  out.push(legendSvg(strip.series, y0 + 34));
  for (const t of niceTicks(span.from, span.to, 8)) {
    out.push(line(x(t), top, x(t), bottom, style.grid));
    out.push(`<text x="${px(x(t))}" y="${bottom + 16}" text-anchor="middle">${t}</text>`);
  }
  for (const v of niceTicks(values.from, values.to, 5)) {
    out.push(line(kLeft, y(v), right, y(v), style.grid));
    out.push(`<text x="${kLeft - 8}" y="${px(y(v) + 4)}" text-anchor="end">${v}</text>`);
  }
  out.push(`<text x="${(kLeft + right) / 2}" y="${bottom + 32}" text-anchor="middle">time [s]</text></g>`);
  strip.series.forEach((s, i) => {
    const d = pathOf(strip.table, i, span, x, y);
    if (d === "") return;
    const dash = s.dash.length > 0 ? ` stroke-dasharray="${s.dash.join(" ")}"` : "";
    out.push(`<path d="${d}" fill="none" stroke="${s.color}" stroke-width="1.75" stroke-linejoin="round"${dash}/>`);
  });
  return out.join("\n");
}

function legendSvg(series: readonly ExportSeries[], y: number): string {
  let x = kLeft;
  return series
    .map((s) => {
      const dash = s.dash.length > 0 ? ` stroke-dasharray="${s.dash.join(" ")}"` : "";
      const entry =
        `<line x1="${x}" y1="${y - 4}" x2="${x + 18}" y2="${y - 4}" stroke="${s.color}" stroke-width="3"${dash}/>` +
        `<text x="${x + 24}" y="${y}">${escapeXml(s.label)}</text>`;
      x += 40 + s.label.length * 7;
      return entry;
    })
    .join("\n");
}

function pathOf(
  table: AlignedTable,
  column: number,
  span: { from: number; to: number },
  x: (t: number) => number,
  y: (v: number) => number,
): string {
  const values = table.columns[column] ?? [];
  let pen = "M";
  const out: string[] = [];
  table.times.forEach((t, i) => {
    const v = values[i];
    if (v === undefined || t < span.from || t > span.to) return;
    if (v === null) {
      pen = "M";
      return;
    }
    out.push(`${pen}${px(x(t))} ${px(y(v))}`);
    pen = "L";
  });
  return out.join("");
}

/** Of all values inside the span, with some room; never empty. */
export function valueSpan(table: AlignedTable, span: { from: number; to: number }): { from: number; to: number } {
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  table.times.forEach((t, i) => {
    if (t < span.from || t > span.to) return;
    for (const column of table.columns) {
      const v = column[i];
      if (v === null || v === undefined) continue;
      if (v < low) low = v;
      if (v > high) high = v;
    }
  });
  if (low > high) return { from: 0, to: 1 };
  const room = high > low ? (high - low) * 0.05 : Math.max(Math.abs(low) * 0.1, 0.5);
  return { from: low - room, to: high + room };
}

function line(x1: number, y1: number, x2: number, y2: number, color: string): string {
  return `<line x1="${px(x1)}" y1="${px(y1)}" x2="${px(x2)}" y2="${px(y2)}" stroke="${color}"/>`;
}

function px(value: number): string {
  return String(Math.round(value * 100) / 100);
}

function escapeXml(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
}
