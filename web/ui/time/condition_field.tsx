// A field for a sentence that is true at some moments of a run, with examples to begin with.
import { Button as AriaButton, ComboBox, Input, ListBox, ListBoxItem, Popover, Text } from "react-aria-components";
import { Icon } from "../controls/icons.tsx";
import "./time.css";

interface ConditionProps {
  label: string;
  text: string;
  /** Conditions with what they say. */
  examples: readonly (readonly [string, string])[];
  /** Of the examples. */
  placement: "top start" | "bottom start";
  isDisabled?: boolean;
  /** Why it is not understood; empty: it is. */
  problem?: string;
  onText: (text: string) => void;
  onEnter: (text: string) => void;
}

export function ConditionField(props: ConditionProps) {
  const { label, text, examples, placement, isDisabled = false, problem = "", onText, onEnter } = props;
  return (
    <ComboBox
      className="field grow"
      aria-label={label}
      allowsCustomValue
      menuTrigger="focus"
      isDisabled={isDisabled}
      isInvalid={problem !== ""}
      inputValue={text}
      onInputChange={onText}
      defaultFilter={(one, typed) => one.toLowerCase().includes(typed.trim().toLowerCase())}
    >
      <div
        className="time-find-field"
        onKeyDownCapture={(event) => {
          // Enter on an example takes it into the field, the next one looks for it.
          const isChosen = (event.target as Element).getAttribute("aria-activedescendant");
          if (event.key === "Enter" && !isChosen) onEnter(text);
        }}
      >
        <Input className="input" placeholder={examples[0]?.[0] ?? ""} />
        <AriaButton className="button quiet square" aria-label="Examples">
          <Icon name="down" />
        </AriaButton>
      </div>
      {problem !== "" && (
        <Text slot="errorMessage" elementType="p" className="time-find-problem small" role="alert">
          {problem}
        </Text>
      )}
      <Popover className="popover" placement={placement}>
        <ListBox className="menu">
          {examples.map(([condition, says]) => (
            <ListBoxItem key={condition} id={condition} textValue={condition} className="menu-item">
              <span className="texts">
                <Text slot="label" className="mono">
                  {condition}
                </Text>
                <Text slot="description" className="small muted">
                  {says}
                </Text>
              </span>
            </ListBoxItem>
          ))}
        </ListBox>
      </Popover>
    </ComboBox>
  );
}
