import { execFileSync } from "node:child_process";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";

const folder = process.env.MLAB_TOUR ?? "";

export const arePicturesWanted = folder !== "";

/** Waits, where pictures are wanted, until there is more to be seen on them [ms]. */
export async function untilThereIsMore(page: Page, time: number): Promise<void> {
  if (arePicturesWanted) await page.waitForTimeout(time);
}

interface PictureOptions {
  pointerStays?: boolean;
  /** What the file's name begins with. */
  of?: string;
}

/** Writes what the page shows as console_NAME.png, where pictures are wanted. Small with pngquant at hand. */
export async function picture(page: Page, name: string, options: PictureOptions = {}): Promise<void> {
  const { pointerStays = false, of = "console" } = options;
  if (!arePicturesWanted) return;
  mkdirSync(folder, { recursive: true });
  const path = join(folder, `${of}_${name}.png`);
  if (!pointerStays) await page.mouse.move(640, 799); // where nothing answers to it
  await page.waitForTimeout(700);
  await page.screenshot({ path, animations: "disabled", caret: "hide" });
  try {
    execFileSync("pngquant", ["--force", "--ext", ".png", "--speed", "1", "--strip", "128", path]);
  } catch {
    console.warn(`${path}: as large as it came; pngquant makes it a third`);
  }
}
