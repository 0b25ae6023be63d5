// A breakpoint in words: the same sentences as moments are found by, with the same examples.
import { useRef, useState } from "react";
import { Button } from "../../ui/controls/controls.tsx";
import { ConditionField } from "../../ui/time/condition_field.tsx";
import { readableMessage } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { useExamples } from "../time/use_examples.ts";
import "./breakpoints.css";

interface SentenceFieldProps {
  isDisabled?: boolean;
  /** @returns why it is not taken; empty: it is set */
  onSet: (condition: string) => Promise<string>;
}

export function SentenceField({ isDisabled = false, onSet }: SentenceFieldProps) {
  const [text, setText] = useState("");
  const [problem, setProblem] = useState("");
  const examples = useExamples();
  const box = useRef<HTMLDivElement>(null);
  const set = async () => {
    if (text.trim() === "") return;
    const why = await onSet(text.trim());
    setProblem(why);
    if (why !== "") return;
    // In the field it would open the examples over the list, for a text that has changed.
    box.current?.querySelector<HTMLElement>(":scope > button")?.focus();
    setText("");
  };
  return (
    <div className="break-sentence" ref={box}>
      <ConditionField
        label="Pause when"
        text={text}
        examples={examples}
        placement="bottom start"
        isDisabled={isDisabled}
        problem={problem === "" ? "" : sentence(readableMessage(problem))}
        onText={(typed) => {
          setText(typed);
          setProblem("");
        }}
        onEnter={() => void set()}
      />
      <Button isDisabled={isDisabled} onPress={() => void set()}>
        Set
      </Button>
    </div>
  );
}
