// What a person sees of a page: what lies on something else, and how large the letters are.
import type { DesignerPage } from "./designer.ts";

export interface Looked {
  /** What lies on each other, in words. */
  over: string[];
  /** How many transitions are labelled. */
  labels: number;
  /** How large the labels' letters are on the screen [px]. */
  font: number;
  /** Labels that do not say everything. */
  short: number;
  nodes: number;
}

export function looked({ page }: DesignerPage): Promise<Looked> {
  return page.evaluate(() => {
    const boxOf = (element: Element) => {
      const { x, y, width, height } = element.getBoundingClientRect();
      return { left: x + 1, top: y + 1, right: x + width - 1, bottom: y + height - 1 };
    };
    type Box = ReturnType<typeof boxOf>;
    const isOver = (a: Box, b: Box) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    const isPassedBy = (box: Box, points: readonly DOMPoint[]) =>
      points.some(({ x, y }) => x > box.left && x < box.right && y > box.top && y < box.bottom);
    const labels = [...document.querySelectorAll<HTMLElement>(".transition-label")];
    const boxes = labels.map((label) => ({ id: label.dataset.transition ?? "", box: boxOf(label) }));
    const nodes = [...document.querySelectorAll<HTMLElement>(".react-flow__node:not(.react-flow__node-note)")].map(
      (node) => ({ id: node.dataset.id ?? "", box: boxOf(node) }),
    );
    const ways = [...document.querySelectorAll<HTMLElement>(".react-flow__edge")].map((edge) => {
      const path = edge.querySelector("path")!;
      const [length, matrix] = [path.getTotalLength(), path.getScreenCTM()!];
      const points = Array.from({ length: 81 }, (_, i) =>
        path.getPointAtLength((length * i) / 80).matrixTransform(matrix),
      );
      return { id: edge.dataset.id ?? "", points };
    });
    const over: string[] = [];
    nodes.forEach(({ id, box }, i) => {
      for (const other of nodes.slice(0, i)) if (isOver(box, other.box)) over.push(`${id} on ${other.id}`);
    });
    boxes.forEach(({ id, box }, i) => {
      for (const node of nodes) if (isOver(box, node.box)) over.push(`label ${id} on ${node.id}`);
      for (const other of boxes.slice(0, i)) if (isOver(box, other.box)) over.push(`label ${id} on label ${other.id}`);
      const passing = ways.filter((way) => way.id !== id && isPassedBy(box, way.points));
      for (const way of passing) over.push(`label ${id} on the way of ${way.id}`);
    });
    const fonts = labels.map(
      (label) =>
        Number.parseFloat(getComputedStyle(label).fontSize) *
        (label.getBoundingClientRect().height / label.offsetHeight),
    );
    const short = labels.filter((label) =>
      label.querySelector<HTMLElement>(".transition-lines")?.dataset.lines?.includes("…"),
    ).length;
    return { over, labels: labels.length, font: Math.min(...fonts), short, nodes: nodes.length };
  });
}
