import { defineConfig } from "vitest/config";

// One after the other: each test has a browser and an mlab of its own, which want the whole machine.
export default defineConfig({
  root: import.meta.dirname,
  test: {
    environment: "node",
    include: ["**/*.test.ts"],
    fileParallelism: false,
    testTimeout: 120_000,
    hookTimeout: 60_000,
  },
});
