import { defineConfig } from "vite";

// One file that VS Code loads, with everything in it but VS Code itself.
export default defineConfig({
  ssr: { noExternal: true, external: ["vscode"] },
  build: {
    ssr: "src/extension.ts",
    outDir: "dist",
    target: "node20",
    minify: false,
    rollupOptions: { external: ["vscode"], output: { format: "cjs", entryFileNames: "extension.js" } },
  },
});
