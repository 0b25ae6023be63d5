// Robots by the graphics card: one instance each, straight from the frame's records, so that the main thread does the
// same work for ten robots as for ten thousand. Colours and sizes stand in two textures, found by the robot's id.

import type { Camera } from "../camera.ts";
import { parseColor } from "../color.ts";
import { kRecordBytes, type RobotTable } from "../robots.ts";
import type { Palette } from "./palette.ts";
import { kTableWidth, type RobotStyles } from "./robot_styles.ts";

const kVertex = `#version 300 es
precision highp float;
precision highp int;
layout(location = 0) in uint id;
layout(location = 1) in vec2 place;
layout(location = 2) in float turns;
uniform vec2 middle;      // of the screen, world [m]
uniform vec2 halfScreen;  // [CSS px]
uniform float scale;      // [CSS px/m]
uniform float least;      // [CSS px]
uniform float circles;    // 1: a ring round each
uniform sampler2D colors;
uniform sampler2D sizes;
uniform int capacity;
out vec2 at;              // from the robot's middle, robot frame [CSS px]
flat out vec4 color;      // alpha: selected
flat out vec3 extent;     // length, body's radius, ring's radius [CSS px]; ring 0: none
const vec2 kCorners[4] = vec2[4](vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(1, 1));
void main() {
  int index = min(int(id), capacity - 1);
  ivec2 texel = ivec2(index % ${kTableWidth}, index / ${kTableWidth});
  color = texelFetch(colors, texel, 0);
  vec2 size = texelFetch(sizes, texel, 0).rg * scale;
  float length = max(least, size.x);
  float body = size.y < 5.0 ? 0.0 : size.y;
  float ring = color.a > 0.5 ? max(length * 0.62, size.y) + 3.5 : circles > 0.5 ? length * 0.9 + 5.0 : 0.0;
  extent = vec3(length, body, ring);
  float reach = max(max(length * 0.62, body), ring) + 3.0;
  vec2 corner = kCorners[gl_VertexID] * reach;
  at = corner;
  float angle = turns * 6.283185307;
  vec2 turned = vec2(corner.x * cos(angle) - corner.y * sin(angle), corner.x * sin(angle) + corner.y * cos(angle));
  gl_Position = vec4(((place - middle) * scale + turned) / halfScreen, 0.0, 1.0);
}`;

const kFragment = `#version 300 es
precision highp float;
in vec2 at;
flat in vec4 color;
flat in vec3 extent;
uniform vec3 halo;
uniform vec3 selection;
uniform float pixel; // one device pixel [CSS px]
out vec4 result;     // premultiplied
float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }
// Signed distance to the arrow head, negative inside.
float arrow(vec2 p, float length) {
  p.y = abs(p.y);
  vec2 tip = vec2(0.56, 0.0) * length;
  vec2 tail = vec2(-0.44, 0.4) * length;
  vec2 notch = vec2(-0.26, 0.0) * length;
  vec2 e = tail - tip, w = p - tip;
  vec2 a = w - e * clamp(dot(w, e) / dot(e, e), 0.0, 1.0);
  vec2 f = notch - tail, v = p - tail;
  vec2 b = v - f * clamp(dot(v, f) / dot(f, f), 0.0, 1.0);
  float away = sqrt(min(dot(a, a), dot(b, b)));
  bool inside = cross2(e, w) > 0.0 && cross2(f, v) > 0.0;
  return inside ? -away : away;
}
void cover(vec3 paint, float amount) { result = vec4(paint, 1.0) * amount + result * (1.0 - amount); }
float within(float signedDistance) { return clamp(0.5 - signedDistance / pixel, 0.0, 1.0); }
void main() {
  result = vec4(0.0);
  float away = length(at);
  if (extent.y > 0.0) {
    cover(color.rgb, 0.18 * within(away - extent.y));
    cover(color.rgb, 0.7 * within(abs(away - extent.y) - 0.5));
  }
  float shape = arrow(at, extent.x);
  cover(halo, within(shape - 1.0));
  cover(color.rgb, within(shape));
  if (extent.z > 0.0) {
    if (color.a > 0.5) cover(halo, within(abs(away - extent.z) - 2.25));
    bool chosen = color.a > 0.5;
    cover(chosen ? selection : color.rgb, within(abs(away - extent.z) - (chosen ? 1.125 : 0.75)));
  }
  if (result.a < 0.004) discard;
}`;

const kUniforms = [
  "middle",
  "halfScreen",
  "scale",
  "least",
  "circles",
  "colors",
  "sizes",
  "capacity",
  "halo",
  "selection",
  "pixel",
] as const;

export class RobotsByWebgl {
  private readonly uniforms: Record<(typeof kUniforms)[number], WebGLUniformLocation | null>;
  private readonly program: WebGLProgram;
  private readonly buffer: WebGLBuffer;
  private readonly tables: readonly [WebGLTexture, WebGLTexture];
  private room = 0; // records in the buffer
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
    } catch {
      return null;
    }
  }

  private constructor(private readonly gl: WebGL2RenderingContext) {
    this.program = link(gl);
    this.uniforms = Object.fromEntries(
      kUniforms.map((name) => [name, gl.getUniformLocation(this.program, name)]),
    ) as typeof this.uniforms;
    this.buffer = gl.createBuffer();
    this.tables = [gl.createTexture(), gl.createTexture()];
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    for (const place of [0, 1, 2]) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribDivisor(place, 1);
    }
    gl.vertexAttribIPointer(0, 1, gl.UNSIGNED_INT, kRecordBytes, 0);
    gl.vertexAttribPointer(1, 2, gl.FLOAT, false, kRecordBytes, 4);
    gl.vertexAttribPointer(2, 1, gl.UNSIGNED_SHORT, true, kRecordBytes, 12);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  /** Names that mean that a processor draws instead of a graphics card. */
  isSoftware(): boolean {
    const { gl } = this;
    const info = gl.getExtension("WEBGL_debug_renderer_info");
    const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
  }

  get isLost(): boolean {
    return this.gl.isContextLost();
  }

  draw(camera: Camera, robots: RobotTable, styles: RobotStyles, palette: Palette, circles: boolean, density: number) {
    const { gl, uniforms } = this;
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    if (robots.count === 0) return;
    gl.useProgram(this.program);
    this.upload(robots);
    this.uploadStyles(styles);
    gl.uniform2f(uniforms.middle, camera.x, camera.y);
    gl.uniform2f(uniforms.halfScreen, camera.width / 2, camera.height / 2);
    gl.uniform1f(uniforms.scale, camera.scale);
    gl.uniform1f(uniforms.least, styles.least);
    gl.uniform1f(uniforms.circles, circles ? 1 : 0);
    gl.uniform1i(uniforms.capacity, styles.capacity);
    gl.uniform1f(uniforms.pixel, 1 / density);
    gl.uniform3f(uniforms.halo, ...shares(palette.halo));
    gl.uniform3f(uniforms.selection, ...shares(palette.selection));
    gl.uniform1i(uniforms.colors, 0);
    gl.uniform1i(uniforms.sizes, 1);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, robots.count);
  }

  dispose(): void {
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  private upload(robots: RobotTable): void {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    if (robots.count > this.room) {
      this.room = Math.max(robots.count, this.room * 2);
      gl.bufferData(gl.ARRAY_BUFFER, this.room * kRecordBytes, gl.DYNAMIC_DRAW);
    }
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, robots.bytes, 0, robots.count * kRecordBytes);
  }

  private uploadStyles(styles: RobotStyles): void {
    if (styles.version === this.stylesVersion) return;
    this.stylesVersion = styles.version;
    const { gl } = this;
    const rows = styles.capacity / kTableWidth;
    const put = (unit: number, inside: number, format: number, type: number, values: ArrayBufferView): void => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, this.tables[unit]!);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
      gl.texImage2D(gl.TEXTURE_2D, 0, inside, kTableWidth, rows, 0, format, type, values);
    };
    put(0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, styles.colors);
    put(1, gl.RG32F, gl.RG, gl.FLOAT, styles.sizes);
  }
}

function shares(color: string): [number, number, number] {
  const { r, g, b } = parseColor(color)!;
  return [r / 255, g / 255, b / 255];
}

function link(gl: WebGL2RenderingContext): WebGLProgram {
  const program = gl.createProgram();
  for (const [type, text] of [
    [gl.VERTEX_SHADER, kVertex],
    [gl.FRAGMENT_SHADER, kFragment],
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
  return program;
}
