// The controls of the whole console: react-aria's behaviour, our looks.
import { type ReactNode, useEffect, useRef } from "react";
import {
  Button as AriaButton,
  type ButtonProps as AriaButtonProps,
  Switch as AriaSwitch,
  Input,
  Label,
  SearchField,
  Slider,
  SliderOutput,
  SliderThumb,
  SliderTrack,
  Text,
  TextField,
  ToggleButton,
  ToggleButtonGroup,
  Tooltip,
  TooltipTrigger,
} from "react-aria-components";
import { Icon, type IconName } from "./icons.tsx";

type Tone = "plain" | "quiet" | "primary" | "go" | "danger" | "link";

export interface ButtonProps extends Omit<AriaButtonProps, "className" | "children"> {
  tone?: Tone;
  icon?: IconName;
  className?: string;
  children?: ReactNode;
}

export function Button({ tone = "plain", icon, className = "", children, ...rest }: ButtonProps) {
  return (
    <AriaButton {...rest} className={`button ${tone} ${className}`}>
      {icon && <Icon name={icon} />}
      {children}
    </AriaButton>
  );
}

export interface IconButtonProps extends Omit<AriaButtonProps, "className" | "children"> {
  icon: IconName;
  label: string;
  /** Shown in the tooltip. */
  shortcut?: string;
  pressed?: boolean;
  className?: string;
}

/** Says what it does when pointed at or focused. */
export function IconButton({ icon, label, shortcut, pressed, className = "", ...rest }: IconButtonProps) {
  return (
    <Hint text={label} shortcut={shortcut}>
      <AriaButton
        {...rest}
        aria-label={label}
        {...(pressed === undefined ? {} : { "aria-pressed": pressed })}
        className={`button quiet square ${className}`}
      >
        <Icon name={icon} />
      </AriaButton>
    </Hint>
  );
}

export function Hint({ text, shortcut, children }: { text: ReactNode; shortcut?: string; children: ReactNode }) {
  return (
    <TooltipTrigger delay={500} closeDelay={50}>
      {children}
      <Tooltip className="tooltip" offset={6}>
        {text}
        {shortcut && <kbd>{shortcut}</kbd>}
      </Tooltip>
    </TooltipTrigger>
  );
}

interface SwitchProps {
  label: ReactNode;
  value: boolean;
  onChange: (value: boolean) => void;
  isDisabled?: boolean;
}

export function Switch({ label, value, onChange, isDisabled = false }: SwitchProps) {
  return (
    <AriaSwitch className="switch" isSelected={value} onChange={onChange} isDisabled={isDisabled}>
      <span className="track" />
      <span>{label}</span>
    </AriaSwitch>
  );
}

interface SegmentsProps<Value extends string> {
  label: string;
  value: Value;
  choices: readonly (readonly [Value, string])[];
  onChange: (value: Value) => void;
  isDisabled?: boolean;
  /** Those that can't be chosen now; who disables some says beside them why. */
  disabled?: readonly Value[];
}

/** One of a few, all of them in sight. */
export function Segments<Value extends string>(props: SegmentsProps<Value>) {
  const { label, value, choices, onChange, isDisabled, disabled = [] } = props;
  return (
    <ToggleButtonGroup
      className="segments"
      aria-label={label}
      selectionMode="single"
      disallowEmptySelection
      isDisabled={isDisabled ?? false}
      selectedKeys={[value]}
      onSelectionChange={(keys) => {
        const [key] = keys;
        if (key !== undefined) onChange(key as Value);
      }}
    >
      {choices.map(([id, text]) => (
        <ToggleButton key={id} id={id} className="button" isDisabled={disabled.includes(id)}>
          {text}
        </ToggleButton>
      ))}
    </ToggleButtonGroup>
  );
}

interface FieldProps {
  label: string;
  value: string;
  onChange: (value: string) => void;
  /** Enter, or leaving the field. */
  onCommit?: (value: string) => void;
  /** Enter alone. */
  onEnter?: () => void;
  onFocus?: () => void;
  onBlur?: () => void;
  problem?: string | undefined;
  help?: string;
  hiddenLabel?: boolean;
  placeholder?: string;
  isDisabled?: boolean;
  autoFocus?: boolean;
  inputMode?: "decimal" | "numeric" | "text";
  /** What Escape brings back; without it, what stood there when the field was entered or last sent. */
  committed?: string;
}

export function Field(props: FieldProps) {
  const { label, value, problem, help, onCommit } = props;
  const entered = useRef(value);
  return (
    <TextField
      className="field"
      value={value}
      onChange={props.onChange}
      onFocus={() => {
        entered.current = value;
        props.onFocus?.();
      }}
      isInvalid={problem !== undefined}
      isDisabled={props.isDisabled ?? false}
      autoFocus={props.autoFocus ?? false}
      {...(props.hiddenLabel ? { "aria-label": label } : {})}
      onBlur={() => {
        onCommit?.(value);
        props.onBlur?.();
      }}
      onKeyDown={(event) => {
        if (event.key === "Enter") {
          onCommit?.(value);
          entered.current = value;
          props.onEnter?.();
        }
        if (event.key !== "Escape") return;
        // A dialog is left by Escape from its fields, too.
        if ((event.target as Element).closest("[role=dialog]")) event.continuePropagation();
        else props.onChange(props.committed ?? entered.current);
      }}
    >
      {!props.hiddenLabel && <Label>{label}</Label>}
      <Input className="input" placeholder={props.placeholder ?? ""} inputMode={props.inputMode ?? "text"} />
      {help && !problem && (
        <Text slot="description" className="help">
          {help}
        </Text>
      )}
      {problem && (
        <Text slot="errorMessage" className="problem">
          {problem}
        </Text>
      )}
    </TextField>
  );
}

interface SearchProps {
  label: string;
  value: string;
  onChange: (value: string) => void;
  autoFocus?: boolean;
}

export function Search({ label, value, onChange, autoFocus = false }: SearchProps) {
  return (
    <SearchField className="search grow" aria-label={label} value={value} onChange={onChange} autoFocus={autoFocus}>
      <Icon name="search" />
      <Input className="input" placeholder={label} />
    </SearchField>
  );
}

interface RangeProps {
  label: string;
  value: number;
  min: number;
  max: number;
  step: number;
  onChange: (value: number) => void;
  onCommit?: (value: number) => void;
  shown?: string;
  /** What is said in place of the number, where the slider's places are not the values. */
  spoken?: string;
  hiddenLabel?: boolean;
  isDisabled?: boolean;
}

export function RangeSlider(props: RangeProps) {
  const { label, value, min, max, step, shown } = props;
  const span = max - min;
  const track = useRef<HTMLDivElement>(null);
  useEffect(() => {
    // react-aria names a thumb by its number
    const field = track.current?.querySelector("input");
    if (field && props.spoken !== undefined) field.setAttribute("aria-valuetext", props.spoken);
  });
  return (
    <Slider
      className="slider"
      value={Math.min(max, Math.max(min, value))}
      minValue={min}
      maxValue={max}
      step={step}
      isDisabled={props.isDisabled ?? false}
      onChange={(next) => props.onChange(next as number)}
      onChangeEnd={(next) => props.onCommit?.(next as number)}
      {...(props.hiddenLabel ? { "aria-label": label } : {})}
    >
      {!props.hiddenLabel && <Label className="label">{label}</Label>}
      {!props.hiddenLabel && <SliderOutput className="number small">{shown ?? value}</SliderOutput>}
      <SliderTrack className="groove" ref={track}>
        <div className="fill" style={{ width: `${span > 0 ? (100 * (value - min)) / span : 0}%` }} />
        <SliderThumb className="thumb" aria-label={props.hiddenLabel ? label : undefined} />
      </SliderTrack>
    </Slider>
  );
}

/** A share of 0 to 1, as a bar; the words beside it say it to who can't see it. */
export function Bar({ share, tone }: { share: number; tone?: string }) {
  const width = `${Math.round(100 * Math.min(1, Math.max(0, share)))}%`;
  return (
    <div className="meter" aria-hidden="true">
      <div style={tone ? { width, background: tone } : { width }} />
    </div>
  );
}
