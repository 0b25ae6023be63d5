import { Choice } from "../../ui/controls/choice.tsx";
import { Button, IconButton, Switch } from "../../ui/controls/controls.tsx";
import type { Drawing, Transition } from "../session/protocol.ts";
import { useDesigner, useIsReadOnly } from "../session/use.ts";
import { isNoTrigger, kNoTrigger, triggerText, triggerWords } from "../states/trigger_words.ts";
import { Heading, SentText } from "./parts.tsx";
import { TriggerDetails } from "./trigger_details.tsx";

export function TransitionDetails({ drawing, transition }: { drawing: Drawing; transition: Transition }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const page = drawing.page?.path ?? "";
  const { from, index } = transition;
  const siblings = drawing.transitions.filter((one) => one.from === from).length;
  const set = (name: string, value: { to?: string; trigger?: string; restarts?: boolean; newIndex?: number }) =>
    designer.edit(name, { case: "setTransition", value: { page, from, index, ...value } });
  const reorder = async (newIndex: number) => {
    const answer = await set(`order of the transitions of ${from}`, { newIndex });
    if (answer.ok) designer.select([`${from}/${newIndex}`]);
  };
  return (
    <div className="details">
      <Heading name={`${from} → ${transition.to}`} kind="transition" help={transition.help} />
      <TriggerDetails transition={transition} />
      <SentText
        label="When"
        value={isNoTrigger(transition.trigger) ? "" : triggerWords(transition.trigger)}
        placeholder={kNoTrigger}
        isCode
        rows={2}
        send={(typed) => void set(`trigger of ${from}`, { trigger: triggerText(typed) })}
      />
      <Choice
        label="To"
        value={transition.to}
        choices={drawing.states.map((state) => [state.name, state.name])}
        isDisabled={isReadOnly}
        onChange={(to) => void set(`lead ${from} to ${to}`, { to })}
      />
      <Switch
        label="Starts the state anew"
        value={transition.restarts}
        isDisabled={isReadOnly}
        onChange={(restarts) => void set(restarts ? "restart" : "no restart", { restarts })}
      />
      {siblings > 1 && (
        <div className="columns spread">
          <span className="small">
            Asked as number {index + 1} of {siblings}
          </span>
          <span>
            <IconButton
              icon="minus"
              label="Ask earlier"
              isDisabled={isReadOnly || index === 0}
              onPress={() => void reorder(index - 1)}
            />
            <IconButton
              icon="plus"
              label="Ask later"
              isDisabled={isReadOnly || index === siblings - 1}
              onPress={() => void reorder(index + 1)}
            />
          </span>
        </div>
      )}
      {!isReadOnly && (
        <Button
          icon="close"
          onPress={() => void designer.edit("", { case: "removeTransition", value: { page, from, index } })}
        >
          Remove
        </Button>
      )}
    </div>
  );
}
