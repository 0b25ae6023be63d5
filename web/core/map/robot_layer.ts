// The robots' canvas, and who draws on it: the graphics card where there is one and they are many, else the processor.
import type { Camera } from "../camera.ts";
import type { Model } from "../model.ts";
import { drawsInSoftware, pen2d } from "./graphics.ts";
import { paletteOf } from "./palette.ts";
import { RobotStyles } from "./robot_styles.ts";
import { BlockPainter } from "./robots_blocks.ts";
import { drawRobotsByPath } from "./robots_canvas.ts";
import { RobotsByWebgl } from "./robots_webgl.ts";

export type Renderer = "webgl" | "canvas" | "blocks";

/** Fewer are drawn by paths, which look best and cost little. */
export const kManyRobots = 1500;
const kManyForProcessor = 400; // by paths they would take longer than a frame's time
const kToldApart = 5; // CSS pixels: a body of that radius is seen beside its arrow
const kSlowFrame = 45; // ms between drawings: a card that takes longer is none
const kPatience = 20; // slow frames in a row

export class RobotLayer {
  renderer: Renderer = "canvas";
  readonly styles = new RobotStyles();
  private readonly flat: HTMLCanvasElement;
  private card: HTMLCanvasElement | null = null;
  private plate: HTMLCanvasElement | null = null; // of blocks: kept in main memory, where they are made
  private webgl: RobotsByWebgl | null | undefined; // undefined: not tried yet
  private readonly blocks = new BlockPainter();
  private hasGivenUp = false;
  private slow = 0;
  private lastDrawing = 0;

  constructor(
    private readonly host: HTMLElement,
    private readonly redraw: () => void,
  ) {
    this.flat = this.addCanvas();
  }

  draw(camera: Camera, model: Model, density: number): void {
    const settings = model.get("map");
    this.styles.update(model);
    const showsMore = settings.circleRobots || this.styles.largestRadius * camera.scale >= kToldApart;
    const wanted = settings.layers.robots ? this.choose(model.robots.count, settings.renderer, showsMore) : "canvas";
    this.show(wanted);
    const palette = paletteOf(settings.theme);
    if (wanted === "webgl") {
      this.matchSize(this.card!);
      this.webgl!.draw(camera, model.robots, this.styles, palette, settings.circleRobots, density);
      this.watchSpeed(settings.renderer);
      return;
    }
    if (wanted === "blocks") {
      const onPlate = this.plate!.getContext("2d", { willReadFrequently: true })!;
      this.matchSize(this.plate!);
      this.blocks.draw(onPlate, camera, model.robots, this.styles, palette, density);
      return;
    }
    const context = pen2d(this.flat)!;
    context.setTransform(density, 0, 0, density, 0, 0);
    context.clearRect(0, 0, camera.width, camera.height);
    if (!settings.layers.robots) return;
    drawRobotsByPath(context, camera, model.robots, this.styles, palette, settings.circleRobots);
  }

  dispose(): void {
    this.webgl?.dispose();
  }

  /** @param showsMore  there is more to see of a robot than its arrow, which blocks can't show */
  private choose(robots: number, setting: "auto" | "webgl" | "canvas", showsMore: boolean): Renderer {
    const few = robots < (showsMore || !drawsInSoftware() ? kManyRobots : kManyForProcessor);
    if (setting === "canvas") return few ? "canvas" : "blocks";
    if (setting === "auto" && few) return "canvas";
    if (setting === "auto" && (this.hasGivenUp || drawsInSoftware())) return "blocks";
    const card = this.startCard();
    if (!card || card.isLost) return few ? "canvas" : "blocks";
    return "webgl";
  }

  private startCard(): RobotsByWebgl | null {
    if (this.webgl !== undefined) return this.webgl;
    this.card = this.addCanvas(this.flat);
    this.card.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.hasGivenUp = true;
      this.redraw();
    });
    this.webgl = RobotsByWebgl.on(this.card);
    return this.webgl;
  }

  /** What is drawn in software under another name shows by how long it takes. */
  private watchSpeed(setting: string): void {
    const now = performance.now();
    const since = now - this.lastDrawing;
    this.lastDrawing = now;
    if (setting !== "auto" || since > 500) return;
    this.slow = since > kSlowFrame ? this.slow + 1 : 0;
    if (this.slow >= kPatience) this.hasGivenUp = true;
  }

  private show(renderer: Renderer): void {
    this.renderer = renderer;
    if (renderer === "blocks") this.plate ??= this.addCanvas(this.flat);
    this.flat.style.display = renderer === "canvas" ? "" : "none";
    if (this.card) this.card.style.display = renderer === "webgl" ? "" : "none";
    if (this.plate) this.plate.style.display = renderer === "blocks" ? "" : "none";
  }

  private matchSize(canvas: HTMLCanvasElement): void {
    const { flat } = this;
    if (canvas.width === flat.width && canvas.height === flat.height) return;
    canvas.width = flat.width;
    canvas.height = flat.height;
  }

  private addCanvas(after?: HTMLCanvasElement): HTMLCanvasElement {
    const canvas = document.createElement("canvas");
    canvas.style.cssText = "position:absolute;inset:0;width:100%;height:100%;pointer-events:none";
    canvas.setAttribute("aria-hidden", "true");
    if (after) after.after(canvas);
    else this.host.append(canvas);
    return canvas;
  }
}
