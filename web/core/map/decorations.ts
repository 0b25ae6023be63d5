// Scale bar and compass, in the map's lower left corner.
import { formatDistance, roundDown } from "../format.ts";
import { fade } from "./palette.ts";
import { crisp, fill, kSans, stroke } from "./strokes.ts";
import type { Pen } from "./tool.ts";

const kMargin = 14;
const kLongestBar = 140; // px

export function drawDecorations(pen: Pen): void {
  if (pen.camera.width < 260 || pen.camera.height < 160) return;
  const { context, camera, palette } = pen;
  const metres = roundDown(kLongestBar / camera.scale);
  const width = metres * camera.scale;
  context.beginPath();
  context.roundRect(kMargin - 4, camera.height - kMargin - 38, width + 64, 42, 8);
  fill(pen, fade(palette.ground, 0.92));
  stroke(pen, { color: palette.areaEdge, width: 1 });
  drawScaleBar(pen, metres, width);
  drawCompass(pen);
}

function drawScaleBar(pen: Pen, metres: number, width: number): void {
  const { context, camera, palette } = pen;
  const left = crisp(pen, kMargin + 44);
  const bottom = crisp(pen, camera.height - kMargin - 8);
  // Two halves, one dark: the eye finds the middle.
  context.fillStyle = palette.ink;
  context.fillRect(left, bottom - 5, width / 2, 5);
  context.beginPath();
  context.rect(left, bottom - 5, width, 5);
  stroke(pen, { color: palette.ink, width: 1 });
  context.fillStyle = palette.ink;
  context.font = `600 11px ${kSans}`;
  context.textBaseline = "alphabetic";
  context.textAlign = "left";
  context.fillText("0", left - 1, bottom - 10);
  context.textAlign = "right";
  context.fillText(barLabel(metres), left + width + 2, bottom - 10);
}

/** Round numbers without decimals that say nothing: `50 m`, `0.2 m`, `2 km`. */
export function barLabel(metres: number): string {
  if (metres >= 1000) return `${metres / 1000} km`;
  if (metres >= 0.1) return `${Number(metres.toPrecision(3))} m`;
  return formatDistance(metres);
}

function drawCompass(pen: Pen): void {
  const { context, camera, palette } = pen;
  const x = kMargin + 16;
  const y = camera.height - kMargin - 17;
  const half = (side: number, isNorth: boolean): void => {
    context.beginPath();
    context.moveTo(x, y + (isNorth ? -9 : 13));
    context.lineTo(x + side * 4.5, y + 2);
    context.lineTo(x, y + 2);
    context.closePath();
    fill(pen, isNorth ? palette.contact : palette.softInk);
  };
  for (const side of [-1, 1]) {
    half(side, true);
    half(side, false);
  }
  context.fillStyle = palette.ink;
  context.font = `700 9px ${kSans}`;
  context.textAlign = "center";
  context.textBaseline = "alphabetic";
  context.fillText("N", x, y - 9.5);
}
