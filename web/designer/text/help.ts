// Documentation as the server writes it, in Markdown, as elements of the page.
import MarkdownIt from "markdown-it";

// Nothing in it leads elsewhere or is loaded: what looks like HTML, a link or a picture is text.
const reader = new MarkdownIt({ html: false }).disable(["link", "image", "autolink"]);

/** Columns of tables that say nothing below their head are left out. */
export function helpElement(markdown: string, page: Document): HTMLElement {
  const element = page.createElement("div");
  element.innerHTML = reader.render(markdown);
  for (const table of element.querySelectorAll("table")) leaveOutEmpty(table);
  return element;
}

function leaveOutEmpty(table: HTMLTableElement): void {
  const rows = [...table.rows];
  const isEmpty = [...(rows[0]?.cells ?? [])].map((_, column) =>
    rows.slice(1).every((row) => (row.cells[column]?.textContent ?? "") === ""),
  );
  for (const row of rows) for (const [column, cell] of [...row.cells].entries()) if (isEmpty[column]) cell.remove();
}
