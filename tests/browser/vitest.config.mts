import { availableParallelism } from "node:os";
import { defineConfig } from "vitest/config";

// Each test has an mlab and a page of its own. Most of the time it waits for them, so that files of tests run side by side.
export default defineConfig({
  root: import.meta.dirname,
  test: {
    environment: "node",
    globalSetup: "./one_browser.ts",
    include: ["**/*.test.ts"],
    maxWorkers: Math.min(4, availableParallelism()),
    testTimeout: 300_000,
    hookTimeout: 120_000,
    expect: { poll: { timeout: 90_000 } },
  },
});
