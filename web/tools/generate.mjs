// Writes the TypeScript of the protocol into generated/, where that is older than the definition.
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readdirSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const definitions = join(web, "..", "proto");
const generated = join(web, "generated");

const messages = readdirSync(join(definitions, "mlab")).filter((file) => /^(console|designer|names)/.test(file));
for (const name of messages.map((file) => file.replace(/\.proto$/, ""))) {
  const definition = join(definitions, "mlab", `${name}.proto`);
  const result = join(generated, "mlab", `${name}_pb.ts`);
  if (existsSync(result) && statSync(result).mtimeMs >= statSync(definition).mtimeMs) continue;
  mkdirSync(generated, { recursive: true });
  const plugin = join(web, "node_modules", ".bin", "protoc-gen-es");
  execFileSync(
    "protoc",
    [`--plugin=protoc-gen-es=${plugin}`, `--es_out=${generated}`, "--es_opt=target=ts", `-I${definitions}`, definition],
    { stdio: "inherit" },
  );
}
