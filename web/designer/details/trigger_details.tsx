// What a transition asks, as a small tree: `and`, `or` and `not` with buttons, each question with its inputs as fields.
import { useEffect } from "react";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { lastPart, pageKey } from "../session/pages.ts";
import type { Drawing, Transition } from "../session/protocol.ts";
import { useDesigner, useIsReadOnly, usePart } from "../session/use.ts";
import { askTrigger, changeTrigger, suppliersOf, type Term, termOf, triggerPage } from "../states/trigger.ts";
import { isNoTrigger } from "../states/trigger_words.ts";
import { InputList } from "./input_list.tsx";
import { Section } from "./parts.tsx";

/** Drawn anew when the trigger changes. */
function useTriggerDrawing(transition: Transition): Drawing | undefined {
  const designer = useDesigner();
  const path = usePart((state) => triggerPage(state.page, transition));
  useEffect(() => {
    designer.navigation.lookBeside(path);
    return () => designer.navigation.lookBeside("");
  }, [designer, path]);
  return usePart((state) => state.drawings[pageKey(state.document, path)]);
}

export function TriggerDetails({ transition }: { transition: Transition }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const drawing = useTriggerDrawing(transition);
  const alone: Term = { part: [], text: transition.trigger, terms: [] };
  const term = drawing && (termOf(drawing) ?? alone);
  const { from, index } = transition;
  if (isNoTrigger(transition.trigger)) {
    return (
      <Section title="Trigger">
        <p className="small muted">No trigger yet: this transition is never made.</p>
        {!isReadOnly && (
          <Button
            tone="primary"
            className="trigger-choose"
            onPress={() => askTrigger(designer, { from, index, part: [], how: "choose" })}
          >
            Choose a trigger…
          </Button>
        )}
      </Section>
    );
  }
  if (!drawing || !term) return null;
  return (
    <Section title="Trigger">
      <TermView drawing={drawing} transition={transition} term={term} />
      {!isReadOnly && <Joining transition={transition} term={term} />}
    </Section>
  );
}

interface TermProps {
  drawing: Drawing;
  transition: Transition;
  term: Term;
}

function TermView(props: TermProps) {
  const { term } = props;
  if (term.node?.component === "not" && term.terms[0]) return <Negation {...props} inner={term.terms[0]} />;
  return term.terms.length > 0 ? <Joined {...props} /> : <Question {...props} />;
}

function Negation({ inner, ...props }: TermProps & { inner: Term }) {
  return (
    <fieldset className="trigger-group" aria-label="not">
      <div className="trigger-head">
        <b className="trigger-word">not</b>
        <TermButtons {...props} name="not" />
      </div>
      <TermView {...props} term={inner} />
    </fieldset>
  );
}

/** Terms of which all have to be true, or one. */
function Joined({ drawing, transition, term }: TermProps) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const isAnd = term.node?.component === "and";
  const words = isAnd ? "all of these" : "one of these";
  const { from, index } = transition;
  return (
    <fieldset className="trigger-group" aria-label={words}>
      <div className="trigger-head">
        <Button
          tone="link"
          isDisabled={isReadOnly}
          aria-label={`${words}: change to ${isAnd ? "or" : "and"}`}
          onPress={() => void changeTrigger(designer, { from, index, part: term.part }, "switch")}
        >
          {words}
        </Button>
        <TermButtons transition={transition} term={term} name={words} />
      </div>
      {term.terms.map((one) => (
        <TermView key={one.part.join(".")} drawing={drawing} transition={transition} term={one} />
      ))}
    </fieldset>
  );
}

/** One component that gives a truth value, its inputs, and what gives it some of them. */
function Question({ drawing, transition, term }: TermProps) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const { from, index } = transition;
  const { node, part } = term;
  const help = usePart(
    (state) => state.palettes[state.document]?.components.find((one) => one.name === node?.component)?.help ?? "",
  );
  const name = node ? node.component || lastPart(node.name) : term.text;
  return (
    <div className="trigger-term" data-part={part.join(".")}>
      <div className="trigger-head">
        <Button
          className="trigger-name"
          isDisabled={isReadOnly}
          aria-label={`${name}: choose another trigger`}
          onPress={() => askTrigger(designer, { from, index, part, how: "choose" })}
        >
          {name}
        </Button>
        <TermButtons transition={transition} term={term} name={name} />
      </div>
      {help !== "" && <p className="small muted">{help}</p>}
      {node && node.inputs.length > 0 && <InputList drawing={drawing} node={node} />}
      {node &&
        suppliersOf(drawing, node)
          .filter((one) => one.inputs.length > 0)
          .map((one) => (
            <fieldset key={one.name} className="trigger-supplier" aria-label={lastPart(one.name)}>
              <b className="small">{lastPart(one.name)}</b>
              <InputList drawing={drawing} node={one} />
            </fieldset>
          ))}
    </div>
  );
}

function TermButtons({ transition, term, name }: { transition: Transition; term: Term; name: string }) {
  const designer = useDesigner();
  if (useIsReadOnly()) return null;
  const part = { from: transition.from, index: transition.index, part: term.part };
  const isNot = term.node?.component === "not";
  const isInner = term.part.length > 0; // beside the whole are larger ones
  return (
    <span className="trigger-tools">
      {isInner &&
        (["and", "or"] as const).map((how) => (
          <Button
            key={how}
            tone="quiet"
            aria-label={`${name} ${how} another trigger`}
            onPress={() => askTrigger(designer, { ...part, how })}
          >
            {how}…
          </Button>
        ))}
      {!isNot && (
        <Button tone="quiet" aria-label={`not ${name}`} onPress={() => void changeTrigger(designer, part, "not")}>
          not
        </Button>
      )}
      <IconButton
        icon="close"
        label={isNot ? "Take the “not” away" : `Remove ${name}`}
        onPress={() => void changeTrigger(designer, part, isNot ? "not" : "remove")}
      />
    </span>
  );
}

/** One more, beside the whole. */
function Joining({ transition, term }: { transition: Transition; term: Term }) {
  const designer = useDesigner();
  const { from, index } = transition;
  const ask = (how: "and" | "or") => askTrigger(designer, { from, index, part: term.part, how });
  return (
    <div className="columns trigger-joining">
      <Button icon="plus" aria-label="And another trigger" onPress={() => ask("and")}>
        and…
      </Button>
      <Button icon="plus" aria-label="Or another trigger" onPress={() => ask("or")}>
        or…
      </Button>
    </div>
  );
}
