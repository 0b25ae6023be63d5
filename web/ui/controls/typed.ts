// What stands in a field while somebody types in it.
import { useEffect, useRef, useState } from "react";

export interface Typed {
  typed: string;
  /** By who types: it stays until it is sent, whatever becomes of the value meanwhile. */
  type: (text: string) => void;
  /** By anything else: the value's next change takes its place. */
  show: (text: string) => void;
}

/** The value's text, until somebody types another one. `type` of the text that is shown, or `show`, ends that. */
export function useTyped(value: string): Typed {
  const [typed, setTyped] = useState(value);
  const isTyping = useRef(false);
  useEffect(() => {
    if (!isTyping.current) setTyped(value);
  }, [value]);
  return {
    typed,
    type: (text) => {
      isTyping.current = text !== value;
      setTyped(text);
    },
    show: (text) => {
      isTyping.current = false;
      setTyped(text);
    },
  };
}
