// The map: stacked canvases in a host element, redrawn when something changed and never otherwise.
//
//   ground   picture, grid, overlay, obstacles         when the camera, the scene or a setting changes
//   trails   where robots have been                    some times a second
//   names    names of the overlay, scale, compass      with the ground
//   robots   WebGL2 or Canvas2D                        with each frame; many lie below the names
//   top      what belongs to watched robots, tools     with each frame, where there is something to draw
import { Camera } from "../camera.ts";
import { type Box, boundsOf, centreOf, grow, type Point, union } from "../geometry.ts";
import type { Model, Parts } from "../model.ts";
import type { MapItem } from "../selection.ts";
import { drawDecorations } from "./decorations.ts";
import { pen2d } from "./graphics.ts";
import { drawGround, drawNames } from "./ground.ts";
import { MapInput } from "./input.ts";
import { type PlacedLabel, placeMeasureLabels } from "./measure_labels.ts";
import { paletteOf } from "./palette.ts";
import { SceneIndex } from "./picking.ts";
import { PictureLoader } from "./picture.ts";
import { PlaceReadout } from "./place_readout.ts";
import { kManyRobots, RobotLayer } from "./robot_layer.ts";
import { SelectTool } from "./select_tool.ts";
import { drawStarts, startBoxes } from "./starts.ts";
import type { MapPick, MapTool, Pen } from "./tool.ts";
import { drawTop, isTopEmpty } from "./top.ts";
import { TrailLayer } from "./trail_layer.ts";

export interface MapViewOptions {
  /** The address to fetch a picture from; adds the token. */
  readonly pictureUrl?: (path: string) => string;
  /** Device pixels per CSS pixel; the window's own without. */
  readonly density?: number;
  /** What lies over the host, and leaves no room for what is fitted [CSS pixels of the host, y down]. */
  readonly covered?: () => readonly Box[];
}

export type Followed = { readonly robot: number } | { readonly unit: string } | null;

/** For people who want to know how fast it is. */
export interface Statistics {
  readonly renderer: "webgl" | "canvas" | "blocks";
  /** Main-thread time of the newest drawing [ms]. */
  readonly drawing: number;
  readonly drawings: number;
}

const kCheapDrawing = 8; // ms: robots glide between frames as long as a drawing takes no more

/** What has to be drawn anew. */
const Dirty = { GROUND: 1, TRAILS: 2, ROBOTS: 4, TOP: 8, ALL: 15 } as const;

export class MapView {
  readonly camera = new Camera();
  /** What lists point at, drawn as if the pointer were over it. */
  hover: MapPick | null = null;
  /** What lay over the map when something was last fitted to it. */
  coveredAtFit: readonly Box[] = [];

  private readonly ground: HTMLCanvasElement;
  private readonly names: HTMLCanvasElement;
  private readonly top: HTMLCanvasElement;
  private readonly robotLayer: RobotLayer;
  private readonly trailLayer: TrailLayer;
  private readonly picture: PictureLoader;
  private readonly input: MapInput;
  private readonly readout: PlaceReadout;
  private readonly select: SelectTool;
  private index: SceneIndex;
  private labels: readonly PlacedLabel[] = [];
  private activeTool: MapTool;
  private followed: Followed = null;
  private dirty = 0;
  private scheduled = 0;
  private drawnCamera = -1;
  private drawings = 0;
  private drawing = 0;
  private isFitted = false;
  private movedObjects = 0;
  private readonly endings: (() => void)[] = [];
  private readonly listeners = new Set<() => void>();
  private readonly layers = new Set<(pen: Pen) => void>();

  constructor(
    readonly host: HTMLElement,
    readonly model: Model,
    private readonly options: MapViewOptions = {},
  ) {
    host.classList.add("map");
    if (!host.hasAttribute("role")) host.setAttribute("role", "application");
    if (!host.hasAttribute("aria-label")) host.setAttribute("aria-label", "Map");
    if (getComputedStyle(host).position === "static") host.style.position = "relative";
    host.style.overflow = "hidden";
    host.style.isolation = "isolate";
    host.style.touchAction = "none";
    this.ground = this.addCanvas();
    this.trailLayer = new TrailLayer(this.addCanvas());
    this.names = this.addCanvas();
    this.robotLayer = new RobotLayer(host, () => this.change(Dirty.ROBOTS));
    this.top = this.addCanvas();
    this.top.style.zIndex = "2";
    this.index = new SceneIndex(null);
    this.picture = new PictureLoader(options.pictureUrl ?? ((path) => path), () => this.change(Dirty.GROUND));
    this.select = new SelectTool();
    this.activeTool = this.select;
    this.select.start(this);
    this.input = new MapInput(this);
    this.readout = new PlaceReadout(this);
    this.listen();
    this.resize();
    this.takeScene();
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

  get following(): Followed {
    return this.followed;
  }

  /** Keeps a robot, or the middle of a unit, in the middle of the screen, until the map is panned. */
  follow(target: Followed): void {
    this.followed = target;
    this.tell();
    this.change(Dirty.ALL);
  }

  /** All of the mission area; before there is one, nothing. */
  fit(): void {
    const scene = this.model.get("scene");
    if (!scene) return;
    this.fitTo({ xMin: 0, yMin: 0, xMax: Math.max(1, scene.width), yMax: Math.max(1, scene.height) });
  }

  fitTo(box: Box, margin = 40): void {
    this.stopFollowing();
    this.coveredAtFit = this.options.covered?.() ?? [];
    this.camera.fit(box, margin, this.coveredAtFit);
    this.moved();
  }

  /** All selected robots and things; the whole map where nothing is. */
  fitSelection(): void {
    const box = this.selectionBox();
    if (!box) {
      this.fit();
      return;
    }
    const room = Math.max(5, (box.xMax - box.xMin) * 0.3, (box.yMax - box.yMin) * 0.3);
    this.fitTo(grow(box, room));
  }

  centreOn(place: Point): void {
    this.stopFollowing();
    this.camera.lookAt(place);
    this.moved();
  }

  /** By a factor, about the middle of the screen. */
  zoom(factor: number): void {
    this.zoomAbout({ x: this.camera.width / 2, y: this.camera.height / 2 }, factor);
  }

  zoomAbout(screen: Point, factor: number): void {
    this.camera.zoomAbout(screen, factor);
    this.moved();
  }

  /** In pixels, as dragging does. Ends following. */
  pan(dx: number, dy: number): void {
    this.stopFollowing();
    this.camera.pan(dx, dy);
    this.moved();
  }

  setHover(pick: MapPick | null): void {
    if (samePick(pick, this.hover)) return;
    const ground = (pick && pick.kind !== "robot") || (this.hover && this.hover.kind !== "robot");
    this.hover = pick;
    this.change(Dirty.TOP | (ground ? Dirty.GROUND : 0));
  }

  /** Everything within reach of a place on the screen, nearest and uppermost first. */
  picksAt(screen: Point, reach: number): MapPick[] {
    const settings = this.model.get("map");
    const robots = settings.layers.robots ? this.robotsNear(screen, reach) : [];
    return [...robots, ...this.index.near(this.camera.toWorld(screen), reach / this.camera.scale, settings)];
  }

  robotsIn(box: Box): number[] {
    const found: number[] = [];
    for (const robots of [this.model.robots, this.model.get("starts")]) {
      for (let row = 0; row < robots.count; ++row) {
        const x = robots.x(row);
        const y = robots.y(row);
        if (x >= box.xMin && x <= box.xMax && y >= box.yMin && y <= box.yMax) found.push(robots.id(row));
      }
    }
    return found;
  }

  itemsIn(box: Box): MapItem[] {
    return this.index.inside(box, this.model.get("map"));
  }

  /** Draws something of one's own below marks and names of robots, with each drawing of the map. Returns how to end it. */
  addLayer(draw: (pen: Pen) => void): () => void {
    this.layers.add(draw);
    this.redraw();
    return () => {
      this.layers.delete(draw);
      this.redraw();
    };
  }

  /** What a tool or a layer draws has changed. */
  redraw(): void {
    this.change(Dirty.TOP);
  }

  /** Told when the camera, the tool or what is followed changes. */
  subscribe(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  statistics(): Statistics {
    return { renderer: this.robotLayer.renderer, drawing: this.drawing, drawings: this.drawings };
  }

  /** What the map shows now, as a picture. */
  async toPng(): Promise<Blob> {
    this.dirty = Dirty.ALL;
    this.draw();
    this.drawTrails(true);
    const picture = document.createElement("canvas");
    picture.width = this.ground.width;
    picture.height = this.ground.height;
    const context = picture.getContext("2d")!;
    const layers = [...this.host.querySelectorAll("canvas")];
    layers.sort((a, b) => Number(a.style.zIndex) - Number(b.style.zIndex));
    for (const canvas of layers) {
      if (canvas.style.display !== "none") context.drawImage(canvas, 0, 0, picture.width, picture.height);
    }
    const blob = await new Promise<Blob | null>((resolve) => picture.toBlob(resolve, "image/png"));
    if (!blob) throw new Error("the browser could not make a picture of the map");
    return blob;
  }

  dispose(): void {
    cancelAnimationFrame(this.scheduled);
    this.activeTool.end?.();
    this.input.dispose();
    this.readout.dispose();
    this.robotLayer.dispose();
    for (const end of this.endings) end();
    for (const canvas of [...this.host.querySelectorAll("canvas")]) canvas.remove();
  }

  /** Draws now what has changed. Called by the browser before it paints; tests call it themselves. */
  draw(): void {
    if (!pen2d(this.ground)) return; // a page without pictures, as in unit tests
    const start = performance.now();
    const { robots, glide } = this.model;
    robots.share = glide.share(start);
    this.followNow();
    if (this.camera.version !== this.drawnCamera) this.dirty = Dirty.ALL;
    const dirty = this.dirty;
    this.dirty = 0;
    this.drawnCamera = this.camera.version;
    if (dirty & Dirty.GROUND) this.drawGround();
    if (dirty & Dirty.TRAILS) this.drawTrails(false);
    if (dirty & Dirty.ROBOTS) this.drawRobots();
    if (dirty & Dirty.TOP) this.drawTop();
    ++this.drawings;
    this.drawing = performance.now() - start;
    glide.isWanted = this.drawing < kCheapDrawing && this.robotLayer.renderer !== "blocks";
    if (robots.share < 1) this.change(Dirty.ROBOTS | Dirty.TOP);
  }

  /** A few robots stand over names, many under them: else nothing could be read. */
  private drawRobots(): void {
    this.robotLayer.draw(this.camera, this.model, this.density());
    this.names.style.zIndex = this.model.robots.count < kManyRobots ? "" : "1";
  }

  private drawTrails(whole: boolean): void {
    const palette = paletteOf(this.model.get("map").theme);
    this.trailLayer.draw(this.camera, this.model, palette, this.density(), whole);
    if (this.trailLayer.isPending) this.change(Dirty.TRAILS);
  }

  private drawGround(): void {
    const pen = this.pen(this.ground);
    const scene = this.model.get("scene");
    const settings = this.model.get("map");
    this.robotLayer.styles.update(this.model);
    const bodies = startBoxes(pen, this.model, this.robotLayer.styles);
    this.labels = scene ? placeMeasureLabels(pen, scene, settings, bodies) : [];
    drawGround(pen, this.model, this.picture.image, this.hover);
    const above = this.pen(this.names);
    drawNames(above, this.labels);
    const taken = this.labels.map(({ box }) => box);
    drawStarts(above, this.model, this.robotLayer.styles, taken);
    if (settings.layers.decorations) drawDecorations(above);
  }

  private drawTop(): void {
    const state = { hover: this.hover, taken: this.labels.map(({ box }) => box), styles: this.robotLayer.styles };
    const draws = this.activeTool.isDrawing?.() ?? this.activeTool.draw !== undefined;
    const isEmpty = !draws && this.layers.size === 0 && isTopEmpty(this.model, state);
    this.top.style.display = isEmpty ? "none" : "";
    if (isEmpty) return;
    const pen = this.pen(this.top);
    for (const layer of this.layers) layer(pen);
    drawTop(pen, this.model, state);
    this.activeTool.draw?.(pen);
  }

  private pen(canvas: HTMLCanvasElement): Pen {
    const density = this.density();
    const context = pen2d(canvas)!;
    context.setTransform(density, 0, 0, density, 0, 0);
    context.clearRect(0, 0, this.camera.width, this.camera.height);
    const settings = this.model.get("map");
    return { context, camera: this.camera, palette: paletteOf(settings.theme), military: settings.military, density };
  }

  private density(): number {
    return this.options.density ?? (window.devicePixelRatio || 1);
  }

  private addCanvas(): HTMLCanvasElement {
    const canvas = document.createElement("canvas");
    canvas.style.cssText = "position:absolute;inset:0;width:100%;height:100%;pointer-events:none";
    canvas.setAttribute("aria-hidden", "true");
    this.host.append(canvas);
    return canvas;
  }

  private listen(): void {
    const part = (name: keyof Parts, change: () => void): void => {
      this.endings.push(this.model.subscribe(name, change));
    };
    part("scene", () => this.takeScene());
    part("roster", () => this.change(Dirty.ALL));
    part("starts", () => this.change(Dirty.GROUND | Dirty.TOP));
    part("map", () => this.change(Dirty.ALL));
    part("selection", () => this.change(Dirty.ALL));
    part("status", () => this.change(Dirty.TOP));
    this.endings.push(this.model.onFrame(() => this.takeFrame()));
    const observer = new ResizeObserver(() => this.resize());
    observer.observe(this.host);
    this.endings.push(() => observer.disconnect());
    // The density changes with the page's zoom and with the screen that the window is on.
    const onWindow = (): void => this.resize();
    window.addEventListener("resize", onWindow);
    this.endings.push(() => window.removeEventListener("resize", onWindow));
  }

  private takeFrame(): void {
    const moved = this.model.movedObjects.size;
    const trails = this.trailLayer.isDue(this.model) ? Dirty.TRAILS : 0;
    // An object that moves leaves the ground for the top.
    const ground = moved !== this.movedObjects ? Dirty.GROUND : 0;
    this.movedObjects = moved;
    this.change(Dirty.ROBOTS | Dirty.TOP | trails | ground);
  }

  private takeScene(): void {
    const scene = this.model.get("scene");
    this.index = new SceneIndex(scene);
    this.picture.load(scene?.picture?.url ?? "");
    if (scene && !this.isFitted) {
      this.isFitted = true;
      this.fit();
    }
    this.change(Dirty.ALL);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    const isFirst = this.camera.width <= 1;
    const density = this.density();
    for (const canvas of this.host.querySelectorAll("canvas")) {
      canvas.width = Math.round(clientWidth * density);
      canvas.height = Math.round(clientHeight * density);
    }
    this.camera.resize(clientWidth, clientHeight);
    if (isFirst) this.fit();
    // Drawn at once: a canvas that has changed its size is empty until it is.
    this.dirty = Dirty.ALL;
    this.draw();
    this.tell();
  }

  private change(dirty: number): void {
    this.dirty |= dirty;
    if (this.scheduled) return;
    this.scheduled = requestAnimationFrame(() => {
      this.scheduled = 0;
      this.draw();
    });
  }

  private moved(): void {
    this.change(Dirty.ALL);
    this.tell();
  }

  private tell(): void {
    for (const listener of [...this.listeners]) listener();
  }

  private stopFollowing(): void {
    this.followed = null;
  }

  private followNow(): void {
    if (!this.followed) return;
    const roster = this.model.get("roster");
    const ids = "robot" in this.followed ? [this.followed.robot] : roster.robotsOf(this.followed.unit);
    const places = ids.flatMap((id) => this.model.placeOf(id) ?? []);
    if (places.length === 0) return;
    const middle = centreOf(places);
    if (Math.abs(middle.x - this.camera.x) + Math.abs(middle.y - this.camera.y) > 0.25 / this.camera.scale) {
      this.camera.lookAt(middle);
      this.tell();
    }
  }

  private selectionBox(): Box | null {
    const { robots, items } = this.model.get("selection");
    let box = boundsOf(robots.flatMap((id) => this.model.placeOf(id) ?? []));
    for (const item of items) {
      const own = this.index.boxOf(item);
      if (own) box = box ? union(box, own) : own;
    }
    return box;
  }

  private robotsNear(screen: Point, reach: number): MapPick[] {
    const world = this.camera.toWorld(screen);
    const found: { id: number; distance: number }[] = [];
    const { robotScale } = this.model.get("map");
    const roster = this.model.get("roster");
    const coarse = (reach + 60) / this.camera.scale + 2 * robotScale;
    for (const robots of [this.model.robots, this.model.get("starts")]) {
      for (let row = 0; row < robots.count; ++row) {
        const dx = robots.x(row) - world.x;
        const dy = robots.y(row) - world.y;
        if (Math.abs(dx) > coarse || Math.abs(dy) > coarse) continue;
        const id = robots.id(row);
        const body = (roster.robot(id)?.radius ?? 0.2) * robotScale * this.camera.scale;
        const distance = Math.hypot(dx, dy) * this.camera.scale;
        if (distance <= Math.max(body, 6) + reach) found.push({ id, distance });
      }
    }
    found.sort((a, b) => a.distance - b.distance);
    return found.map(({ id }) => ({ kind: "robot", id }));
  }
}

function samePick(a: MapPick | null, b: MapPick | null): boolean {
  if (!a || !b) return a === b;
  if (a.kind === "robot") return b.kind === "robot" && a.id === b.id;
  return b.kind === a.kind && a.index === b.index;
}
