// What is told, as people read it.
import { readableMessage } from "./format.ts";

/** First letter large, but for the name of a file; a full stop at the end. `words`: what becomes of marks of code. */
export function sentence(text: string, words: (text: string) => string = readableMessage): string {
  const trimmed = words(text).trim();
  if (trimmed === "") return "";
  const isFile = /^\S*[./_]\S/.test(trimmed);
  const capital = isFile ? trimmed : trimmed.charAt(0).toUpperCase() + trimmed.slice(1);
  return /[.!?…]$/.test(trimmed) ? capital : `${capital}.`;
}

/** Names without the backticks around them. */
export function withoutBackticks(text: string): string {
  return text.replaceAll("`", "");
}
