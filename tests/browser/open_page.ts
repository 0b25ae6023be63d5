// A page with storage of its own, as in a browser of its own.
import { type Browser, chromium, type Page } from "playwright-core";
import { afterAll, inject } from "vitest";

/** What a busy machine may take for what it does at once when it has nothing else to do [ms]. */
export const kPatience = 90_000;

export const kSmall = { width: 1280, height: 800 };

let browser: Promise<Browser> | undefined;

afterAll(async () => {
  await (await browser)?.close();
  browser = undefined;
});

/**
 * Whoever opens it closes its context.
 *
 * MLAB_SLOWDOWN=4 in the environment gives each page a quarter of the machine's speed: a rehearsal for slow machines.
 */
export async function openPage(viewport = kSmall): Promise<Page> {
  const addresses = inject("browsers");
  browser ??= chromium.connect(addresses[Number(process.env.VITEST_POOL_ID ?? 0) % addresses.length]!);
  const context = await (await browser).newContext({ viewport });
  const page = await context.newPage();
  page.setDefaultTimeout(kPatience);
  const rate = Number(process.env.MLAB_SLOWDOWN ?? 1);
  if (rate > 1) await (await context.newCDPSession(page)).send("Emulation.setCPUThrottlingRate", { rate });
  return page;
}
