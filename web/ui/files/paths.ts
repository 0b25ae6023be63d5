// Paths inside of the project: relative, with `/`, never out of it.

export function folderOf(path: string): string {
  const at = path.lastIndexOf("/");
  return at < 0 ? "" : path.slice(0, at);
}

export function nameOf(path: string): string {
  return path.slice(path.lastIndexOf("/") + 1);
}

export function join(folder: string, name: string): string {
  return folder === "" ? name : `${folder}/${name}`;
}

/** Folders on the way: ``, `a`, `a/b`. */
export function ancestors(folder: string): string[] {
  const parts = folder === "" ? [] : folder.split("/");
  return ["", ...parts.map((_, i) => parts.slice(0, i + 1).join("/"))];
}

/** With the ending where there is none. */
export function withEnding(name: string, ending: string): string {
  const trimmed = name.trim();
  return /\.[A-Za-z0-9]+$/.test(trimmed) ? trimmed : `${trimmed}${ending}`;
}

/** Why a file can't be called so; nothing: it can. */
export function nameProblem(name: string): string | undefined {
  const trimmed = name.trim();
  if (trimmed === "") return "A name is needed.";
  if (/[\\:*?"<>|]/.test(trimmed)) return 'A name has none of \\ : * ? " < > |.';
  if (trimmed.startsWith("/") || trimmed.split("/").some((part) => part === ".." || part === "." || part === "")) {
    return "The file has to be inside of the project.";
  }
  return undefined;
}

/** What a mission is called in lists: its title, or its file's name where it has none. */
export function shownTitle({ path, title }: { path: string; title: string }): string {
  return title !== "" && title !== path
    ? title
    : nameOf(path)
        .replace(/\.[A-Za-z0-9]+$/, "")
        .replaceAll("_", " ");
}

/** Its place, without the mark of examples. */
export function shownPath(path: string): string {
  if (/^new:\d+$/.test(path)) return "not saved yet";
  return path.replace(/^examples:/, "");
}
