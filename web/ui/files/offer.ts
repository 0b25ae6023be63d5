// A file that the page has made, handed to the browser.

const kKept = 10_000; // ms until the browser has surely taken it

/** It goes where the browser puts downloads, under this name. */
export function offer(name: string, content: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), kKept);
}
