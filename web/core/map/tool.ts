// What the pointer does on the map. One tool is active at a time; panning (right or middle button, space, two fingers)
// and zooming (wheel, pinch) belong to the map itself and work under every tool.
import type { Camera } from "../camera.ts";
import type { Point } from "../geometry.ts";
import type { MapItem } from "../selection.ts";
import type { MapView } from "./map_view.ts";
import type { Palette } from "./palette.ts";

/** What is under the pointer. */
export type MapPick = { readonly kind: "robot"; readonly id: number } | MapItem;

export interface MapPointer {
  /** [m] */
  readonly world: Point;
  /** [CSS pixels from the map's upper left corner] */
  readonly screen: Point;
  readonly shift: boolean;
  /** Control, or Command. */
  readonly ctrl: boolean;
  readonly alt: boolean;
  readonly isTouch: boolean;
  /** Everything within reach of the pointer, nearest and uppermost first. */
  picks(): readonly MapPick[];
}

/** For drawing in CSS pixels, the map's upper left corner at (0, 0): points go through `camera.toScreen`. */
export interface Pen {
  readonly context: CanvasRenderingContext2D;
  readonly camera: Camera;
  readonly palette: Palette;
  readonly military: boolean;
  /** Device pixels per CSS pixel. */
  readonly density: number;
}

/** Only what a tool needs has to be there. Call `map.redraw()` when what `draw` draws has changed. */
export interface MapTool {
  readonly name: string;
  /** CSS cursor; "default" without. */
  readonly cursor?: string;
  start?(map: MapView): void;
  /** Another tool takes over, or the map goes away. */
  end?(): void;
  /** The main button (or a finger) went down. What follows until `up` or `cancel` is this tool's drag. */
  down?(pointer: MapPointer): void;
  /** With `isDragging` false the pointer only hovers. */
  move?(pointer: MapPointer, isDragging: boolean): void;
  up?(pointer: MapPointer): void;
  doubleClick?(pointer: MapPointer): void;
  leave?(): void;
  /** The drag was broken off (Escape, a second finger, a lost pointer): as if `down` had not been. */
  cancel?(): void;
  /** True: the key was for the tool. Comes before the map's own keys. */
  key?(event: KeyboardEvent): boolean;
  /** Over everything else, with each drawing of the map. */
  draw?(pen: Pen): void;
  /** False: `draw` would draw nothing now, and the map need not ask. */
  isDrawing?(): boolean;
}
