// What a device serves and by what: binding points, then all that the library has, and why the rest does not fit.
import { useEffect, useState } from "react";
import { type Choice, Chooser } from "../../ui/commands/chooser.tsx";
import { ranked } from "../../ui/commands/search.ts";
import { toneOf } from "../drawing/form.ts";
import type { Designer } from "../session/designer.ts";
import { onceDrawn } from "../session/once_drawn.ts";
import type { Component, FitList_Fit } from "../session/protocol.ts";
import type { DeviceChoice } from "../session/state.ts";
import { useDesigner, useDrawing, usePart } from "../session/use.ts";
import { NodeIcon } from "../views/icons.tsx";
import { firstSentence, matchingComponents } from "./groups.ts";
import { showNode } from "./place.ts";

const kNone: readonly Component[] = [];

/** Opens the list of what may serve a binding point; without one, of the binding points. */
export function askDevice(designer: Designer, deviceChoice: DeviceChoice): void {
  designer.store.setState({ dialog: "device", deviceChoice });
}

export function DeviceChooser() {
  const choice = usePart((state) => state.deviceChoice);
  if (!choice) return null;
  return choice.binds === "" ? <PointChooser choice={choice} /> : <ServerChooser choice={choice} />;
}

function PointChooser({ choice }: { choice: DeviceChoice }) {
  const designer = useDesigner();
  const points = useDrawing()?.equipment?.points ?? [];
  const all: Choice[] = points
    .map(({ name, help, isServed, askedBy }) => ({
      id: name,
      label: name,
      detail: firstSentence(help),
      group: isServed ? "Served already" : askedBy.length > 0 ? "Needed, and not served yet" : "Not served yet",
      tail: askedBy.length > 0 ? `for ${askedBy.slice(0, 2).join(", ")}` : undefined,
    }))
    .sort((a, b) => rankOf(a.group) - rankOf(b.group));
  return (
    <Chooser
      title="What does the device serve?"
      placeholder="What does the device serve? Type to search"
      find={(query) => (query.trim() === "" ? all : ranked(query, all, (one) => `${one.label} ${one.detail}`))}
      onChoose={(binds) => askDevice(designer, { ...choice, binds })}
      onClose={() => designer.store.setState({ dialog: "" })}
      empty="No binding point is called that."
    />
  );
}

function rankOf(group: string): number {
  return ["Needed, and not served yet", "Not served yet"].indexOf(group) + (group === "Served already" ? 3 : 0);
}

function ServerChooser({ choice }: { choice: DeviceChoice }) {
  const designer = useDesigner();
  const components = usePart((state) => state.palettes[state.document]?.components ?? kNone);
  const fits = useServers(choice);
  const reasons = new Map(fits?.map((fit) => [fit.node, fit.reason]));
  const usable = components.filter((one) => reasons.get(one.name) === "");
  const others = components.filter((one) => reasons.get(one.name));
  const title = `What serves ${choice.binds}?`;
  const list = (query: string) => [...matchingComponents(query, usable), ...matchingComponents(query, others)];
  return (
    <Chooser
      title={title}
      placeholder={`${title} Type to search`}
      find={(query) =>
        list(query).map((one) => ({
          id: one.name,
          label: one.title || one.name,
          detail: firstSentence(one.help),
          group: reasons.get(one.name) === "" ? "Fits" : "Does not fit",
          tail: one.group,
          blocked: reasons.get(one.name) || undefined,
          icon: (
            <span className={`node-icon tone-${toneOf(one.shape)}`}>
              <NodeIcon icon={one.icon} component={one.name} shape={one.shape} />
            </span>
          ),
        }))
      }
      onChoose={(component) => void choose(designer, choice, component)}
      onClose={() => designer.store.setState({ dialog: "" })}
      empty={fits === null ? "Asking…" : "Nothing of the library is called that."}
    />
  );
}

/** What was chosen is selected, where it is drawn. */
async function choose(designer: Designer, choice: DeviceChoice, component: string): Promise<void> {
  const { owner, device, binds } = choice;
  const before = new Set(designer.drawing?.equipment?.devices.map(({ name }) => name));
  const answer = await designer.edit(device === "" ? `add ${component} for ${binds}` : `change ${device}`, {
    case: "setDevice",
    value: { owner, device, binds, component },
  });
  if (!answer.ok) return;
  designer.say(`${component} serves ${binds}`);
  if (device !== "" || designer.state.page !== owner) return;
  const made = await onceDrawn(
    designer,
    () => designer.drawing?.equipment?.devices.find(({ name }) => !before.has(name))?.name,
  );
  if (!made) return;
  designer.select([made]);
  showNode(designer, made);
}

/** Of everything whether it can serve the binding point; null: not known yet. */
function useServers({ owner, binds }: DeviceChoice): readonly FitList_Fit[] | null {
  const designer = useDesigner();
  const [fits, setFits] = useState<readonly FitList_Fit[] | null>(null);
  useEffect(() => {
    let isCurrent = true;
    const { document } = designer.state;
    void designer.link.ask({ case: "fits", value: { document, page: owner, toPort: binds } }).then((answer) => {
      if (isCurrent) setFits(answer.result.case === "fits" ? answer.result.value.fits : []);
    });
    return () => {
      isCurrent = false;
    };
  }, [designer, owner, binds]);
  return fits;
}
