// A headless Chromium as every test wants it, with a profile of its own that goes when it ends.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

/** Without a browser's own windows it takes a quarter less of the processor. */
const kBrowser = process.env.CHROMIUM ?? "/usr/bin/chromium-headless-shell";

const kArguments = [
  "--headless",
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** One browser for many: who connects to `address` gets contexts of its own, which end with the connection. */
export async function serveBrowser() {
  const server = await chromium.launchServer({
    executablePath: kBrowser,
    args: [...kArguments, "--disable-gpu"],
  });
  return { address: server.wsEndpoint(), close: () => server.close() };
}

/** @param {{ withGl?: boolean }} [options] `withGl`: WebGL by SwiftShader, else none */
export async function openBrowser({ withGl = false } = {}) {
  const profile = mkdtempSync(join(tmpdir(), "mlab-browser-"));
  const gl = withGl
    ? (process.env.MLAB_GL ?? "--use-angle=swiftshader --enable-unsafe-swiftshader").split(" ")
    : ["--disable-gpu"];
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: kBrowser,
    args: [...kArguments, ...gl],
    viewport: null,
  });
  return {
    /** @param {{ width: number, height: number, density?: number }} size */
    async page({ width, height, density = 1 }) {
      const page = await context.newPage();
      const session = await context.newCDPSession(page);
      await session.send("Emulation.setDeviceMetricsOverride", {
        width,
        height,
        deviceScaleFactor: density,
        mobile: false,
      });
      return page;
    },
    async close() {
      await context.close();
      rmSync(profile, { recursive: true, force: true });
    },
  };
}
