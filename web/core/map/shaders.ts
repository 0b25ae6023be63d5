// The programs for the graphics card: arrows as plain geometry, rings as smooth circles in squares.
import { kRobotShape, kTableWidth } from "./robot_styles.ts";

const kInstance = `#version 300 es
precision highp float;
precision highp int;
uniform highp usampler2D records; // a frame's, one texel each
uniform highp usampler2D before;  // where the robots were shown when it came; read while share is below 1
uniform float share;      // of their way from there
uniform vec2 middle;      // of the screen, world [m]
uniform vec2 halfScreen;  // [CSS px]
uniform float scale;      // [CSS px/m]
uniform float least;      // [CSS px]
uniform sampler2D colors;
uniform sampler2D sizes;
uniform int capacity;
// Not by instances: a processor that draws takes each as a drawing of its own.
uvec4 record(int row) { return texelFetch(records, ivec2(row % ${kTableWidth}, row / ${kTableWidth}), 0); }
uvec4 recordBefore(int row) {
  ivec2 at = ivec2(row % ${kTableWidth}, row / ${kTableWidth});
  return share < 1.0 ? texelFetch(before, at, 0) : texelFetch(records, at, 0);
}
ivec2 texel(uvec4 robot) {
  int index = min(int(robot.x), capacity - 1);
  return ivec2(index % ${kTableWidth}, index / ${kTableWidth});
}
vec4 onScreen(uvec4 robot, uvec4 was, vec2 fromRobot) {
  vec2 place = mix(uintBitsToFloat(was.yz), uintBitsToFloat(robot.yz), share);
  return vec4(((place - middle) * scale + fromRobot) / halfScreen, 0.0, 1.0);
}
`;

export function arrowVertex(): string {
  const { corners, layers } = arrowMesh();
  const list = (type: string, values: readonly (readonly number[])[]): string =>
    `${type}[${values.length}](${values.map((one) => `${type}(${one.map((value) => value.toFixed(6)).join(",")})`).join(",")})`;
  return `${kInstance}
// x, y of the shape of length 1, and the outward step of its edge
const vec4 kCorners[${corners.length}] = ${list("vec4", corners)};
// outward step [px], coverage, 1 of the body and 0 of the halo
const vec3 kLayers[${layers.length}] = ${list("vec3", layers)};
uniform vec3 halo;
uniform float pixel; // one device pixel [CSS px]
flat out vec3 paint;
out float cover;
void main() {
  uvec4 robot = record(gl_VertexID / ${corners.length});
  uvec4 was = recordBefore(gl_VertexID / ${corners.length});
  vec4 corner = kCorners[gl_VertexID % ${corners.length}];
  vec3 layer = kLayers[gl_VertexID % ${layers.length}];
  float length = max(least, texelFetch(sizes, texel(robot), 0).r * scale);
  vec2 at = corner.xy * length + corner.zw * layer.x * (layer.z > 0.5 ? pixel : 1.0);
  float from = float(was.w & 0xffffu);
  float turn = mod(float(robot.w & 0xffffu) - from + 32768.0, 65536.0) - 32768.0; // the shorter way round
  float angle = (from + turn * share) * ${((2 * Math.PI) / 65536).toExponential(9)};
  float c = cos(angle);
  float s = sin(angle);
  paint = layer.z > 0.5 ? texelFetch(colors, texel(robot), 0).rgb : halo;
  cover = layer.y;
  gl_Position = onScreen(robot, was, vec2(at.x * c - at.y * s, at.x * s + at.y * c));
}`;
}

export const kArrowFragment = `#version 300 es
precision mediump float;
flat in vec3 paint;
in float cover;
out vec4 result; // premultiplied
void main() { result = vec4(paint * cover, cover); }`;

/** The body's true extent, the ring round a selected robot, the ring round each. */
export const kRingVertex = `${kInstance}
uniform float circles;
out vec2 at;
flat out vec4 paint;
flat out vec2 extent; // body's radius, ring's radius [CSS px]; 0: none
const vec2 kCorners[6] = vec2[6](vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(-1, 1), vec2(1, -1), vec2(1, 1));
void main() {
  uvec4 robot = record(gl_VertexID / 6);
  paint = texelFetch(colors, texel(robot), 0);
  vec2 size = texelFetch(sizes, texel(robot), 0).rg * scale;
  float length = max(least, size.x);
  float body = size.y < 5.0 ? 0.0 : size.y;
  float ring = paint.a > 0.5 ? max(length * 0.62, size.y) + 3.5 : circles > 0.5 ? length * 0.9 + 5.0 : 0.0;
  extent = vec2(body, ring);
  float reach = max(body, ring);
  at = kCorners[gl_VertexID % 6] * (reach > 0.0 ? reach + 3.0 : 0.0);
  gl_Position = onScreen(robot, recordBefore(gl_VertexID / 6), at);
}`;

export const kRingFragment = `#version 300 es
precision highp float;
in vec2 at;
flat in vec4 paint;
flat in vec2 extent;
uniform vec3 halo;
uniform vec3 selection;
uniform float pixel;
out vec4 result; // premultiplied
void cover(vec3 color, float amount) { result = vec4(color, 1.0) * amount + result * (1.0 - amount); }
float within(float signedDistance) { return clamp(0.5 - signedDistance / pixel, 0.0, 1.0); }
void main() {
  result = vec4(0.0);
  float away = length(at);
  if (extent.x > 0.0) {
    cover(paint.rgb, 0.18 * within(away - extent.x));
    cover(paint.rgb, 0.7 * within(abs(away - extent.x) - 0.5));
  }
  if (extent.y > 0.0) {
    bool chosen = paint.a > 0.5;
    if (chosen) cover(halo, within(abs(away - extent.y) - 2.25));
    cover(chosen ? selection : paint.rgb, within(abs(away - extent.y) - (chosen ? 1.125 : 0.75)));
  }
}`;

/**
 * The arrow as triangles: a halo, then the body, each a kite with a fringe in which its colour fades, so that edges are
 * smooth without help of the card.
 */
export function arrowMesh(): {
  corners: readonly (readonly number[])[];
  layers: readonly (readonly number[])[];
  indices: readonly number[];
} {
  const corners: number[][] = [];
  const layers: number[][] = [];
  const indices: number[] = [];
  const outward = kRobotShape.map((_, i) => mitre(i));
  // Steps are in CSS pixels for the halo, in device pixels for the body.
  for (const [inner, outer, body] of [
    [0.8, 1.6, 0],
    [-0.5, 0.5, 1],
  ] as const) {
    const first = corners.length;
    for (const [step, cover] of [
      [inner, 1],
      [outer, 0],
    ] as const) {
      kRobotShape.forEach(([x, y], i) => {
        corners.push([x, y, ...outward[i]!]);
        layers.push([step, cover, body]);
      });
    }
    const at = (i: number): number => first + (i % 4);
    indices.push(at(0), at(1), at(2), at(0), at(2), at(3));
    for (let i = 0; i < 4; ++i) {
      indices.push(at(i), at(i) + 4, at(i + 1), at(i + 1), at(i) + 4, at(i + 1) + 4);
    }
  }
  return { corners, layers, indices };
}

/** How a corner moves when both of its edges move outward by 1; at most twice as far, so that the tip is no needle. */
function mitre(i: number): [number, number] {
  const [before, here, after] = [kRobotShape[(i + 3) % 4]!, kRobotShape[i]!, kRobotShape[(i + 1) % 4]!];
  const first = outwardNormal(before, here);
  const second = outwardNormal(here, after);
  const x = first[0] + second[0];
  const y = first[1] + second[1];
  const square = Math.max(x * x + y * y, 1e-6);
  const factor = Math.min(2 / square, 2 / Math.sqrt(square));
  return [x * factor, y * factor];
}

/** The shape runs counter-clockwise: outward is to the right. */
function outwardNormal(a: readonly [number, number], b: readonly [number, number]): [number, number] {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  return [(b[1] - a[1]) / length, -(b[0] - a[0]) / length];
}
