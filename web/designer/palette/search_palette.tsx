// Type to find a component and place it: `/` or Space anywhere, or where a wire was let go.
import { useEffect, useMemo, useState } from "react";
import { Chooser } from "../../ui/commands/chooser.tsx";
import { toneOf } from "../drawing/form.ts";
import { lastPart } from "../session/pages.ts";
import { type Component, Drawing_Kind } from "../session/protocol.ts";
import { useDesigner, useDrawing, usePart } from "../session/use.ts";
import { NodeIcon } from "../views/icons.tsx";
import { firstSentence, isActuator, isForPage, matchingComponents } from "./groups.ts";
import { place } from "./place.ts";

const kNone: readonly Component[] = [];

export function SearchPalette() {
  const designer = useDesigner();
  const components = usePart((state) => state.palettes[state.document]?.components ?? kNone);
  const placing = usePart((state) => state.placing);
  const drawing = useDrawing();
  const fits = useFitting();
  const isElsewhere = placing?.page !== undefined && placing.page !== drawing?.page?.path;
  const isStates = !isElsewhere && drawing?.kind === Drawing_Kind.STATES;
  const isRobot = !isElsewhere && drawing?.kind === Drawing_Kind.ROBOT;
  const usable = useMemo(
    () =>
      components.filter(
        (one) => isForPage(one, isStates) && (isRobot || !isActuator(one)) && (fits === null || fits.has(one.name)),
      ),
    [components, isStates, isRobot, fits],
  );
  const title = placing?.replace
    ? `Replace ${placing.replace} by`
    : placing?.to
      ? `What drives ${placing.to.port} of ${isElsewhere ? lastPart(placing.to.node) : placing.to.node}?`
      : placing?.from
        ? `Where does ${placing.from} lead?`
        : "Place a component";
  return (
    <Chooser
      title={title}
      placeholder={`${title}…`.replace("?…", "?")}
      find={(query) =>
        matchingComponents(query, usable).map((one) => ({
          id: one.name,
          label: one.title || one.name,
          detail: firstSentence(one.help),
          tail: one.group,
          icon: (
            <span className={`node-icon tone-${toneOf(one.shape)}`}>
              <NodeIcon icon={one.icon} component={one.name} shape={one.shape} />
            </span>
          ),
        }))
      }
      onChoose={(name) => void place(designer, name, placing)}
      onClose={() => designer.store.setState({ dialog: "" })}
      empty={fits ? "Nothing of the library fits there." : "Nothing is called that."}
    />
  );
}

/** Names of what may drive the input that waits; null: anything may be placed. */
function useFitting(): ReadonlySet<string> | null {
  const designer = useDesigner();
  const to = usePart((state) => state.placing?.to);
  const on = usePart((state) => state.placing?.page);
  const [names, setNames] = useState<ReadonlySet<string> | null>(null);
  useEffect(() => {
    if (!to) return;
    let isCurrent = true;
    const { document, page } = designer.state;
    const asked = { document, page: on ?? page, toNode: to.node, toPort: to.port };
    void designer.link.ask({ case: "fits", value: asked }).then((answer) => {
      if (!isCurrent || answer.result.case !== "fits") return;
      setNames(new Set(answer.result.value.fits.filter((fit) => fit.reason === "").map((fit) => fit.node)));
    });
    return () => {
      isCurrent = false;
    };
  }, [designer, to, on]);
  return names;
}
