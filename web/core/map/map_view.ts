// The map in a host element: what it shows, where the camera is, which tool has the pointer. Drawn when something changed
// and never otherwise.
import { Camera } from "../camera.ts";
import type { Box, Point } from "../geometry.ts";
import type { Model, Parts } from "../model.ts";
import { placeText } from "../place_notation.ts";
import type { MapItem } from "../selection.ts";
import { Framing } from "./framing.ts";
import { MapInput } from "./input.ts";
import { Dirty, type LayerOptions, MapLayers, type Statistics } from "./map_layers.ts";
import { robotsIn, robotsNear, SceneIndex } from "./picking.ts";
import { PlaceReadout } from "./place_readout.ts";
import { SelectTool } from "./select_tool.ts";
import type { MapPick, MapTool, Pen } from "./tool.ts";

export interface MapViewOptions extends LayerOptions {
  /** What lies over the host, and leaves no room for what is fitted [CSS pixels of the host, y down]. */
  readonly covered?: () => readonly Box[];
}

export class MapView {
  readonly camera = new Camera();
  readonly framing: Framing;
  /** What lists point at, drawn as if the pointer were over it. */
  hover: MapPick | null = null;
  /** What others draw with each drawing; see addLayer. */
  readonly extraLayers = new Set<(pen: Pen) => void>();

  private readonly layers: MapLayers;
  private readonly input: MapInput;
  private readonly readout: PlaceReadout;
  private readonly select = new SelectTool();
  private index = new SceneIndex(null);
  private activeTool: MapTool = this.select;
  private isFitted = false;
  private readonly endings: (() => void)[] = [];
  private readonly listeners = new Set<() => void>();

  constructor(
    readonly host: HTMLElement,
    readonly model: Model,
    options: MapViewOptions = {},
  ) {
    prepare(host);
    this.framing = new Framing({
      camera: this.camera,
      model,
      index: () => this.index,
      covered: options.covered,
      moved: () => this.moved(),
      turned: () => this.tell(),
    });
    this.layers = new MapLayers(this, options);
    this.select.start(this);
    this.input = new MapInput(this);
    this.readout = new PlaceReadout(this);
    this.listen();
    this.takeScene();
    this.resize();
  }

  /** The active tool: selecting, unless another was chosen. */
  get tool(): MapTool {
    return this.activeTool;
  }

  /** null: selecting. */
  useTool(tool: MapTool | null): void {
    const next = tool ?? this.select;
    if (next === this.activeTool) return;
    this.input.breakOff();
    this.activeTool.end?.();
    this.activeTool = next;
    next.start?.(this);
    this.input.showCursor();
    this.tell();
    this.redraw();
  }

  setHover(pick: MapPick | null): void {
    if (samePick(pick, this.hover)) return;
    const ground = (pick && pick.kind !== "robot") || (this.hover && this.hover.kind !== "robot");
    this.hover = pick;
    this.layers.change(Dirty.TOP | (ground ? Dirty.GROUND : 0));
  }

  /** Everything within reach of a place on the screen, nearest and uppermost first. */
  picksAt(screen: Point, reach: number): MapPick[] {
    const settings = this.model.get("map");
    const robots = settings.layers.robots ? robotsNear(this.model, this.camera, screen, reach) : [];
    return [...robots, ...this.index.near(this.camera.toWorld(screen), reach / this.camera.scale, settings)];
  }

  robotsIn(box: Box): number[] {
    return robotsIn(this.model, box);
  }

  itemsIn(box: Box): MapItem[] {
    return this.index.inside(box, this.model.get("map"));
  }

  /** Draws something of one's own below marks and names of robots, with each drawing of the map. Returns how to end it. */
  addLayer(draw: (pen: Pen) => void): () => void {
    this.extraLayers.add(draw);
    this.redraw();
    return () => {
      this.extraLayers.delete(draw);
      this.redraw();
    };
  }

  /** What a tool or a layer draws has changed. */
  redraw(): void {
    this.layers.change(Dirty.TOP);
  }

  /** Told when the camera, the tool or what is followed changes. */
  subscribe(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** The newest place under the pointer, as people read it; null: there was none yet. */
  placeUnderPointer(): string | null {
    const { place } = this.readout;
    return place && placeText(this.model.get("scene"), place, this.model.get("map").notation, this.camera.scale);
  }

  statistics(): Statistics {
    return this.layers.statistics();
  }

  /** What the map shows now, as a picture. */
  toPng(): Promise<Blob> {
    return this.layers.toPng();
  }

  /** Draws now what has changed. Called by the browser before it paints; tests call it themselves. */
  draw(): void {
    this.layers.draw();
  }

  dispose(): void {
    this.activeTool.end?.();
    this.input.dispose();
    this.readout.dispose();
    this.layers.dispose();
    for (const end of this.endings) end();
  }

  private listen(): void {
    const part = (name: keyof Parts, change: () => void): void => {
      this.endings.push(this.model.subscribe(name, change));
    };
    part("scene", () => this.takeScene());
    part("welcome", () => this.layers.change(Dirty.GROUND));
    part("roster", () => this.layers.change(Dirty.ALL));
    part("starts", () => this.layers.change(Dirty.GROUND | Dirty.TOP));
    part("map", () => this.layers.change(Dirty.ALL));
    part("selection", () => this.layers.change(Dirty.ALL));
    part("status", () => this.layers.change(Dirty.TOP));
    this.endings.push(this.model.onFrame(() => this.layers.takeFrame()));
    const observer = new ResizeObserver(() => this.resize());
    observer.observe(this.host);
    this.endings.push(() => observer.disconnect());
    // The density changes with the page's zoom and with the screen that the window is on.
    const onWindow = (): void => this.resize();
    window.addEventListener("resize", onWindow);
    this.endings.push(() => window.removeEventListener("resize", onWindow));
  }

  private takeScene(): void {
    const scene = this.model.get("scene");
    this.index = new SceneIndex(scene);
    this.layers.takeScene(scene);
    if (scene && !this.isFitted) {
      this.isFitted = true;
      this.framing.fit();
    }
    this.layers.change(Dirty.ALL);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    if (this.layers.resize(clientWidth, clientHeight)) {
      const isFirst = this.camera.width <= 1;
      this.camera.resize(clientWidth, clientHeight);
      if (isFirst) this.framing.fit();
      // At once: a canvas that has changed its size is empty until it is drawn.
      this.layers.drawAll();
    }
    this.tell();
  }

  private moved(): void {
    this.layers.change(Dirty.ALL);
    this.tell();
  }

  private tell(): void {
    for (const listener of [...this.listeners]) listener();
  }
}

function prepare(host: HTMLElement): void {
  host.classList.add("map");
  if (!host.hasAttribute("role")) host.setAttribute("role", "application");
  if (!host.hasAttribute("aria-label")) host.setAttribute("aria-label", "Map");
  if (getComputedStyle(host).position === "static") host.style.position = "relative";
  host.style.overflow = "hidden";
  host.style.isolation = "isolate";
  host.style.touchAction = "none";
}

function samePick(a: MapPick | null, b: MapPick | null): boolean {
  if (!a || !b) return a === b;
  if (a.kind === "robot") return b.kind === "robot" && a.id === b.id;
  return b.kind === a.kind && a.index === b.index;
}
