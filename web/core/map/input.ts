// Pointer, wheel and keys of the map, handed on to the active tool. Panning and zooming stay here.
import type { Point } from "../geometry.ts";
import type { MapView } from "./map_view.ts";
import type { MapPointer } from "./tool.ts";

const kMouseReach = 4; // px
const kTouchReach = 14;
const kKeyPan = 80; // px a key press
export const kZoomStep = Math.SQRT2; // as one click did in 1995

/** The least that has to be hit, before a click becomes a drag [px]. */
export const kDragStart = 4;

export class MapInput {
  private readonly fingers = new Map<number, Point>();
  private dragging: number | null = null; // the pointer whose drag is the tool's
  private panning: number | null = null;
  private last: Point = { x: 0, y: 0 };
  private isSpaceDown = false;
  private readonly abort = new AbortController();

  constructor(private readonly map: MapView) {
    const { host } = map;
    if (!host.hasAttribute("tabindex")) host.tabIndex = 0;
    const on = <Name extends keyof HTMLElementEventMap>(
      name: Name,
      act: (event: HTMLElementEventMap[Name]) => void,
      passive = true,
    ): void => host.addEventListener(name, act, { signal: this.abort.signal, passive });
    on("pointerdown", (event) => this.down(event));
    on("pointermove", (event) => this.move(event));
    on("pointerup", (event) => this.up(event));
    on("pointercancel", (event) => this.lose(event));
    on("pointerleave", () => this.leave());
    on("dblclick", (event) => this.map.tool.doubleClick?.(this.pointer(event)));
    on("wheel", (event) => this.wheel(event), false);
    on("contextmenu", (event) => event.preventDefault(), false);
    on("keydown", (event) => this.key(event), false);
    on("keyup", (event) => this.keyUp(event));
    on("blur", () => {
      this.isSpaceDown = false;
      this.showCursor();
    });
    this.showCursor();
  }

  dispose(): void {
    this.abort.abort();
  }

  /** Ends a drag without effect. */
  breakOff(): void {
    if (this.dragging === null) return;
    this.dragging = null;
    this.map.tool.cancel?.();
  }

  showCursor(): void {
    const pan = this.panning !== null ? "grabbing" : this.isSpaceDown ? "grab" : null;
    this.map.host.style.cursor = pan ?? this.map.tool.cursor ?? "default";
  }

  private down(event: PointerEvent): void {
    if (event.target !== this.map.host) return; // a control that lies on the map
    const screen = this.place(event);
    this.last = screen;
    this.map.host.focus({ preventScroll: true });
    this.capture(event.pointerId);
    if (event.pointerType === "touch") {
      this.fingers.set(event.pointerId, screen);
      if (this.fingers.size > 1) {
        this.breakOff();
        return;
      }
    }
    if (event.button === 1 || event.button === 2 || (event.button === 0 && this.isSpaceDown)) {
      this.panning = event.pointerId;
      event.preventDefault();
    } else if (event.button === 0 && this.dragging === null) {
      this.dragging = event.pointerId;
      this.map.tool.down?.(this.pointer(event));
    }
    this.showCursor();
  }

  private move(event: PointerEvent): void {
    const screen = this.place(event);
    if (this.fingers.size > 1 && this.fingers.has(event.pointerId)) {
      this.pinch(event.pointerId, screen);
      return;
    }
    if (this.panning === event.pointerId) {
      this.map.framing.pan(screen.x - this.last.x, screen.y - this.last.y);
      this.last = screen;
      return;
    }
    if (this.fingers.has(event.pointerId)) this.fingers.set(event.pointerId, screen);
    if (event.target !== this.map.host && this.dragging !== event.pointerId) return;
    this.map.tool.move?.(this.pointer(event), this.dragging === event.pointerId);
  }

  private up(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    if (this.panning === event.pointerId) this.panning = null;
    if (this.dragging === event.pointerId) {
      this.dragging = null;
      this.map.tool.up?.(this.pointer(event));
    }
    this.showCursor();
  }

  private lose(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    if (this.panning === event.pointerId) this.panning = null;
    if (this.dragging === event.pointerId) this.breakOff();
    this.showCursor();
  }

  private leave(): void {
    if (this.dragging === null) this.map.tool.leave?.();
  }

  /** Two fingers: what lies under each stays under it. */
  private pinch(moved: number, to: Point): void {
    const [other] = [...this.fingers].filter(([id]) => id !== moved);
    const from = this.fingers.get(moved)!;
    this.fingers.set(moved, to);
    if (!other) return;
    const before = Math.hypot(from.x - other[1].x, from.y - other[1].y);
    const after = Math.hypot(to.x - other[1].x, to.y - other[1].y);
    this.map.framing.pan((to.x - from.x) / 2, (to.y - from.y) / 2);
    if (before > 10 && after > 10) {
      this.map.framing.zoomAbout({ x: (to.x + other[1].x) / 2, y: (to.y + other[1].y) / 2 }, after / before);
    }
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 33 : event.deltaMode ? 400 : 1;
    // Touch pads tell a pinch as a wheel with control, in far smaller steps.
    const speed = event.ctrlKey ? 0.012 : 0.0035;
    const turn = Math.max(-200, Math.min(200, event.deltaY * lines));
    this.map.framing.zoomAbout(this.place(event), Math.exp(-turn * speed));
  }

  private key(event: KeyboardEvent): void {
    if (event.target !== this.map.host) return;
    if (this.map.tool.key?.(event) || this.ownKey(event)) {
      event.preventDefault();
      event.stopPropagation();
    }
  }

  private ownKey(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    switch (event.key) {
      case "ArrowLeft":
        this.map.framing.pan(kKeyPan, 0);
        return true;
      case "ArrowRight":
        this.map.framing.pan(-kKeyPan, 0);
        return true;
      case "ArrowUp":
        this.map.framing.pan(0, kKeyPan);
        return true;
      case "ArrowDown":
        this.map.framing.pan(0, -kKeyPan);
        return true;
      case "+":
      case "=":
        this.map.framing.zoom(kZoomStep);
        return true;
      case "-":
      case "_":
        this.map.framing.zoom(1 / kZoomStep);
        return true;
      case "f":
      case "F":
        if (event.shiftKey) this.map.framing.fitSelection();
        else this.map.framing.fit();
        return true;
      case " ":
        this.isSpaceDown = true;
        this.showCursor();
        return true;
      case "Escape":
        return this.escape();
    }
    return false;
  }

  /** From the inside out: the drag, the tool, what is selected. Else it is somebody else's key. */
  private escape(): boolean {
    if (this.dragging !== null) this.breakOff();
    else if (this.map.tool.name !== "select") this.map.useTool(null);
    else return false;
    return true;
  }

  private keyUp(event: KeyboardEvent): void {
    if (event.key !== " ") return;
    this.isSpaceDown = false;
    this.showCursor();
  }

  private pointer(event: MouseEvent): MapPointer {
    const screen = this.place(event);
    const { map } = this;
    const isTouch = event instanceof PointerEvent && event.pointerType === "touch";
    return {
      screen,
      world: map.camera.toWorld(screen),
      shift: event.shiftKey,
      ctrl: event.ctrlKey || event.metaKey,
      alt: event.altKey,
      isTouch,
      picks: () => map.picksAt(screen, isTouch ? kTouchReach : kMouseReach),
    };
  }

  private place(event: MouseEvent): Point {
    const box = this.map.host.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private capture(pointer: number): void {
    try {
      this.map.host.setPointerCapture(pointer);
    } catch {
      // The pointer has gone already: its end will come as well.
    }
  }
}
