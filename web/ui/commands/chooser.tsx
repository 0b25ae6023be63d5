// A list to be searched by a few letters, in the middle of the page: components to place, inputs to connect, commands.
import { Fragment, type ReactNode, useRef, useState } from "react";
import { Dialog, Modal, ModalOverlay } from "react-aria-components";
import { Icon } from "../controls/icons.tsx";
import "./commands.css";

export interface Choice {
  id: string;
  label: string;
  detail?: string | undefined;
  tail?: string | undefined;
  /** The keys that do the same. */
  keys?: string | undefined;
  icon?: ReactNode;
  /** Said above the first of each. */
  group?: string | undefined;
  /** Why it can't be chosen. */
  blocked?: string | undefined;
}

interface ChooserProps<T extends Choice> {
  title: string;
  placeholder: string;
  /** What is found, the best first. */
  find: (query: string) => readonly T[];
  onChoose: (id: string, choice: T) => void;
  onClose: () => void;
  empty?: string;
  /** What is to be known of all that is found, below it. */
  note?: string;
  /** Told of every letter, where `find` has to ask somebody. */
  onQuery?: (query: string) => void;
}

const kMostShown = 80;

export function Chooser<T extends Choice>({
  title,
  placeholder,
  find,
  onChoose,
  onClose,
  empty = "Nothing is called that.",
  note = "",
  onQuery,
}: ChooserProps<T>) {
  const [query, setQuery] = useState("");
  const [at, setAt] = useState(0);
  const list = useRef<HTMLDivElement>(null);
  const choices = find(query).slice(0, kMostShown);
  const choose = (place: number) => {
    const choice = choices[place];
    if (!choice || choice.blocked) return;
    onClose();
    // After the dialog has given the focus back, so that what is done may move it.
    setTimeout(() => onChoose(choice.id, choice), 0);
  };
  const go = (place: number) => {
    const next = Math.max(0, Math.min(choices.length - 1, place));
    setAt(next);
    list.current?.querySelector(`#choice-${next}`)?.scrollIntoView({ block: "nearest" });
  };
  const keys: Record<string, () => void> = {
    ArrowDown: () => go(at + 1),
    ArrowUp: () => go(at - 1),
    PageDown: () => go(at + 8),
    PageUp: () => go(at - 8),
    Enter: () => choose(at),
  };
  return (
    <ModalOverlay className="scrim" isOpen isDismissable onOpenChange={(open) => !open && onClose()}>
      <Modal className="dialog">
        <Dialog aria-label={title}>
          <div className="palette-field">
            <Icon name="search" />
            <input
              autoFocus
              role="combobox"
              aria-label={title}
              aria-expanded="true"
              aria-controls="chooser-list"
              aria-activedescendant={choices[at] ? `choice-${at}` : undefined}
              placeholder={placeholder}
              value={query}
              onChange={(event) => {
                setQuery(event.target.value);
                onQuery?.(event.target.value);
                setAt(0);
              }}
              onKeyDown={(event) => {
                const act = keys[event.key];
                if (!act) return;
                event.preventDefault();
                act();
              }}
            />
            <kbd>Esc</kbd>
          </div>
          <div className="palette-list" id="chooser-list" role="listbox" aria-label={title} ref={list} tabIndex={-1}>
            {choices.map((choice, place) => (
              <Fragment key={choice.id}>
                {choice.group && choice.group !== choices[place - 1]?.group && (
                  <div className="palette-heading" role="presentation">
                    {choice.group}
                  </div>
                )}
                <ChoiceRow
                  choice={choice}
                  place={place}
                  isMarked={place === at}
                  onChoose={() => choose(place)}
                  onPoint={() => setAt(place)}
                />
              </Fragment>
            ))}
            {choices.length === 0 && <p className="empty">{empty}</p>}
            {note !== "" && <p className="notice hold small">{note}</p>}
          </div>
        </Dialog>
      </Modal>
    </ModalOverlay>
  );
}

interface ChoiceRowProps {
  choice: Choice;
  place: number;
  isMarked: boolean;
  onChoose: () => void;
  onPoint: () => void;
}

function ChoiceRow({ choice, place, isMarked, onChoose, onPoint }: ChoiceRowProps) {
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: keys go to the field, which holds the focus
    <div
      id={`choice-${place}`}
      role="option"
      tabIndex={-1}
      className="palette-item"
      aria-selected={isMarked}
      aria-disabled={choice.blocked !== undefined}
      onClick={onChoose}
      onMouseMove={onPoint}
    >
      {choice.icon ?? <span className="icon-room" />}
      <span className="grow choice-names">
        <span className="ellipsis">{choice.label}</span>
        {(choice.blocked || choice.detail) && (
          <span className="small muted ellipsis">{choice.blocked || choice.detail}</span>
        )}
      </span>
      {choice.tail && <span className="small muted">{choice.tail}</span>}
      {choice.keys && <kbd>{choice.keys}</kbd>}
    </div>
  );
}
