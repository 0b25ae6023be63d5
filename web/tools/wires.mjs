// Wires that can be seen, counted in the page itself: for tests and benchmarks of large drawings.

/**
 * Wires of which something lies in the canvas's window, whether each is drawn by itself or many in one path.
 *
 * `loose`: ends of wires well in sight that lie at no node's edge; `bare`: inputs in sight which have a wire, and at which none
 * ends (far away, where inputs are not drawn, none is counted).
 * @param {import("playwright-core").Page} page
 */
export function wiresInSight(page) {
  // biome-ignore lint/complexity/noExcessiveCognitiveComplexity: runs in the page, where it has to bring everything along
  return page.evaluate(() => {
    const canvas = document.querySelector(".canvas").getBoundingClientRect();
    const margin = 16; // a node that ends at the rim is not in the page
    const isInside = (x, y) =>
      x >= canvas.left + margin &&
      x <= canvas.right - margin &&
      y >= canvas.top + margin &&
      y <= canvas.bottom - margin;
    const wires = [];
    for (const path of document.querySelectorAll(".canvas path.wire")) {
      const { stroke, strokeWidth, opacity, visibility } = getComputedStyle(path);
      const isDrawn = stroke !== "none" && Number.parseFloat(strokeWidth) > 0 && Number(opacity) > 0;
      const matrix = path.getScreenCTM();
      if (!isDrawn || visibility !== "visible" || !matrix) continue;
      for (const part of (path.getAttribute("d") ?? "").split("M").slice(1)) {
        const numbers = part.match(/-?\d+(\.\d+)?/g).map(Number);
        const at = (i) => new DOMPoint(numbers.at(i), numbers.at(i + 1)).matrixTransform(matrix);
        wires.push({ from: at(0), to: at(-2) });
      }
    }
    const isSeen = ({ from, to }) =>
      Math.max(from.x, to.x) >= canvas.left &&
      Math.min(from.x, to.x) <= canvas.right &&
      Math.max(from.y, to.y) >= canvas.top &&
      Math.min(from.y, to.y) <= canvas.bottom;
    const zoom = document.querySelector(".canvas .react-flow__viewport").getBoundingClientRect().width / canvas.width;
    const boxes = [...document.querySelectorAll(".canvas .react-flow__node")].map((node) =>
      node.getBoundingClientRect(),
    );
    const slack = 2 + 8 * zoom;
    const isAtNode = ({ x, y }, edge) =>
      boxes.some((box) => Math.abs(x - box[edge]) <= slack && y >= box.top - slack && y <= box.bottom + slack);
    let loose = 0;
    for (const { from, to } of wires) {
      if (isInside(from.x, from.y) && !isAtNode(from, "right")) ++loose;
      if (isInside(to.x, to.y) && !isAtNode(to, "left")) ++loose;
    }
    let bare = 0;
    for (const port of document.querySelectorAll(".canvas .port.wired")) {
      const box = port.getBoundingClientRect();
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      if (isInside(x, y) && !wires.some(({ to }) => Math.hypot(to.x - x, to.y - y) < slack)) ++bare;
    }
    const nodes = boxes.filter(
      (box) =>
        box.right >= canvas.left && box.left <= canvas.right && box.bottom >= canvas.top && box.top <= canvas.bottom,
    ).length;
    return { wires: wires.filter(isSeen).length, loose, bare, nodes };
  });
}
