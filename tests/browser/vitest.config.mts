import { defineConfig } from "vitest/config";

// One after the other: each test has an mlab and a page of its own, which want the whole machine.
export default defineConfig({
  root: import.meta.dirname,
  test: {
    environment: "node",
    globalSetup: "./one_browser.ts",
    include: ["**/*.test.ts"],
    fileParallelism: false,
    testTimeout: 120_000,
    hookTimeout: 60_000,
    expect: { poll: { timeout: 30_000 } },
  },
});
