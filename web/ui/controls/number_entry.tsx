// A number that is typed, and takes effect with Enter or on leaving the field.
import { readNumber } from "../words/read_number.ts";
import { Field } from "./controls.tsx";
import { useTyped } from "./typed.ts";

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
  const { typed: text, type, show } = useTyped(shown);
  const { number, problem } = readNumber(text, min, max, whenZero !== undefined);
  const commit = () => {
    if (problem !== undefined) return;
    show(text);
    if (text !== shown) onCommit(number);
  };
  return (
    <Field
      label={label}
      value={text}
      onChange={type}
      onCommit={commit}
      problem={problem}
      placeholder={whenZero ?? ""}
      isDisabled={isDisabled}
      inputMode="decimal"
    />
  );
}
