// What of the world is in sight: the camera, moved by people, or after robots that are followed.
import type { Camera } from "../camera.ts";
import { type Box, centreOf, grow, type Point } from "../geometry.ts";
import type { Model } from "../model.ts";
import { type SceneIndex, selectionBox } from "./picking.ts";

export type Followed = { readonly robot: number } | { readonly unit: string } | null;

export interface FramingOptions {
  readonly camera: Camera;
  readonly model: Model;
  /** Of the scene that is shown. */
  readonly index: () => SceneIndex;
  /** What lies over the map, and leaves no room for what is fitted. */
  readonly covered: (() => readonly Box[]) | undefined;
  /** Told when the camera or what is followed was changed, and everything is to be drawn anew. */
  readonly moved: () => void;
  /** Told when the camera has gone after what is followed, in the course of a drawing. */
  readonly turned: () => void;
}

export class Framing {
  /** What lay over the map when something was last fitted to it. */
  coveredAtFit: readonly Box[] = [];
  private followed: Followed = null;
  private readonly camera: Camera;
  private readonly model: Model;

  constructor(private readonly options: FramingOptions) {
    this.camera = options.camera;
    this.model = options.model;
  }

  get following(): Followed {
    return this.followed;
  }

  /** Keeps a robot, or the middle of a unit, in the middle of the screen, until the map is panned. */
  follow(target: Followed): void {
    this.followed = target;
    this.options.moved();
  }

  /** All of the mission area; before there is one, nothing. */
  fit(): void {
    const scene = this.model.get("scene");
    if (!scene) return;
    this.fitTo({ xMin: 0, yMin: 0, xMax: Math.max(1, scene.width), yMax: Math.max(1, scene.height) });
  }

  fitTo(box: Box, margin = 40): void {
    this.followed = null;
    this.coveredAtFit = this.options.covered?.() ?? [];
    this.camera.fit(box, margin, this.coveredAtFit);
    this.options.moved();
  }

  /** All selected robots and things; the whole map where nothing is. */
  fitSelection(): void {
    const box = selectionBox(this.model, this.options.index());
    if (!box) {
      this.fit();
      return;
    }
    const room = Math.max(5, (box.xMax - box.xMin) * 0.3, (box.yMax - box.yMin) * 0.3);
    this.fitTo(grow(box, room));
  }

  centreOn(place: Point): void {
    this.followed = null;
    this.camera.lookAt(place);
    this.options.moved();
  }

  /** By a factor, about the middle of the screen. */
  zoom(factor: number): void {
    this.zoomAbout({ x: this.camera.width / 2, y: this.camera.height / 2 }, factor);
  }

  zoomAbout(screen: Point, factor: number): void {
    this.camera.zoomAbout(screen, factor);
    this.options.moved();
  }

  /** In pixels, as dragging does. Ends following. */
  pan(dx: number, dy: number): void {
    this.followed = null;
    this.camera.pan(dx, dy);
    this.options.moved();
  }

  followNow(): void {
    if (!this.followed) return;
    const roster = this.model.get("roster");
    const ids = "robot" in this.followed ? [this.followed.robot] : roster.robotsOf(this.followed.unit);
    const places = ids.flatMap((id) => this.model.placeOf(id) ?? []);
    if (places.length === 0) return;
    const middle = centreOf(places);
    if (Math.abs(middle.x - this.camera.x) + Math.abs(middle.y - this.camera.y) > 0.25 / this.camera.scale) {
      this.camera.lookAt(middle);
      this.options.turned();
    }
  }
}
