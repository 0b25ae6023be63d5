// Ctrl-C ends the designer at once, also while a C++ compiler is at work for it.
import { chmodSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
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
// Writes its number beside what it is to compile: a compiler may write nowhere else.
const kSlowCompiler = `#!/bin/sh
for text; do :; done
echo $$ > "$(dirname "$text")/process"
sleep 300 &
wait
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
  mkdirSync(join(folder, "bin"));
  writeFileSync(join(folder, "bin", "g++"), kSlowCompiler);
  chmodSync(join(folder, "bin", "g++"), 0o755);
  process.env.PATH = `${join(folder, "bin")}:${PATH}`;
  process.env.XDG_CACHE_HOME = join(folder, "cache");
  const mlab = await Mlab.edit([project.path("one.cdl"), "--project", project.folder]);
  const files = (): string[] =>
    readdirSync(join(folder, "cache"), { recursive: true, withFileTypes: true })
      .filter((one) => one.isFile())
      .map((one) => join(one.parentPath, one.name));
  const written = (): string =>
    files()
      .filter((path) => basename(path) === "process")
      .map((path) => readFileSync(path, "utf8"))
      .join("");
  await expect.poll(written, { timeout: 60_000 }).toMatch(/^\d+\n$/);
  const compiler = Number(written());
  const begin = performance.now();
  expect(await mlab.stop()).toBe(0);
  expect(performance.now() - begin).toBeLessThan(10_000);
  expect(() => process.kill(compiler, 0)).toThrow();
  expect(files()).toEqual([]);
});
