// What makes a transition: all that gives a truth value, by groups, found by a few letters.
import { useEffect, useMemo, useState } from "react";
import { Chooser } from "../../ui/commands/chooser.tsx";
import { toneOf } from "../drawing/form.ts";
import type { Designer } from "../session/designer.ts";
import { onceDrawn } from "../session/once_drawn.ts";
import { pageKey } from "../session/pages.ts";
import type { Component } from "../session/protocol.ts";
import type { TriggerChoice } from "../session/state.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { changeTrigger, joinedPart, termIn, termOf, triggerPage } from "../states/trigger.ts";
import { NodeIcon } from "../views/icons.tsx";
import { firstSentence, matchingComponents } from "./groups.ts";
import { triggerGroups } from "./trigger_groups.ts";

const kNone: readonly Component[] = [];

export function TriggerChooser() {
  const designer = useDesigner();
  const choice = usePart((state) => state.triggerChoice);
  const components = usePart((state) => state.palettes[state.document]?.components ?? kNone);
  const names = useTriggers(choice);
  const groups = useMemo(() => triggerGroups(components.filter((one) => names?.has(one.name))), [components, names]);
  if (!choice) return null;
  const title = titleOf(choice);
  const grouped = groups.flatMap((group) => group.components.map((one) => ({ one, group: group.name })));
  const list = (query: string) =>
    query.trim() === ""
      ? grouped
      : matchingComponents(
          query,
          grouped.map(({ one }) => one),
        ).map((one) => ({ one, group: "" }));
  return (
    <Chooser
      title={title}
      placeholder={`${title} Type to search`}
      find={(query) =>
        list(query).map(({ one, group }) => ({
          id: one.name,
          label: one.title || one.name,
          detail: firstSentence(one.help),
          group,
          tail: group === "" ? one.group : undefined,
          icon: (
            <span className={`node-icon tone-${toneOf(one.shape)}`}>
              <NodeIcon icon={one.icon} component={one.name} shape={one.shape} />
            </span>
          ),
        }))
      }
      onChoose={(name) => void choose(designer, choice, name)}
      onClose={() => designer.store.setState({ dialog: "" })}
      empty={names === null ? "Asking…" : "No trigger is called that."}
    />
  );
}

function titleOf({ from, how }: TriggerChoice): string {
  if (how === "and") return "And when?";
  return how === "or" ? "Or when?" : `When does ${from} end?`;
}

/** The choice made; what was chosen has the focus then, in its first field. */
async function choose(designer: Designer, choice: TriggerChoice, component: string): Promise<void> {
  const { document, page } = designer.state;
  const term = () => {
    const drawing = designer.state.drawings[pageKey(document, triggerPage(page, choice))];
    return drawing && termOf(drawing);
  };
  const { how } = choice;
  const part = how === "choose" ? choice.part : joinedPart(term(), choice.part, how);
  if (!(await changeTrigger(designer, choice, how, component))) return;
  designer.say(`When ${component}`);
  await onceDrawn(designer, () => (termIn(term(), part)?.node?.component === component ? true : undefined));
  requestAnimationFrame(() => focusTerm(part));
}

function focusTerm(part: readonly number[]): void {
  const isWanted = (term: HTMLElement) => term.dataset.part === part.join(".");
  const term = [...window.document.querySelectorAll<HTMLElement>(".trigger-term")].find(isWanted);
  (term?.querySelector<HTMLElement>(".inputs input") ?? term?.querySelector<HTMLElement>(".trigger-name"))?.focus();
}

/** Names of what may be asked; null: not known yet. */
function useTriggers(choice: TriggerChoice | null): ReadonlySet<string> | null {
  const designer = useDesigner();
  const [names, setNames] = useState<ReadonlySet<string> | null>(null);
  useEffect(() => {
    if (!choice) return;
    let isCurrent = true;
    const { document, page } = designer.state;
    const asked = { document, page: triggerPage(page, choice), toNode: "$result" };
    void designer.link.ask({ case: "fits", value: asked }).then((answer) => {
      if (!isCurrent) return;
      const fits = answer.result.case === "fits" ? answer.result.value.fits : [];
      const usable = fits.filter((fit) => fit.port === "component" && fit.reason === "");
      setNames(new Set(usable.map((fit) => fit.node)));
    });
    return () => {
      isCurrent = false;
    };
  }, [designer, choice]);
  return names;
}
