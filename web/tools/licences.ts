// Plugins of Vite that write beside the page which packages are inside of it, each with its licence, as the licences ask
// for.
import fs from "node:fs";
import path from "node:path";
import type { Plugin } from "vite";

/** The folder of the package that a module belongs to; undefined for our own. */
function packageFolder(module: string): string | undefined {
  const file = module.replace(/^\0+/, "").split("?")[0] ?? "";
  const at = file.lastIndexOf("/node_modules/");
  if (at < 0) return undefined;
  const [first = "", second] = file.slice(at + "/node_modules/".length).split("/");
  return path.join(file.slice(0, at), "node_modules", first.startsWith("@") ? `${first}/${second}` : first);
}

function textOf(field: string | Record<string, string> | undefined, key: string): string | undefined {
  return typeof field === "string" ? field : field?.[key];
}

/** What a package says of its licence. Fails where it says nothing: such a package must not be in the page. */
export function notice(folder: string): string {
  const about = JSON.parse(fs.readFileSync(path.join(folder, "package.json"), "utf8"));
  const texts = fs
    .readdirSync(folder)
    .filter((name) => /^(licen[cs]e|copying|notice)/i.test(name))
    .sort()
    .map((name) => fs.readFileSync(path.join(folder, name), "utf8").trim());
  const licence = textOf(about.license, "type");
  const author = textOf(about.author, "name");
  const source = textOf(about.repository, "url");
  if (!licence && texts.length === 0) throw new Error(`${about.name} says nothing about its licence`);
  const head = [`${about.name} ${about.version}`];
  if (licence) head.push(`Licence: ${licence}`);
  if (author) head.push(`Author: ${author}`);
  if (source) head.push(`Source: ${source}`);
  return `${head.join("\n")}\n\n${texts.length > 0 ? texts.join("\n\n") : "(The package holds no text of its licence.)"}\n`;
}

/** For the page, and for its workers, which are bundled by themselves and before it. */
export function licences(): { page: Plugin; worker: Plugin } {
  const notices = new Map<string, string>();
  const transform = (_: string, module: string) => {
    const folder = packageFolder(module);
    if (folder && !notices.has(folder)) notices.set(folder, notice(folder));
    return null;
  };
  const page: Plugin = {
    name: "licences",
    apply: "build",
    transform,
    generateBundle() {
      const line = `\n${"-".repeat(80)}\n\n`;
      const all = [...notices.values()].sort().join(line);
      this.emitFile({
        type: "asset",
        fileName: "third_party_licences.txt",
        source: `What the pages of the console and the designer hold of others\n${line}${all}`,
      });
    },
  };
  return { page, worker: { name: "licences of workers", apply: "build", transform } };
}
