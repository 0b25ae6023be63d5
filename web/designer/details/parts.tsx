// Fields that send what is typed in them when they are left, and headings: the same in all details.
import { type ReactNode, useEffect, useId, useRef } from "react";
import { Field } from "../../ui/controls/controls.tsx";
import { useTyped } from "../../ui/controls/typed.ts";
import { useIsReadOnly } from "../session/use.ts";

interface SentFieldProps {
  label: string;
  value: string;
  /** Gives false where it is refused: then the field shows again what is. */
  send: (value: string) => unknown;
  help?: string;
  placeholder?: string;
  isDisabled?: boolean;
  hiddenLabel?: boolean;
}

/** One line; sent by Enter or by leaving it, where it is another one than before. Escape takes back what was typed. */
export function SentField({ value, send, isDisabled, ...rest }: SentFieldProps) {
  const isReadOnly = useIsReadOnly();
  const { typed, type, show } = useTyped(value);
  const sent = async (next: string) => {
    show(next);
    if ((await send(next)) === false) show(value);
  };
  return (
    <Field
      {...rest}
      value={typed}
      committed={value}
      onChange={type}
      onCommit={(next) => (next.trim() === value ? show(value) : void sent(next.trim()))}
      isDisabled={isReadOnly || (isDisabled ?? false)}
    />
  );
}

/** Several lines; sent by leaving it, as Ctrl Enter does. Escape takes back what was typed. */
export function SentText({
  label,
  value,
  send,
  rows = 3,
  isCode = false,
  placeholder,
}: {
  label: string;
  value: string;
  send: (value: string) => void;
  rows?: number;
  isCode?: boolean;
  placeholder?: string;
}) {
  const isReadOnly = useIsReadOnly();
  const id = useId();
  const { typed, type, show } = useTyped(value);
  const sent = (next: string) => {
    show(next);
    if (next !== value) send(next);
  };
  return (
    <div className="field">
      <label htmlFor={id}>{label}</label>
      <textarea
        id={id}
        className={`input area ${isCode ? "mono" : ""}`}
        rows={Math.max(rows, Math.min(10, typed.split("\n").length))}
        value={typed}
        placeholder={placeholder}
        disabled={isReadOnly}
        onChange={(event) => type(event.target.value)}
        onBlur={() => sent(typed.trim())}
        onKeyDown={(event) => {
          if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) event.currentTarget.blur();
          if (event.key !== "Escape") return;
          show(value);
          event.stopPropagation();
        }}
      />
    </div>
  );
}

export function Section({ title, children, tools }: { title: string; children: ReactNode; tools?: ReactNode }) {
  return (
    <section className="details-section" aria-label={title}>
      <header>
        <h3>{title}</h3>
        {tools}
      </header>
      {children}
    </section>
  );
}

/** As the text shows it under the pointer; what reads Markdown comes when it is needed, the words are there at once. */
function Help({ markdown }: { markdown: string }) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    let isGone = false;
    void import("../text/help.ts").then(({ helpElement }) => {
      if (!isGone) host.current?.replaceChildren(helpElement(markdown, window.document));
    });
    return () => {
      isGone = true;
    };
  }, [markdown]);
  // A new one for other words: React must not meet what was put in its place.
  return (
    <div key={markdown} ref={host} className="small details-help">
      {markdown}
    </div>
  );
}

export function Heading({ name, kind, help }: { name: string; kind: string; help?: string }) {
  return (
    <header className="details-head">
      <h2 className="ellipsis">{name}</h2>
      <span className="small muted">{kind}</span>
      {help && <Help markdown={help} />}
    </header>
  );
}
