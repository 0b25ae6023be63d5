import type { Session } from "./session.ts";

/** Puts a place on the clipboard, and says so. */
export async function copyPlace({ ui }: Session, text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    ui.tell(`Copied: ${text}`, "hold");
  } catch {
    ui.tell("The browser does not let the page write to the clipboard.");
  }
}
