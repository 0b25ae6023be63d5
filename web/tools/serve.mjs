// Serves the web folder's own pages, for tests that need no mlab.
import { createServer } from "vite";

/** @param {string} root  the web folder */
export async function serve(root) {
  const server = await createServer({ root, server: { port: 0, host: "127.0.0.1", watch: null }, logLevel: "error" });
  await server.listen();
  return { address: server.resolvedUrls.local[0], close: () => server.close() };
}
