import * as path from "node:path";

/**
 * The program that the setting `missionlab.path` means. A plain name is looked for in PATH, `~/` is the home folder, a
 * relative path starts at the workspace's folder.
 */
export function commandOf(setting: string, workspace: string | undefined, home: string): string {
  const wanted = setting.trim() === "" ? "mlab" : setting.trim();
  if (wanted.startsWith("~/")) return path.join(home, wanted.slice(2));
  const isPlain = !wanted.includes("/") && !wanted.includes("\\");
  if (isPlain || path.isAbsolute(wanted)) return wanted;
  return workspace === undefined ? wanted : path.join(workspace, wanted);
}
