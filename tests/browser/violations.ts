import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Page } from "playwright-core";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const kOfColours = ["color-contrast", "link-in-text-block"];

interface Violation {
  id: string;
  help: string;
  nodes: { html: string }[];
}

/**
 * What axe finds wrong with a page as it stands, in words that begin with the view's name. All of its rules are asked in light; in
 * dark those about colours, since nothing else differs.
 */
export async function violations(page: Page, view: string, colours: "light" | "dark" = "light"): Promise<string[]> {
  // Not by a script element: the page's content security policy allows none.
  await page.evaluate(`if (!window.axe) { ${axe} }`);
  const found = await page.evaluate(
    (only) => {
      const { axe } = window as unknown as { axe: { run(options: object): Promise<{ violations: Violation[] }> } };
      const options = { resultTypes: ["violations"], ...(only && { runOnly: only }) };
      return axe.run(options).then((result) => result.violations);
    },
    colours === "dark" ? kOfColours : null,
  );
  return found.map(({ id, help, nodes }) => `${view}: ${id}: ${help}: ${nodes.map((node) => node.html).join(" ")}`);
}
