// The map's colours on light and on dark ground.
import type { Rgb } from "../color.ts";

export interface Palette {
  readonly isDark: boolean;
  /** The mission area, and what lies outside of it. */
  readonly ground: string;
  readonly groundRgb: Rgb;
  readonly outside: string;
  readonly areaEdge: string;
  readonly grid: string;
  readonly gridStrong: string;
  /** Text and lines. */
  readonly ink: string;
  readonly softInk: string;
  /** Round text and small signs, so that they can be read on anything. */
  readonly halo: string;
  readonly assembly: string;
  readonly attack: string;
  readonly battle: string;
  readonly objective: string;
  readonly landing: string;
  readonly passage: string;
  readonly axis: string;
  readonly line: string;
  readonly boundary: string;
  readonly gap: string;
  readonly wall: string;
  readonly room: string;
  readonly roomEdge: string;
  readonly road: string;
  readonly roadEdge: string;
  readonly obstacle: string;
  readonly obstacleEdge: string;
  readonly militaryObstacle: string;
  readonly weather: string;
  readonly noFly: string;
  readonly noCommunication: string;
  readonly repelling: string;
  readonly selection: string;
  readonly hover: string;
  readonly goal: string;
  readonly station: string;
  readonly contact: string;
  readonly warning: string;
  readonly teleoperation: string;
  readonly reading: string;
  readonly idle: string;
  /** Of schemas, in the order in which they contribute. */
  readonly contributions: readonly string[];
}

export const kLight: Palette = {
  isDark: false,
  ground: "#fcfcfa",
  groundRgb: { r: 252, g: 252, b: 250 },
  outside: "#edeeec",
  areaEdge: "#b9bcb8",
  grid: "#ecedea",
  gridStrong: "#dcdedb",
  ink: "#1f2a33",
  softInk: "#5a6670",
  halo: "#fcfcfa",
  assembly: "#0b7468",
  attack: "#b4540a",
  battle: "#92600a",
  objective: "#b3261e",
  landing: "#a61e6b",
  passage: "#345063",
  axis: "#2456c4",
  line: "#5b3fa8",
  boundary: "#4b5660",
  gap: "#1f2a33",
  wall: "#2b333a",
  room: "#f1ebdd",
  roomEdge: "#b7a888",
  road: "#e6e4df",
  roadEdge: "#bdb9b0",
  obstacle: "#50575d",
  obstacleEdge: "#2b3136",
  militaryObstacle: "#2d6a35",
  weather: "#a86a00",
  noFly: "#c01f2f",
  noCommunication: "#7a3db8",
  repelling: "#e8590c",
  selection: "#0a66ff",
  hover: "#0a66ff",
  goal: "#0b7468",
  station: "#7a3db8",
  contact: "#d6001c",
  warning: "#c77700",
  teleoperation: "#0077b6",
  reading: "#0e8fae",
  idle: "#8a9299",
  contributions: ["#c2255c", "#1971c2", "#2b8a3e", "#9c36b5", "#a85a00", "#0c8599", "#5f3dc4", "#6b7000"],
};

export const kDark: Palette = {
  isDark: true,
  ground: "#14181c",
  groundRgb: { r: 20, g: 24, b: 28 },
  outside: "#0d1013",
  areaEdge: "#3d454d",
  grid: "#1e242a",
  gridStrong: "#2a323a",
  ink: "#e6ebef",
  softInk: "#9aa6b0",
  halo: "#14181c",
  assembly: "#4fd1bd",
  attack: "#f5a35c",
  battle: "#e3b94e",
  objective: "#ff8078",
  landing: "#f291c8",
  passage: "#a9c4d8",
  axis: "#7ba7ff",
  line: "#b7a0ff",
  boundary: "#a3adb6",
  gap: "#e6ebef",
  wall: "#cfd6dc",
  room: "#232019",
  roomEdge: "#6d624b",
  road: "#262b30",
  roadEdge: "#4a525a",
  obstacle: "#7f8a94",
  obstacleEdge: "#b4bec7",
  militaryObstacle: "#5fb56b",
  weather: "#f0b23e",
  noFly: "#ff6b78",
  noCommunication: "#c792ff",
  repelling: "#ff9350",
  selection: "#6ea8ff",
  hover: "#6ea8ff",
  goal: "#4fd1bd",
  station: "#c792ff",
  contact: "#ff5c6c",
  warning: "#ffb340",
  teleoperation: "#56c5f5",
  reading: "#46c7e0",
  idle: "#7c868f",
  contributions: ["#ff8fb1", "#74c0fc", "#8ce99a", "#e599f7", "#ffc078", "#66d9e8", "#b197fc", "#d8e06a"],
};

export function paletteOf(theme: "light" | "dark"): Palette {
  return theme === "dark" ? kDark : kLight;
}

/** `color` (#rrggbb) with an opacity of 0 .. 1. */
export function fade(color: string, opacity: number): string {
  return `${color}${Math.round(opacity * 255)
    .toString(16)
    .padStart(2, "0")}`;
}
