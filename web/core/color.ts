// Colours of robots and objects on light and dark ground.

export interface Rgb {
  readonly r: number; // 0..255
  readonly g: number;
  readonly b: number;
}

const kNames: Readonly<Record<string, string>> = {
  black: "#000000",
  white: "#ffffff",
  red: "#ff0000",
  green: "#008000",
  blue: "#0000ff",
  yellow: "#ffff00",
  orange: "#ffa500",
  purple: "#a020f0",
  violet: "#ee82ee",
  brown: "#a52a2a",
  pink: "#ffc0cb",
  gray: "#bebebe",
  grey: "#bebebe",
  cyan: "#00ffff",
  magenta: "#ff00ff",
  maroon: "#b03060",
  navy: "#000080",
  gold: "#ffd700",
  tan: "#d2b48c",
  khaki: "#f0e68c",
  turquoise: "#40e0d0",
  salmon: "#fa8072",
  coral: "#ff7f50",
  orchid: "#da70d6",
  plum: "#dda0dd",
  sienna: "#a0522d",
  chocolate: "#d2691e",
  beige: "#f5f5dc",
  wheat: "#f5deb3",
  firebrick: "#b22222",
  forestgreen: "#228b22",
  darkgreen: "#006400",
  lightgreen: "#90ee90",
  limegreen: "#32cd32",
  seagreen: "#2e8b57",
  darkblue: "#00008b",
  lightblue: "#add8e6",
  skyblue: "#87ceeb",
  steelblue: "#4682b4",
  royalblue: "#4169e1",
  darkred: "#8b0000",
  darkorange: "#ff8c00",
  darkgray: "#a9a9a9",
  darkgrey: "#a9a9a9",
  lightgray: "#d3d3d3",
  lightgrey: "#d3d3d3",
  dimgray: "#696969",
  slategray: "#708090",
  hotpink: "#ff69b4",
  deeppink: "#ff1493",
  olivedrab: "#6b8e23",
  aquamarine: "#7fffd4",
  lavender: "#e6e6fa",
  tomato: "#ff6347",
  goldenrod: "#daa520",
};

/** `#rgb`, `#rrggbb` or an X11 name (spaces and case don't matter); null where it is none of them. */
export function parseColor(text: string): Rgb | null {
  const plain = text.replaceAll(/\s/g, "").toLowerCase();
  const numbered = /^([a-z]+)[1-4]$/.exec(plain); // X11's shades: `red3`
  const hex = kNames[plain] ?? kNames[numbered?.[1] ?? ""] ?? plain;
  const short = /^#([0-9a-f])([0-9a-f])([0-9a-f])$/.exec(hex);
  const long = short ? `#${short[1]}${short[1]}${short[2]}${short[2]}${short[3]}${short[3]}` : hex;
  if (!/^#[0-9a-f]{6}$/.test(long)) return null;
  const value = Number.parseInt(long.slice(1), 16);
  return { r: value >> 16, g: (value >> 8) & 255, b: value & 255 };
}

export function toHex({ r, g, b }: Rgb): string {
  return `#${[r, g, b].map((part) => Math.round(part).toString(16).padStart(2, "0")).join("")}`;
}

/** Relative luminance, 0 .. 1. @source WCAG 2.2 */
export function luminance({ r, g, b }: Rgb): number {
  const linear = (part: number): number => {
    const share = part / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  };
  return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
}

/** 1 .. 21. @source WCAG 2.2 */
export function contrast(a: Rgb, b: Rgb): number {
  const [high, low] = [luminance(a), luminance(b)].sort((x, y) => y - x);
  return (high! + 0.05) / (low! + 0.05);
}

export function mix(a: Rgb, b: Rgb, share: number): Rgb {
  const part = (x: number, y: number): number => x + (y - x) * share;
  return { r: part(a.r, b.r), g: part(a.g, b.g), b: part(a.b, b.b) };
}

/** The same colour, lighter or darker by no more than is needed to stand out from the ground. */
export function readableOn(color: Rgb, ground: Rgb, wanted = 3): Rgb {
  const end = luminance(ground) > 0.4 ? { r: 0, g: 0, b: 0 } : { r: 255, g: 255, b: 255 };
  for (let share = 0; share < 1; share += 0.05) {
    const mixed = mix(color, end, share);
    if (contrast(mixed, ground) >= wanted) return mixed;
  }
  return end;
}
