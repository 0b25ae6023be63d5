// A map of the Earth below ours: fetches its squares, draws them, says whose they are.
import { projectionOf } from "../place_notation.ts";
import type { Projection } from "../projection.ts";
import type { Tiles } from "../protocol.ts";
import type { MapView } from "./map_view.ts";
import { fade } from "./palette.ts";
import { kSans } from "./strokes.ts";
import { type Laid, layPiece, piecesOf, type Square, squaresIn, zoomFor } from "./tiles.ts";
import type { Pen } from "./tool.ts";

/** What the server hands out, where the overlay says where the map lies, and it is to be seen. */
export class TileLayer {
  private readonly loader: TileLoader;
  private readonly attribution = document.createElement("div");

  constructor(
    private readonly map: MapView,
    addressOf: (path: string) => string,
    onLoaded: () => void,
  ) {
    this.loader = new TileLoader(addressOf, onLoaded);
    this.attribution.className = "map-attribution";
    map.host.append(this.attribution);
  }

  draw(pen: Pen): void {
    const { model } = this.map;
    const tiles = model.get("welcome")?.tiles;
    const projection = projectionOf(model.get("scene"));
    const isShown = tiles !== undefined && projection !== null && model.get("map").layers.tiles;
    this.showAttribution(pen, isShown ? tiles.attribution : "");
    if (isShown) drawTiles(pen, projection, tiles, this.loader);
  }

  dispose(): void {
    this.attribution.remove();
  }

  /** In the corner, above the coordinates under the pointer. */
  private showAttribution({ palette }: Pen, text: string): void {
    if (this.attribution.textContent !== text) this.attribution.textContent = text;
    this.attribution.style.cssText =
      `position:absolute;z-index:3;right:10px;bottom:42px;max-width:70%;padding:2px 8px;border-radius:6px;` +
      `pointer-events:none;font:400 11px ${kSans};color:${palette.softInk};background:${fade(palette.ground, 0.85)};` +
      `display:${text ? "block" : "none"}`;
  }
}

/** Draws what is there of the squares, and asks for the rest. */
function drawTiles(pen: Pen, projection: Projection, tiles: Tiles, loader: TileLoader): void {
  const { camera, palette, context, density } = pen;
  const latitude = projection.toEarth({ x: 0, y: 0 }).latitude;
  const zoom = zoomFor(camera.scale * density, latitude, tiles);
  for (const square of squaresIn(camera.visible(), projection, tiles, zoom)) {
    const found = loader.find(square, tiles.leastZoom);
    if (!found) continue;
    const pieces = piecesOf(zoom);
    for (let row = 0; row < pieces; ++row) {
      for (let column = 0; column < pieces; ++column)
        drawPiece(
          pen,
          found,
          layPiece(square, projection, column / pieces, row / pieces, 1 / pieces),
          [column, row],
          pieces,
        );
    }
  }
  context.setTransform(density, 0, 0, density, 0, 0);
  // What stands on the map has to be seen before it.
  context.globalAlpha = palette.isDark ? 0.45 : 0.2;
  context.fillStyle = palette.ground;
  context.fillRect(0, 0, camera.width, camera.height);
  context.globalAlpha = 1;
}

function drawPiece(
  pen: Pen,
  found: FoundTile,
  laid: Laid,
  [column, row]: readonly [number, number],
  pieces: number,
): void {
  const { camera, context, density } = pen;
  const scale = camera.scale * density;
  const { across, down, middle } = laid;
  context.setTransform(
    across.x * scale,
    -across.y * scale,
    down.x * scale,
    -down.y * scale,
    camera.toScreenX(middle.x) * density,
    camera.toScreenY(middle.y) * density,
  );
  const size = found.size / pieces;
  // Half a pixel more on each side, so that nothing shines through between two.
  const over = 0.5 / Math.max(1, Math.hypot(across.x, across.y) * scale);
  const side = 1 + 2 * over;
  context.drawImage(
    found.image,
    found.x + column * size,
    found.y + row * size,
    size,
    size,
    -0.5 - over,
    -0.5 - over,
    side,
    side,
  );
}

interface FoundTile {
  readonly image: HTMLImageElement;
  // The part of it that shows the square [pixels].
  readonly x: number;
  readonly y: number;
  readonly size: number;
}

const kMostKept = 500;
const kMostAbove = 5; // levels

/** Fetches squares as they are wanted, and keeps the newest ones. */
class TileLoader {
  private readonly kept = new Map<string, HTMLImageElement>();

  constructor(
    private readonly addressOf: (path: string) => string,
    private readonly onLoaded: () => void,
  ) {}

  /** The square; as long as it is not there, or where the file has none, the part of a coarser one that shows it. */
  find({ zoom, column, row }: Square, leastZoom: number): FoundTile | null {
    for (let up = 0; up <= kMostAbove && zoom - up >= leastZoom; ++up) {
      const share = 2 ** up;
      const image = this.load(zoom - up, Math.floor(column / share), Math.floor(row / share));
      if (!image.complete || image.naturalWidth === 0) continue;
      const size = image.naturalWidth / share;
      return { image, x: size * (column - Math.floor(column / share) * share), y: size * (row % share), size };
    }
    return null;
  }

  private load(zoom: number, column: number, row: number): HTMLImageElement {
    const side = 2 ** zoom;
    const path = `/tiles/${zoom}/${((column % side) + side) % side}/${row}`;
    const known = this.kept.get(path);
    if (known) {
      this.kept.delete(path); // and to the end again: the newest
      this.kept.set(path, known);
      return known;
    }
    const image = new Image();
    image.onload = this.onLoaded;
    image.src = this.addressOf(path);
    this.kept.set(path, image);
    if (this.kept.size > kMostKept) this.kept.delete(this.kept.keys().next().value as string);
    return image;
  }
}
