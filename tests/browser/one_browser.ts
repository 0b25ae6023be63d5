// The browser of the whole run: to start one costs more than most tests.
import { chromium } from "playwright-core";
import type { TestProject } from "vitest/node";
import { serveBrowser } from "../../web/tools/browser.mjs";

declare module "vitest" {
  export interface ProvidedContext {
    browser: string;
  }
}

export default async function setup(project: TestProject): Promise<() => Promise<void>> {
  const { address, close } = await serveBrowser();
  // Its first page takes many times as long as each that follows: no test has to wait for it.
  const browser = await chromium.connect(address);
  await (await browser.newPage()).close();
  await browser.close();
  project.provide("browser", address);
  return close;
}
