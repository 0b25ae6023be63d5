// The browser of the whole run: to start one costs more than most tests.
import type { TestProject } from "vitest/node";
import { serveBrowser } from "../../web/tools/browser.mjs";

declare module "vitest" {
  export interface ProvidedContext {
    browser: string;
  }
}

export default async function setup(project: TestProject): Promise<() => Promise<void>> {
  const { address, close } = await serveBrowser();
  project.provide("browser", address);
  return close;
}
