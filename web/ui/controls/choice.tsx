// One of several, in a list that opens.
import {
  Button as AriaButton,
  Label,
  ListBox,
  ListBoxItem,
  Popover,
  Select,
  SelectValue,
  Text,
} from "react-aria-components";
import { Icon } from "./icons.tsx";

interface ChoiceProps {
  label: string;
  value: string;
  /** Id, text, and what is said below it. */
  choices: readonly (readonly [string, string, string?])[];
  onChange: (value: string) => void;
  isDisabled?: boolean;
  hiddenLabel?: boolean;
}

export function Choice({ label, value, choices, onChange, isDisabled = false, hiddenLabel = false }: ChoiceProps) {
  return (
    <Select
      className="field"
      selectedKey={value}
      onSelectionChange={(key) => key !== value && key !== null && onChange(String(key))}
      isDisabled={isDisabled}
      placeholder="–"
      {...(hiddenLabel ? { "aria-label": label } : {})}
    >
      {!hiddenLabel && <Label>{label}</Label>}
      <AriaButton className="button choice">
        <SelectValue className="ellipsis grow">
          {({ selectedText, defaultChildren }) => selectedText || defaultChildren}
        </SelectValue>
        <Icon name="down" />
      </AriaButton>
      <Popover className="popover">
        <ListBox className="menu">
          {choices.map(([id, text, detail]) => (
            <ListBoxItem key={id} id={id} className="menu-item" textValue={text}>
              <span className="texts">
                <Text slot="label">{text}</Text>
                {detail && (
                  <Text slot="description" className="small muted">
                    {detail}
                  </Text>
                )}
              </span>
            </ListBoxItem>
          ))}
        </ListBox>
      </Popover>
    </Select>
  );
}
