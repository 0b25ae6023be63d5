/** What somebody typed for a number, and why it is none that may stand there. */
export interface ReadNumber {
  number: number;
  problem: string | undefined;
}

export function readNumber(
  text: string,
  min = Number.NEGATIVE_INFINITY,
  max = Number.POSITIVE_INFINITY,
  isOptional = false,
): ReadNumber {
  const trimmed = text.trim().replace(",", ".");
  if (trimmed === "") return { number: 0, problem: isOptional ? undefined : "A number is needed." };
  const number = Number(trimmed);
  if (!Number.isFinite(number)) return { number: 0, problem: "This is no number." };
  if (number < min) return { number, problem: `At least ${min}.` };
  if (number > max) return { number, problem: `At most ${max}.` };
  return { number, problem: undefined };
}
