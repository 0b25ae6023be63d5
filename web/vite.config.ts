import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";
import { licences } from "./tools/licences.ts";

// `npm run dev` shows the page beside a running `mlab run`: MLAB_SERVER is the address that it printed.
const server = process.env.MLAB_SERVER ?? "http://127.0.0.1:8080";
const inside = licences();
const handedOn = { target: server, changeOrigin: true };

export default defineConfig({
  base: "./",
  plugins: [react(), inside.page],
  build: {
    outDir: "dist",
    target: "es2022",
    // elk is large, and loaded only when it is to lay something out.
    chunkSizeWarningLimit: 1600,
    rolldownOptions: { input: { index: "index.html", designer: "designer.html" } },
  },
  worker: { format: "es", plugins: () => [inside.worker] }, // loads elk when it needs it
  server: {
    host: "127.0.0.1",
    proxy: {
      "/session": { ...handedOn, ws: true, rewriteWsOrigin: true },
      "/designer": {
        ...handedOn,
        ws: true,
        rewriteWsOrigin: true,
        bypass: (request) => (request.url?.startsWith("/designer?") ? undefined : request.url),
      },
      "/picture": handedOn,
      "/stop": handedOn,
      "/report": handedOn,
    },
  },
  test: {
    // Property tests take their time where several programs share a slow processor.
    testTimeout: 30_000,
    // The core needs no page, and starts many times faster without one.
    projects: [
      { extends: true, test: { name: "core", environment: "node", include: ["core/**/*.test.ts"] } },
      { extends: true, test: { name: "ui", environment: "happy-dom", include: ["ui/**/*.test.{ts,tsx}"] } },
      { extends: true, test: { name: "console", environment: "happy-dom", include: ["console/**/*.test.{ts,tsx}"] } },
      {
        extends: true,
        test: { name: "designer", environment: "happy-dom", include: ["designer/**/*.test.{ts,tsx}"] },
      },
      {
        extends: true,
        test: { name: "edit", environment: "happy-dom", include: ["edit/**/*.test.{ts,tsx}"] },
      },
      {
        extends: true,
        test: {
          name: "browser",
          environment: "node",
          include: ["tests/**/*.browser.test.mjs"],
          testTimeout: 120_000,
          hookTimeout: 120_000,
          fileParallelism: false,
        },
      },
    ],
  },
});
