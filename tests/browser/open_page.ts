// A page with storage of its own, as in a browser of its own.
import { type Browser, chromium, type Page } from "playwright-core";
import { afterAll, inject } from "vitest";

export const kSmall = { width: 1280, height: 800 };

let browser: Promise<Browser> | undefined;

afterAll(async () => {
  await (await browser)?.close();
  browser = undefined;
});

/** Whoever opens it closes its context. */
export async function openPage(viewport = kSmall): Promise<Page> {
  browser ??= chromium.connect(inject("browser"));
  const context = await (await browser).newContext({ viewport });
  const page = await context.newPage();
  page.setDefaultTimeout(30_000);
  return page;
}
