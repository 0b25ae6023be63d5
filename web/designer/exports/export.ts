// The drawing that is shown, as a file or on paper.

import { offer } from "../../ui/files/offer.ts";
import type { Designer } from "../session/designer.ts";
import { titleOf } from "../session/titles.ts";
import { placesOf, wholePlaces } from "../sight/use_places.ts";
import { drawingAsSvg } from "./svg.ts";

export async function exportDrawing(designer: Designer, what: "svg" | "png" | "print"): Promise<void> {
  const { drawing } = designer;
  if (!drawing) {
    designer.tell("There is nothing to export yet.", "hold");
    return;
  }
  const places = await wholePlaces(drawing); // a page that was opened just now may still be laid out
  const page = drawing.page?.path ?? "";
  const name = (page || titleOf(drawing.page?.document ?? "drawing").replace(/\.cdl$/, "")).replaceAll(
    /[^\w.-]+/g,
    "_",
  );
  const { svg, width, height } = drawingAsSvg(drawing, places, page || name);
  if (what === "print") return print(svg);
  if (what === "svg") return offer(`${name}.svg`, new Blob([svg], { type: "image/svg+xml" }));
  const png = await asPng(svg, width, height);
  if (png) offer(`${name}.png`, png);
  else designer.tell("The browser could not make a picture of it.");
}

/** At twice the size, but no larger than a browser can draw. */
async function asPng(svg: string, width: number, height: number): Promise<Blob | null> {
  const scale = Math.min(2, 8000 / Math.max(width, height));
  const image = new Image();
  const url = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
  await new Promise((resolve, reject) => {
    image.onload = resolve;
    image.onerror = reject;
    image.src = url;
  }).catch(() => {});
  const canvas = document.createElement("canvas");
  canvas.width = Math.max(1, Math.round(width * scale));
  canvas.height = Math.max(1, Math.round(height * scale));
  const context = canvas.getContext("2d");
  if (!context || !image.complete) return null;
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}

/**
 * The browser's own print command prints the drawing as well, as far as everything on it has a place already.
 * @return ends it
 */
export function followPrinting(designer: Designer): () => void {
  const prepare = () => {
    const { drawing } = designer;
    const places = drawing && placesOf(drawing);
    if (!drawing || !places || document.querySelector(".print-sheet")) return;
    addSheet(drawingAsSvg(drawing, places, drawing.page?.path ?? "").svg);
  };
  window.addEventListener("beforeprint", prepare);
  return () => window.removeEventListener("beforeprint", prepare);
}

function print(svg: string): void {
  addSheet(svg);
  window.print();
}

/** Only the drawing, in the middle of the paper, is in the printed document. */
function addSheet(svg: string): void {
  const sheet = document.createElement("div");
  sheet.className = "print-sheet";
  sheet.innerHTML = svg; // our own text: everything in it was escaped
  document.body.append(sheet);
  window.addEventListener("afterprint", () => sheet.remove(), { once: true });
}
