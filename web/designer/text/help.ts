// Documentation as the server writes it (paragraphs, code, tables of Markdown) as elements of the page.

export type Block =
  | { kind: "text"; text: string }
  | { kind: "code"; text: string }
  | { kind: "table"; rows: string[][] };

export function blocksOf(markdown: string): Block[] {
  const blocks: Block[] = [];
  // A fence holds empty lines as well.
  for (const [i, part] of markdown.split(/^```\w*\n?/m).entries()) {
    if (i % 2 === 1) {
      if (part.trim() !== "") blocks.push({ kind: "code", text: part.trimEnd() });
      continue;
    }
    for (const paragraph of part.split(/\n{2,}/)) {
      const text = paragraph.trim();
      if (text !== "") blocks.push(tableOf(text) ?? { kind: "text", text: plain(text) });
    }
  }
  return blocks;
}

/** The first row has the names of the columns; those that say nothing in any other are left out. */
function tableOf(text: string): Block | undefined {
  const lines = text.split("\n");
  if (lines.length < 3 || !/^\|[\s:|-]+\|$/.test(lines[1]!.trim())) return undefined;
  const rows = [lines[0]!, ...lines.slice(2)].map((line) =>
    line
      .trim()
      .replace(/^\||\|$/g, "")
      .split("|")
      .map((cell) => plain(cell)),
  );
  const isSaid = rows[0]!.map((_, column) => rows.slice(1).some((row) => (row[column] ?? "") !== ""));
  return { kind: "table", rows: rows.map((row) => row.filter((_, column) => isSaid[column])) };
}

function plain(markdown: string): string {
  return markdown
    .replaceAll(/\*\*([^*]+)\*\*/g, "$1")
    .replaceAll(/`([^`]+)`/g, "$1")
    .trim();
}

export function elementOf(block: Block, page: Document): HTMLElement {
  if (block.kind === "table") return tableElement(block.rows, page);
  const element = page.createElement(block.kind === "code" ? "pre" : "p");
  element.textContent = block.text;
  return element;
}

function tableElement(rows: readonly string[][], page: Document): HTMLElement {
  const table = page.createElement("table");
  for (const [i, row] of rows.entries()) {
    const line = table.insertRow();
    for (const cell of row) {
      const element = page.createElement(i === 0 ? "th" : "td");
      element.textContent = cell;
      line.append(element);
    }
  }
  return table;
}
