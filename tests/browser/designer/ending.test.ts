// Ctrl-C ends the designer at once, also while a C++ compiler is at work for it.
import {
  chmodSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, onTestFinished, test } from "vitest";
import { Project } from "../begin.ts";
import { Mlab } from "../mlab.ts";

const kProcedures = `procedure Vector Push with
  double strength = 1;
header
body
  output = {strength, 0};
pend
`;
const kUses = 'use "mine.cnl";\n\nassemblage One() {\n  Push(strength = 0.5)\n}\n';

test("ending does not wait for a compiler, which goes with all of its files", async () => {
  const project = new Project("");
  const folder = mkdtempSync(join(tmpdir(), "mlab-slow-"));
  const { PATH, XDG_CACHE_HOME } = process.env;
  onTestFinished(() => {
    Object.assign(process.env, { PATH, XDG_CACHE_HOME });
    if (XDG_CACHE_HOME === undefined) delete process.env.XDG_CACHE_HOME;
    project.remove();
    rmSync(folder, { recursive: true, force: true });
  });
  project.write("mine.cnl", kProcedures);
  project.write("one.cdl", kUses);
  const started = join(folder, "started");
  const own = join(folder, "own");
  const script = `#!/bin/sh\ntrap 'rm ${own}; exit 1' TERM\necho x > ${own}\necho $$ > ${started}\nsleep 300 &\nwait\n`;
  mkdirSync(join(folder, "bin"));
  writeFileSync(join(folder, "bin", "g++"), script);
  chmodSync(join(folder, "bin", "g++"), 0o755);
  process.env.PATH = `${join(folder, "bin")}:${PATH}`;
  process.env.XDG_CACHE_HOME = join(folder, "cache");
  const mlab = await Mlab.edit([project.path("one.cdl"), "--project", project.folder]);
  await expect.poll(() => existsSync(started) && readFileSync(started, "utf8") !== "", { timeout: 60_000 }).toBe(true);
  const compiler = Number(readFileSync(started, "utf8"));
  const begin = performance.now();
  expect(await mlab.stop()).toBe(0);
  expect(performance.now() - begin).toBeLessThan(10_000);
  expect(() => process.kill(compiler, 0)).toThrow();
  expect(existsSync(own)).toBe(false);
  const left = readdirSync(join(folder, "cache"), { recursive: true, withFileTypes: true });
  expect(left.filter((one) => one.isFile()).map(({ name }) => name)).toEqual([]);
});
