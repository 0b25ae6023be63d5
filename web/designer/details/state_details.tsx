import { Button, IconButton, Switch } from "../../ui/controls/controls.tsx";
import { drawnAt } from "../names/at.ts";
import { renameNow } from "../names/rename.ts";
import type { Drawing, State } from "../session/protocol.ts";
import { useDesigner, useIsReadOnly } from "../session/use.ts";
import { transitionId } from "../states/flow.ts";
import { triggerWords } from "../states/trigger_words.ts";
import { Heading, Section, SentField, SentText } from "./parts.tsx";

export function StateDetails({ drawing, state }: { drawing: Drawing; state: State }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const page = drawing.page?.path ?? "";
  const set = (name: string, value: { isStart?: boolean; isFinal?: boolean; member?: string }) =>
    void designer.edit(name, { case: "setState", value: { page, state: state.name, ...value } });
  return (
    <div className="details">
      <Heading name={state.name} kind="state" />
      <SentField
        label="Name"
        value={state.name}
        send={(name) => void renameNow(designer, drawnAt(designer, state.name), name, () => {})}
      />
      <SentText
        label="What the robot does in it"
        value={state.member}
        isCode
        rows={2}
        send={(member) => set(`change what ${state.name} does`, { member })}
      />
      <StateButtons state={state} />
      <div>
        <Switch
          label="The start state"
          value={state.isStart}
          isDisabled={isReadOnly || state.isStart}
          onChange={() => set(`start with ${state.name}`, { isStart: true })}
        />
        <Switch
          label="Final: no way out on purpose"
          value={state.isFinal}
          isDisabled={isReadOnly}
          onChange={(isFinal) => set(isFinal ? `${state.name} is final` : `${state.name} is not final`, { isFinal })}
        />
      </div>
      <WaysOut drawing={drawing} state={state} />
    </div>
  );
}

function StateButtons({ state }: { state: State }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  return (
    <div className="columns" style={{ gap: 4 }}>
      {state.calls && (
        <Button icon="right" onPress={() => designer.navigation.enter(state.calls!)}>
          Look inside
        </Button>
      )}
      {state.inner && (
        <Button icon="draw" onPress={() => designer.navigation.enter(state.inner!)}>
          As a drawing
        </Button>
      )}
      {!isReadOnly && (
        <Button
          onPress={() => designer.store.setState({ dialog: "place", placing: { x: 0, y: 0, replace: state.name } })}
        >
          Replace…
        </Button>
      )}
    </div>
  );
}

/** Its transitions to other states, or back to itself. */
function WaysOut({ drawing, state }: { drawing: Drawing; state: State }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const out = drawing.transitions.filter((one) => one.from === state.name).sort((a, b) => a.index - b.index);
  return (
    <Section
      title="Transitions, in the order in which they are asked"
      tools={
        !isReadOnly && (
          <IconButton
            icon="plus"
            label="Add a transition"
            onPress={() => designer.store.setState({ dialog: "connect", subject: state.name })}
          />
        )
      }
    >
      {out.length === 0 && <p className="small muted">It has no way out{state.isFinal ? "." : " yet."}</p>}
      <ol className="transitions">
        {out.map((one) => (
          <li key={transitionId(one)}>
            <Button tone="link" onPress={() => designer.select([transitionId(one)])}>
              <span className="mono">{triggerWords(one.trigger) || "when?"}</span> → {one.to}
            </Button>
          </li>
        ))}
      </ol>
    </Section>
  );
}
