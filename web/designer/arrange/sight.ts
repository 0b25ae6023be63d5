// How large a layout is seen.
import type { Spot } from "./elk.ts";
import type { LayoutGraph } from "./graph.ts";

/** What a page is mostly looked at in [px]. */
export const kUsualView = { width: 960, height: 800 };

/** The zoom at which it is seen as a whole. */
export function zoomOf(spots: readonly Spot[], { nodes }: LayoutGraph): number {
  const sizes = new Map(nodes.map((node) => [node.id, node]));
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { id, x, y } of spots) {
    const { width, height } = sizes.get(id)!;
    [left, top] = [Math.min(left, x), Math.min(top, y)];
    [right, bottom] = [Math.max(right, x + width), Math.max(bottom, y + height)];
  }
  return Math.min(1, kUsualView.width / Math.max(1, right - left), kUsualView.height / Math.max(1, bottom - top));
}
