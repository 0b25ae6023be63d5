// The browsers of the whole run, one for each worker: to start one costs more than most tests, and what is in the clipboard
// of one is in that of all its pages.
import { chromium } from "playwright-core";
import type { TestProject } from "vitest/node";
import { serveBrowser } from "../../web/tools/browser.mjs";

declare module "vitest" {
  export interface ProvidedContext {
    browsers: string[];
  }
}

export default async function setup(project: TestProject): Promise<() => Promise<void>> {
  const workers = Number(project.vitest.config.maxWorkers);
  const servers = await Promise.all(Array.from({ length: workers }, serveBrowser));
  // Its first page takes many times as long as each that follows: no test has to wait for it.
  for (const { address } of servers) {
    const browser = await chromium.connect(address);
    await (await browser.newPage()).close();
    await browser.close();
  }
  project.provide(
    "browsers",
    servers.map(({ address }) => address),
  );
  return async () => {
    await Promise.all(servers.map(({ close }) => close()));
  };
}
