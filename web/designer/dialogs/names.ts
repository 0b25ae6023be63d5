/** Why something can't be called so in CDL; nothing: it can. */
export function cdlName(name: string): string | undefined {
  const trimmed = name.trim();
  if (trimmed === "") return "A name is needed.";
  if (!/^[A-Za-z_]/.test(trimmed)) return "A name begins with a letter.";
  if (!/^\w+$/.test(trimmed)) return "A name has letters, digits and _ only.";
  return undefined;
}
