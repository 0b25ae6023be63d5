// The stacked canvases, and what of them has to be drawn anew.
//
//   ground   picture, grid, overlay, obstacles         when the camera, the scene or a setting changes
//   trails   where robots have been                    some times a second
//   names    names of the overlay, scale, compass      with the ground
//   robots   WebGL2 or Canvas2D                        with each frame; many lie below the names
//   top      what belongs to watched robots, tools     with each frame, where there is something to draw
import type { Scene } from "../protocol.ts";
import { drawDecorations } from "./decorations.ts";
import { pen2d } from "./graphics.ts";
import { drawGround, drawNames } from "./ground.ts";
import type { MapView } from "./map_view.ts";
import { type PlacedLabel, placeMeasureLabels } from "./measure_labels.ts";
import { paletteOf } from "./palette.ts";
import { PictureLoader } from "./picture.ts";
import { kManyRobots, RobotLayer } from "./robot_layer.ts";
import { drawStarts, startBoxes } from "./starts.ts";
import { TileLayer } from "./tile_layer.ts";
import type { Pen } from "./tool.ts";
import { drawTop, isTopEmpty } from "./top.ts";
import { TrailLayer } from "./trail_layer.ts";

export interface LayerOptions {
  /** The address to fetch a picture from; adds the token. */
  readonly pictureUrl?: (path: string) => string;
  /** Device pixels per CSS pixel; the window's own without. */
  readonly density?: number;
}

/** For people who want to know how fast it is. */
export interface Statistics {
  readonly renderer: "webgl" | "canvas" | "blocks";
  /** Main-thread time of the newest drawing [ms]. */
  readonly drawing: number;
  readonly drawings: number;
}

const kCheapDrawing = 8; // ms: robots glide between frames as long as a drawing takes no more

/** What has to be drawn anew. */
export const Dirty = { GROUND: 1, TRAILS: 2, ROBOTS: 4, TOP: 8, ALL: 15 } as const;

export class MapLayers {
  private readonly ground: HTMLCanvasElement;
  private readonly names: HTMLCanvasElement;
  private readonly top: HTMLCanvasElement;
  private readonly robotLayer: RobotLayer;
  private readonly trailLayer: TrailLayer;
  private readonly picture: PictureLoader;
  private readonly tiles: TileLayer;
  private labels: readonly PlacedLabel[] = [];
  private dirty = 0;
  private scheduled = 0;
  private drawnCamera = -1;
  private drawings = 0;
  private drawing = 0;
  private movedObjects = 0;
  private size = "";

  constructor(
    private readonly map: MapView,
    private readonly options: LayerOptions,
  ) {
    this.ground = this.addCanvas();
    this.trailLayer = new TrailLayer(this.addCanvas());
    this.names = this.addCanvas();
    this.robotLayer = new RobotLayer(map.host, () => this.change(Dirty.ROBOTS));
    this.top = this.addCanvas();
    this.top.style.zIndex = "2";
    const addressOf = options.pictureUrl ?? ((path: string) => path);
    this.picture = new PictureLoader(addressOf, () => this.change(Dirty.GROUND));
    this.tiles = new TileLayer(map, addressOf, () => this.change(Dirty.GROUND));
  }

  statistics(): Statistics {
    return { renderer: this.robotLayer.renderer, drawing: this.drawing, drawings: this.drawings };
  }

  takeScene(scene: Scene | null): void {
    this.picture.load(scene?.picture?.url ?? "");
  }

  /** [CSS pixels] @returns false: they have this size already */
  resize(width: number, height: number): boolean {
    const density = this.density();
    const size = `${width}/${height}/${density}`;
    if (size === this.size) return false;
    this.size = size;
    for (const canvas of this.map.host.querySelectorAll("canvas")) {
      canvas.width = Math.round(width * density);
      canvas.height = Math.round(height * density);
    }
    return true;
  }

  /** Newer places of robots and moved things have come. */
  takeFrame(): void {
    const moved = this.map.model.movedObjects.size;
    const trails = this.trailLayer.isDue(this.map.model) ? Dirty.TRAILS : 0;
    // An object that moves leaves the ground for the top.
    const ground = moved !== this.movedObjects ? Dirty.GROUND : 0;
    this.movedObjects = moved;
    this.change(Dirty.ROBOTS | Dirty.TOP | trails | ground);
  }

  /** Draws parts anew, of Dirty, before the browser paints next. */
  change(dirty: number): void {
    this.dirty |= dirty;
    if (this.scheduled) return;
    this.scheduled = requestAnimationFrame(() => {
      this.scheduled = 0;
      this.draw();
    });
  }

  /** All of it, now. */
  drawAll(): void {
    this.dirty = Dirty.ALL;
    this.draw();
  }

  /** What the map shows now, as a picture. */
  async toPng(): Promise<Blob> {
    this.drawAll();
    this.drawTrails(true);
    const picture = document.createElement("canvas");
    picture.width = this.ground.width;
    picture.height = this.ground.height;
    const context = picture.getContext("2d")!;
    const layers = [...this.map.host.querySelectorAll("canvas")];
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
    this.robotLayer.dispose();
    this.tiles.dispose();
    for (const canvas of [...this.map.host.querySelectorAll("canvas")]) canvas.remove();
  }

  /** Draws now what has changed. Called by the browser before it paints; tests call it themselves. */
  draw(): void {
    if (!pen2d(this.ground)) return; // a page without pictures, as in unit tests
    const start = performance.now();
    const { robots, glide } = this.map.model;
    robots.share = glide.share(start);
    this.map.framing.followNow();
    if (this.map.camera.version !== this.drawnCamera) this.dirty = Dirty.ALL;
    const dirty = this.dirty;
    this.dirty = 0;
    this.drawnCamera = this.map.camera.version;
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
    this.robotLayer.draw(this.map.camera, this.map.model, this.density());
    this.names.style.zIndex = this.map.model.robots.count < kManyRobots ? "" : "1";
  }

  private drawTrails(whole: boolean): void {
    const palette = paletteOf(this.map.model.get("map").theme);
    this.trailLayer.draw(this.map.camera, this.map.model, palette, this.density(), whole);
    if (this.trailLayer.isPending) this.change(Dirty.TRAILS);
  }

  private drawGround(): void {
    const pen = this.pen(this.ground);
    const scene = this.map.model.get("scene");
    const settings = this.map.model.get("map");
    this.robotLayer.styles.update(this.map.model);
    const bodies = startBoxes(pen, this.map.model, this.robotLayer.styles);
    this.labels = scene ? placeMeasureLabels(pen, scene, settings, bodies) : [];
    drawGround(pen, this.map.model, { picture: this.picture.image, tiles: this.tiles }, this.map.hover);
    const above = this.pen(this.names);
    drawNames(above, this.labels);
    const taken = this.labels.map(({ box }) => box);
    drawStarts(above, this.map.model, this.robotLayer.styles, taken);
    if (settings.layers.decorations) drawDecorations(above);
  }

  private drawTop(): void {
    const state = { hover: this.map.hover, taken: this.labels.map(({ box }) => box), styles: this.robotLayer.styles };
    const { tool, extraLayers } = this.map;
    const draws = tool.isDrawing?.() ?? tool.draw !== undefined;
    const isEmpty = !draws && extraLayers.size === 0 && isTopEmpty(this.map.model, state);
    this.top.style.display = isEmpty ? "none" : "";
    if (isEmpty) return;
    const pen = this.pen(this.top);
    for (const layer of extraLayers) layer(pen);
    drawTop(pen, this.map.model, state);
    tool.draw?.(pen);
  }

  private pen(canvas: HTMLCanvasElement): Pen {
    const density = this.density();
    const context = pen2d(canvas)!;
    context.setTransform(density, 0, 0, density, 0, 0);
    context.clearRect(0, 0, this.map.camera.width, this.map.camera.height);
    const settings = this.map.model.get("map");
    return {
      context,
      camera: this.map.camera,
      palette: paletteOf(settings.theme),
      military: settings.military,
      density,
    };
  }

  private density(): number {
    return this.options.density ?? (window.devicePixelRatio || 1);
  }

  private addCanvas(): HTMLCanvasElement {
    const canvas = document.createElement("canvas");
    canvas.style.cssText = "position:absolute;inset:0;width:100%;height:100%;pointer-events:none";
    canvas.setAttribute("aria-hidden", "true");
    this.map.host.append(canvas);
    return canvas;
  }
}
