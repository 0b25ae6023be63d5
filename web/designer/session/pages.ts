// Pages of a document: `Forage.Searching` is what stands inside of the state Searching of Forage; empty is the file.

import { type Drawing, Drawing_Kind } from "./protocol.ts";

/** Nothing that does anything stands on it. */
export function isEmptyDrawing({ nodes, states }: Drawing): boolean {
  return nodes.length + states.length === 0;
}

/** Devices that serve binding points stand on it: of a class of robots, or of an operator. */
export function isEquipment({ kind }: Drawing): boolean {
  return kind === Drawing_Kind.CLASS || kind === Drawing_Kind.OPERATOR;
}

/** Everybody's, so nobody can change it. */
export function isOfLibrary(document: string): boolean {
  return document.startsWith("library:");
}

/** The page that encloses this one; none for the file's. */
export function outerPath(path: string): string | undefined {
  if (path === "") return undefined;
  const at = path.lastIndexOf(".");
  return at < 0 ? "" : path.slice(0, at);
}

export function lastPart(path: string): string {
  return path.slice(path.lastIndexOf(".") + 1);
}

/** The declaration in which the page is; empty for the file's. */
export function declarationOf(path: string): string {
  const at = path.indexOf(".");
  return at < 0 ? path : path.slice(0, at);
}

export function innerPath(path: string, name: string): string {
  return path === "" ? name : `${path}.${name}`;
}

/** One key for a page of a document. */
export function pageKey(document: string, path: string): string {
  return `${document}#${path}`;
}

/** Where a link leads. */
export interface Place {
  document: string;
  page: string;
  node: string;
}

/** The fragment of a link: `#file=forager.cdl&page=Forage&node=Noise`. */
export function toFragment({ document, page, node }: Place): string {
  const parts = [`file=${encode(document)}`];
  if (page) parts.push(`page=${encode(page)}`);
  if (node) parts.push(`node=${encode(node)}`);
  return document ? `#${parts.join("&")}` : "";
}

export function fromFragment(fragment: string): Place {
  const query = new URLSearchParams(fragment.replace(/^#/, ""));
  return { document: query.get("file") ?? "", page: query.get("page") ?? "", node: query.get("node") ?? "" };
}

/** Readable: slashes and colons stay. */
function encode(text: string): string {
  return encodeURIComponent(text).replaceAll("%2F", "/").replaceAll("%3A", ":");
}
