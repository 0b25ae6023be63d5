// A number that is typed, and takes effect with Enter or on leaving the field.
import { useEffect, useState } from "react";
import { readNumber } from "../words/read_number.ts";
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
