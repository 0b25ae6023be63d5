// The outlines of nodes as paths, of any size. Operators of different kinds have different ones.
import type { Outline } from "./form.ts";

const kCorner = 9;

/** For `d` of an SVG path, from (0, 0) to (width, height). */
export function outlinePath(outline: Outline, width: number, height: number): string {
  switch (outline) {
    case "box":
      return rounded(width, height, kCorner, kCorner);
    case "sum":
      return rounded(width, height, kCorner, Math.min(height / 2, 30));
    case "pill":
      return rounded(width, height, Math.min(height / 2, 16), Math.min(height / 2, 16));
    case "arrow": {
      const tip = Math.min(22, height / 2);
      return `M${kCorner} 0H${width - tip}L${width} ${height / 2}L${width - tip} ${height}H${kCorner}${leftSide(height)}`;
    }
    case "octagon": {
      const cut = Math.min(14, height / 2);
      return `M${cut} 0H${width - cut}L${width} ${cut}V${height - cut}L${width - cut} ${height}H${cut}L0 ${height - cut}V${cut}Z`;
    }
    case "hexagon": {
      const cut = Math.min(14, height / 2);
      return `M${kCorner} 0H${width - cut}L${width} ${cut}V${height - cut}L${width - cut} ${height}H${kCorner}${leftSide(height)}`;
    }
    case "tag": {
      const tip = Math.min(14, height / 2);
      return `M6 0H${width - tip}L${width} ${height / 2}L${width - tip} ${height}H6Q0 ${height} 0 ${height - 6}V6Q0 0 6 0Z`;
    }
    case "sink": {
      const tip = Math.min(14, height / 2);
      return `M0 0H${width - kCorner}Q${width} 0 ${width} ${kCorner}V${height - kCorner}Q${width} ${height} ${width - kCorner} ${height}H0L${tip} ${height / 2}Z`;
    }
  }
}

function leftSide(height: number): string {
  return `Q0 ${height} 0 ${height - kCorner}V${kCorner}Q0 0 ${kCorner} 0Z`;
}

/** With other radii on the left than on the right. */
function rounded(width: number, height: number, left: number, right: number): string {
  const l = Math.min(left, height / 2);
  const r = Math.min(right, height / 2);
  return (
    `M${l} 0H${width - r}Q${width} 0 ${width} ${r}V${height - r}Q${width} ${height} ${width - r} ${height}` +
    `H${l}Q0 ${height} 0 ${height - l}V${l}Q0 0 ${l} 0Z`
  );
}
