// Runs tests/browser: the operator console in a real browser, served by a real mlab. MLAB_COMMAND is that mlab; what
// else is given goes to vitest (`npm run browser -- reload`).
import { spawnSync } from "node:child_process";
import { existsSync, symlinkSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const root = dirname(web);
const command = process.env.MLAB_COMMAND ?? join(root, "build", "test", "bin", "mlab");
if (!existsSync(command)) {
  console.error(`browser tests: there is no ${command}; MLAB_COMMAND=FILE says where mlab is`);
  process.exit(2);
}
// The tests stand outside of this folder, and find its packages through this.
const packages = join(root, "node_modules");
if (!existsSync(packages)) symlinkSync(join("web", "node_modules"), packages);

/** Ends where it fails. */
function run(program, ...options) {
  const result = spawnSync(process.execPath, [join(web, "node_modules", program), ...options], {
    cwd: web,
    stdio: "inherit",
    env: { ...process.env, MLAB_COMMAND: command },
  });
  if (result.status !== 0) process.exit(result.status ?? 1);
}

const tests = join(root, "tests", "browser");
run(join("typescript", "bin", "tsc"), "-p", join(tests, "tsconfig.json"));
run(join("@biomejs", "biome", "bin", "biome"), "check", "--config-path", web, tests);
run(join("vitest", "vitest.mjs"), "run", "--config", join(tests, "vitest.config.mts"), ...process.argv.slice(2));
