// What documents are called.
import type { Document } from "./protocol.ts";

/** A document that has no file yet. */
export function isNew(path: string): boolean {
  return /^new:\d+$/.test(path);
}

/** What a document is called: its file's name; without a file as the server calls it. */
export function nameOf(document: Document): string {
  return document.title || titleOf(document.path);
}

/** What a file is called. */
export function titleOf(path: string): string {
  if (isNew(path)) return "New configuration";
  return path.slice(Math.max(path.lastIndexOf("/"), path.lastIndexOf(":")) + 1);
}
