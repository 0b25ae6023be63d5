// Whether a graphics card draws, or a processor that plays one.

/** Names that mean a processor. */
export function isSoftwareName(name: string): boolean {
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/** What the browser calls who draws; "" where it doesn't say. */
export function rendererName(gl: WebGL2RenderingContext): string {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER) ?? "");
}

let known: boolean | undefined;

/** True too where there is no WebGL2. Found out once a page. */
export function drawsInSoftware(): boolean {
  if (known === undefined) {
    const gl = document.createElement("canvas").getContext("webgl2");
    known = !gl || isSoftwareName(rendererName(gl));
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
  }
  return known;
}

/**
 * For drawing in two dimensions. Where a processor draws, the picture stays in main memory: going through what plays
 * the graphics card is many times slower.
 */
export function pen2d(canvas: HTMLCanvasElement): CanvasRenderingContext2D | null {
  return canvas.getContext("2d", { willReadFrequently: drawsInSoftware() });
}
