// How wide a text is, near enough to leave room for it. Where there is no page to ask, by the width of letters.

let context: CanvasRenderingContext2D | null | undefined;
const known = new Map<string, number>();

/** [px] in the page's font. */
export function widthOf(text: string, size: number, isBold = false): number {
  if (text === "") return 0;
  const key = `${size}${isBold ? "b" : ""}${text}`;
  const before = known.get(key);
  if (before !== undefined) return before;
  const width = measured(text, size, isBold) ?? guessed(text, size) * (isBold ? 1.06 : 1);
  if (known.size > 20_000) known.clear();
  known.set(key, width);
  return width;
}

function measured(text: string, size: number, isBold: boolean): number | undefined {
  if (context === undefined) {
    context = typeof document === "undefined" ? null : (document.createElement("canvas").getContext?.("2d") ?? null);
  }
  if (!context) return undefined;
  context.font = `${isBold ? 650 : 400} ${size}px ${kFont}`;
  return context.measureText(text).width;
}

/** As in ui/styles/tokens.css. */
export const kFont = `system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "Liberation Sans", sans-serif`;

function guessed(text: string, size: number): number {
  let width = 0;
  for (const letter of text) {
    if (/[ilj.,:;'|!()[\]]/.test(letter)) width += 0.3;
    else if (/[mwMW@]/.test(letter)) width += 0.85;
    else if (/[A-Z_]/.test(letter)) width += 0.65;
    else width += 0.54;
  }
  return width * size;
}
