// The protocol counts bytes of UTF-8, the editor UTF-16 code units.

/** Bytes of UTF-8 of the first `units` code units of `text`. */
export function bytesOf(text: string, units: number): number {
  let bytes = 0;
  const end = Math.min(units, text.length);
  for (let i = 0; i < end; i++) {
    const code = text.charCodeAt(i);
    if (code < 0x80) bytes += 1;
    else if (code < 0x800) bytes += 2;
    else if (code >= 0xd800 && code < 0xdc00 && isLow(text, i + 1)) {
      if (i + 1 >= end) break; // the cut is inside of a character: it counts from where that begins
      bytes += 4;
      i++;
    } else bytes += 3;
  }
  return bytes;
}

/** Code units that take `bytes` bytes of UTF-8; inside of a character: where that begins. */
export function unitsOf(text: string, bytes: number): number {
  let at = 0;
  let i = 0;
  while (i < text.length) {
    const code = text.charCodeAt(i);
    const isPair = code >= 0xd800 && code < 0xdc00 && isLow(text, i + 1);
    const size = code < 0x80 ? 1 : code < 0x800 ? 2 : isPair ? 4 : 3;
    if (at + size > bytes) return i;
    at += size;
    i += isPair ? 2 : 1;
  }
  return text.length;
}

function isLow(text: string, i: number): boolean {
  const code = text.charCodeAt(i);
  return code >= 0xdc00 && code < 0xe000;
}
