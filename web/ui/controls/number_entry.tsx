// A number that is typed, and takes effect with Enter or on leaving the field.
import { useEffect, useState } from "react";
import { Field } from "./controls.tsx";

interface Props {
  label: string;
  value: number;
  onCommit: (value: number) => void;
  min?: number;
  max?: number;
  /** Shown while the field is empty, which means 0. */
  whenZero?: string;
  isDisabled?: boolean;
}

export function NumberEntry({ label, value, onCommit, min, max, whenZero, isDisabled = false }: Props) {
  const shown = value === 0 && whenZero !== undefined ? "" : String(Math.round(value * 1000) / 1000);
  const [text, setText] = useState(shown);
  useEffect(() => setText(shown), [shown]);
  const { number, problem } = readNumber(text, min, max, whenZero !== undefined);
  const commit = () => {
    if (problem !== undefined) return;
    if (text !== shown) onCommit(number);
  };
  return (
    <Field
      label={label}
      value={text}
      onChange={setText}
      onCommit={commit}
      problem={problem}
      placeholder={whenZero ?? ""}
      isDisabled={isDisabled}
      inputMode="decimal"
    />
  );
}

function readNumber(
  text: string,
  min = Number.NEGATIVE_INFINITY,
  max = Number.POSITIVE_INFINITY,
  isOptional = false,
): { number: number; problem: string | undefined } {
  const trimmed = text.trim().replace(",", ".");
  if (trimmed === "") return { number: 0, problem: isOptional ? undefined : "A number is needed." };
  const number = Number(trimmed);
  if (!Number.isFinite(number)) return { number: 0, problem: "This is no number." };
  if (number < min) return { number, problem: `At least ${min}.` };
  if (number > max) return { number, problem: `At most ${max}.` };
  return { number, problem: undefined };
}
