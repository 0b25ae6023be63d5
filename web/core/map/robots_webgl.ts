// Robots by the graphics card, straight from the frame's records, which go up as a texture, one texel each: the main
// thread does the same work for ten robots as for ten thousand. Colours and sizes stand in two more, found by the id.

import type { Camera } from "../camera.ts";
import { parseColor } from "../color.ts";
import type { RobotTable } from "../robots.ts";
import type { Palette } from "./palette.ts";
import { kTableWidth, type RobotStyles } from "./robot_styles.ts";
import { arrowMesh, arrowVertex, kArrowFragment, kRingFragment, kRingVertex } from "./shaders.ts";

const kBefore = 3; // texture unit

const kUniforms = [
  "middle",
  "halfScreen",
  "scale",
  "least",
  "circles",
  "records",
  "before",
  "share",
  "colors",
  "sizes",
  "capacity",
  "halo",
  "selection",
  "pixel",
] as const;

interface Program {
  readonly program: WebGLProgram;
  readonly uniforms: Readonly<Record<(typeof kUniforms)[number], WebGLUniformLocation | null>>;
}

export class RobotsByWebgl {
  private readonly arrows: Program;
  private readonly rings: Program;
  private readonly indices: WebGLBuffer;
  private readonly mesh = arrowMesh();
  private rows = [0, 0]; // of the textures of records, the newest and those before
  private version = -1; // of the records that are up
  private versionBefore = -1;
  private indexed = 0; // robots that the indices suffice for
  private stylesVersion = -1;

  /** null where WebGL2 is missing or refuses. */
  static on(canvas: HTMLCanvasElement): RobotsByWebgl | null {
    const gl = canvas.getContext("webgl2", {
      antialias: false, // the shapes are smoothed by the shader
      depth: false,
      premultipliedAlpha: true,
      powerPreference: "high-performance",
      preserveDrawingBuffer: true, // for the picture that can be saved
    });
    if (!gl) return null;
    try {
      return new RobotsByWebgl(gl);
    } catch (error) {
      console.warn(error); // the map is drawn another way
      return null;
    }
  }

  private constructor(private readonly gl: WebGL2RenderingContext) {
    this.arrows = link(gl, arrowVertex(), kArrowFragment);
    this.rings = link(gl, kRingVertex, kRingFragment);
    this.indices = gl.createBuffer();
    // Records, colours, sizes, records before.
    for (const unit of [0, 1, 2, kBefore]) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    }
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  get isLost(): boolean {
    return this.gl.isContextLost();
  }

  draw(camera: Camera, robots: RobotTable, styles: RobotStyles, palette: Palette, circles: boolean, density: number) {
    const { gl } = this;
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    if (robots.count === 0) return;
    this.upload(robots);
    this.uploadStyles(styles);
    const set = ({ program, uniforms }: Program): void => {
      gl.useProgram(program);
      gl.uniform2f(uniforms.middle, camera.x, camera.y);
      gl.uniform2f(uniforms.halfScreen, camera.width / 2, camera.height / 2);
      gl.uniform1f(uniforms.scale, camera.scale);
      gl.uniform1f(uniforms.least, styles.least);
      gl.uniform1f(uniforms.circles, circles ? 1 : 0);
      gl.uniform1i(uniforms.capacity, styles.capacity);
      gl.uniform1f(uniforms.pixel, 1 / density);
      gl.uniform3f(uniforms.halo, ...shares(palette.halo));
      gl.uniform3f(uniforms.selection, ...shares(palette.selection));
      gl.uniform1f(uniforms.share, robots.share);
      gl.uniform1i(uniforms.records, 0);
      gl.uniform1i(uniforms.before, kBefore);
      gl.uniform1i(uniforms.colors, 1);
      gl.uniform1i(uniforms.sizes, 2);
    };
    if (circles || styles.hasSelected || styles.largestRadius * camera.scale >= 5) {
      set(this.rings);
      gl.drawArrays(gl.TRIANGLES, 0, robots.count * 6);
    }
    set(this.arrows);
    gl.drawElements(gl.TRIANGLES, robots.count * this.mesh.indices.length, gl.UNSIGNED_INT, 0);
  }

  dispose(): void {
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  /** Once a frame; in between only the share of the way changes. */
  private upload(robots: RobotTable): void {
    if (robots.count > this.indexed) this.addIndices(Math.max(robots.count, this.indexed * 2));
    if (robots.share < 1 && robots.version !== this.versionBefore) {
      this.uploadRecords(1, robots.wordsBefore, robots.count);
      this.versionBefore = robots.version;
    }
    if (robots.version === this.version) return;
    this.version = robots.version;
    this.uploadRecords(0, robots.words, robots.count);
  }

  private uploadRecords(which: 0 | 1, words: Uint32Array, count: number): void {
    const { gl } = this;
    const rows = Math.ceil(count / kTableWidth);
    gl.activeTexture(gl.TEXTURE0 + (which === 0 ? 0 : kBefore));
    const [format, type] = [gl.RGBA_INTEGER, gl.UNSIGNED_INT];
    if (rows > this.rows[which]!) {
      this.rows[which] = rows;
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32UI, kTableWidth, rows, 0, format, type, words);
    } else {
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, kTableWidth, rows, format, type, words);
    }
  }

  private addIndices(robots: number): void {
    const { gl } = this;
    const { corners, indices } = this.mesh;
    const all = new Uint32Array(robots * indices.length);
    for (let robot = 0; robot < robots; ++robot) {
      for (let i = 0; i < indices.length; ++i) all[robot * indices.length + i] = robot * corners.length + indices[i]!;
    }
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, all, gl.STATIC_DRAW);
    this.indexed = robots;
  }

  private uploadStyles(styles: RobotStyles): void {
    if (styles.version === this.stylesVersion) return;
    this.stylesVersion = styles.version;
    const { gl } = this;
    const rows = styles.capacity / kTableWidth;
    gl.activeTexture(gl.TEXTURE1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, kTableWidth, rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, styles.colors);
    gl.activeTexture(gl.TEXTURE2);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RG32F, kTableWidth, rows, 0, gl.RG, gl.FLOAT, styles.sizes);
  }
}

function shares(color: string): [number, number, number] {
  const { r, g, b } = parseColor(color)!;
  return [r / 255, g / 255, b / 255];
}

function link(gl: WebGL2RenderingContext, vertex: string, fragment: string): Program {
  const program = gl.createProgram();
  for (const [type, text] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(type)!;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    const texts = (gl.getAttachedShaders(program) ?? []).map((shader) => gl.getShaderInfoLog(shader));
    throw new Error(`the map's shaders don't link: ${gl.getProgramInfoLog(program)} ${texts.join(" ")}`);
  }
  const uniforms = Object.fromEntries(kUniforms.map((name) => [name, gl.getUniformLocation(program, name)]));
  return { program, uniforms: uniforms as Program["uniforms"] };
}
